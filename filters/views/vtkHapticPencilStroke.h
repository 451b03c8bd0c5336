// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPencilStroke_h
#define vtkHapticPencilStroke_h

#include <vector>

#include "haptics/core/Types.h"

class vtkRenderer;

/// The way of a pointer over a renderer, as points in a plane.
class vtkHapticPencilStroke
{
public:
  vtkHapticPencilStroke() = default;
  /// Through point_W, across normal_W.
  vtkHapticPencilStroke(const palpate::Vec3& point_W, const palpate::Vec3& normal_W);
  /// Through the camera's focal point, parallel to the screen.
  static vtkHapticPencilStroke OnScreen(vtkRenderer* renderer);

  /// The point under a place of the window [pixels]. False if it is nearer than two pixels to the last one, or the
  /// plane is seen as a line there or lies behind the eye: nothing is added then.
  bool Add(vtkRenderer* renderer, double x, double y);
  /// Leaves out points as long as the line stays within a pixel of where it was drawn.
  void Simplify();

  const std::vector<palpate::Vec3>& GetPoints() const { return this->Points_W; }

private:
  palpate::Vec3 Origin_W = palpate::Vec3::Zero();
  palpate::Vec3 Normal_W = palpate::Vec3::UnitZ();
  std::vector<palpate::Vec3> Points_W;
  double LastX = 0.0;
  double LastY = 0.0;
  double Pixel_u = 0.0; ///< size of a pixel where the stroke began
};

#endif
