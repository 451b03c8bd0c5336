// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPlaneWalls_h
#define vtkHapticPlaneWalls_h

#include <memory>
#include <string>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

class vtkDataObject;
class vtkMatrix4x4;

/// The lines of a data object as walls across the plane they lie in.
struct vtkHapticPlaneWalls
{
  std::shared_ptr<const palpate::TriangleMesh> Mesh; ///< null where there are no lines, or in no plane
  palpate::Pose Plane_WP;                            ///< its z is the normal
  std::string Problem;                               ///< why there are none, or ""
};

/// `matrix` places the data in W (null: identity). Walls for balls up to that radius [u].
vtkHapticPlaneWalls vtkHapticRaiseLines(vtkDataObject* data, vtkMatrix4x4* matrix, double radius_u);

#endif
