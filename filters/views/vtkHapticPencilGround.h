// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPencilGround_h
#define vtkHapticPencilGround_h

#include <functional>
#include <optional>

#include "haptics/core/Types.h"

class vtkRenderer;
class vtkSMRenderViewProxy;

/// What is drawn on: the point under a place of the window [pixels]; none where there is nothing to draw on.
using vtkHapticPencilGround = std::function<std::optional<palpate::Vec3>(double x, double y)>;

/// The plane through point_W, across normal_W. None where it is seen as a line or lies behind the eye.
[[nodiscard]] vtkHapticPencilGround vtkHapticPlaneGround(
  vtkRenderer* renderer, const palpate::Vec3& point_W, const palpate::Vec3& normal_W);
/// The plane through the camera's focal point, parallel to the screen.
[[nodiscard]] vtkHapticPencilGround vtkHapticScreenGround(vtkRenderer* renderer);
/// The polygons that the view shows now, as vtkHapticScanView() finds them, on the side that is seen; null where none
/// is under that place. Takes as long as a search tree of them.
[[nodiscard]] vtkHapticPencilGround vtkHapticSurfaceGround(vtkSMRenderViewProxy* view, double x, double y);

#endif
