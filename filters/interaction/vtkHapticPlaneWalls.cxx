// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPlaneWalls.h"

#include "haptics/geometry/curves/CurveSet.h"
#include "vtkHapticConversion.h"

vtkHapticPlaneWalls vtkHapticRaiseLines(vtkDataObject* data, vtkMatrix4x4* matrix, double radius_u)
{
  vtkHapticPlaneWalls walls;
  const vtkHapticConversionResult lines = vtkHapticToLines(data, matrix);
  walls.Problem = lines.Mesh ? palpate::refuseSegments(lines.Mesh->triangles.size()) : lines.Problem;
  if (!walls.Problem.empty())
  {
    return walls;
  }
  const std::optional<palpate::Pose> plane_WP = palpate::planeOf(*lines.Mesh);
  if (!plane_WP)
  {
    walls.Problem = "its lines lie in no plane; give a line radius above 0 to touch them as tubes";
    return walls;
  }
  const palpate::PlaneCurves plane = palpate::curvesInPlane(*lines.Mesh, *plane_WP);
  walls.Problem = plane.refusal;
  if (plane.refusal.empty())
  {
    walls.Plane_WP = *plane_WP;
    walls.Mesh = std::make_shared<palpate::TriangleMesh>(
      palpate::raiseWalls(plane.curves, palpate::wallHalfHeight(plane.curves, radius_u), *plane_WP));
  }
  return walls;
}
