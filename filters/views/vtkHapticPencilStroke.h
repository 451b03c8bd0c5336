// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPencilStroke_h
#define vtkHapticPencilStroke_h

#include <vector>

#include "vtkHapticPencilGround.h"

/// The path of a pointer over a renderer, as points of a ground.
class vtkHapticPencilStroke
{
public:
  vtkHapticPencilStroke() = default;
  explicit vtkHapticPencilStroke(vtkHapticPencilGround ground);

  /// The point under a place of the window [pixels]. False if it is nearer than two pixels to the last one, or there is
  /// nothing to draw on there: nothing is added then.
  bool Add(vtkRenderer* renderer, double x, double y);
  /// Leaves out points as long as the line stays within a pixel of where it was drawn.
  void Simplify();

  const std::vector<palpate::Vec3>& GetPoints() const { return this->Points_W; }

private:
  vtkHapticPencilGround Ground;
  std::vector<palpate::Vec3> Points_W;
  double LastX = 0.0;
  double LastY = 0.0;
  double Pixel_u = 0.0; ///< size of a pixel where the stroke began
};

#endif
