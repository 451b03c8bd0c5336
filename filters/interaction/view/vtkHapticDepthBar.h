// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticDepthBar_h
#define vtkHapticDepthBar_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

class vtkActor2D;
class vtkPoints;
class vtkRenderer;

/// A bar at the left edge of a view with a handle at the depth of a hand: below it is near, above it is far.
class vtkHapticDepthBar
{
public:
  vtkHapticDepthBar();
  ~vtkHapticDepthBar();
  vtkHapticDepthBar(const vtkHapticDepthBar&) = delete;
  vtkHapticDepthBar& operator=(const vtkHapticDepthBar&) = delete;

  /// Hidden there at first; null: nowhere.
  void SetRenderer(vtkRenderer* renderer);

  /// The handle at this share of the bar, from 0 to 1.
  void Show(double share);
  void Hide();

  ///@{
  /// Of a place on the screen [pixels from the lower left corner of the window]: whether it is on the bar that is seen,
  /// and the share of the bar, from 0 to 1.
  bool IsAt(double x_px, double y_px) const;
  double ShareAt(double y_px) const;
  ///@}

private:
  double Low() const;
  double Height() const;

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkNew<vtkActor2D> Bar, Handle;
  vtkNew<vtkPoints> BarCorners, HandleCorners;
};

#endif
