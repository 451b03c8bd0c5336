// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfacePlacement_h
#define vtkHapticSurfacePlacement_h

#include <optional>
#include <string>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkMatrix4x4;

/// Effect of a matrix (null: identity) on a surface: shift, rotation, scale, shear and mirror.
using vtkHapticPlacement = Eigen::Affine3d;

/// Why a surface cannot be placed by a matrix; "" if it can. Refused: not finite, a perspective, singular.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticCheckPlacement(vtkMatrix4x4* matrix);

/// Of a matrix that can be used.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticPlacement vtkHapticPlacementOf(vtkMatrix4x4* matrix);

/// The pose that takes a surface from where `before` puts it to where `now` does [u]; nothing if that is no rigid
/// motion within rounding.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::optional<palpate::Pose> vtkHapticMotionBetween(
  const vtkHapticPlacement& before, const vtkHapticPlacement& now);

/// A mesh with every vertex moved on by `by`; a mirror turns the corners around, so that outside stays outside.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT palpate::TriangleMesh vtkHapticPlaced(
  const palpate::TriangleMesh& mesh, const vtkHapticPlacement& by);

#endif
