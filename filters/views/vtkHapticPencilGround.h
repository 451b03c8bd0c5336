// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPencilGround_h
#define vtkHapticPencilGround_h

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/core/Types.h"
#include "vtkHapticViewScan.h"

class vtkRenderer;
class vtkSMRenderViewProxy;

/// The ground of the drawing: the point under a position in the window [pixels]; none without ground.
using vtkHapticPencilGround = std::function<std::optional<palpate::Vec3>(double x, double y)>;

/// The plane through point_W, across normal_W. None where it is seen as a line or lies behind the eye.
[[nodiscard]] vtkHapticPencilGround vtkHapticPlaneGround(
  vtkRenderer* renderer, const palpate::Vec3& point_W, const palpate::Vec3& normal_W);
/// The plane through the camera's focal point, parallel to the screen.
[[nodiscard]] vtkHapticPencilGround vtkHapticScreenGround(vtkRenderer* renderer);

/// The polygons that a view shows, as vtkHapticScanView() finds them. Search trees of those that stay as they are serve
/// one line after the other: a million triangles take half a second.
class vtkHapticSurfaceGround
{
public:
  /// The place nearest to the eye on the polygons that are shown now; null where none is under that place.
  [[nodiscard]] vtkHapticPencilGround At(vtkSMRenderViewProxy* view, double x, double y);

private:
  struct Piece;

  vtkHapticViewScan Scan;
  std::shared_ptr<const std::vector<Piece>> Pieces; ///< of Scan
};

#endif
