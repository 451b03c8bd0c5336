// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismBodies_h
#define vtkHapticMechanismBodies_h

#include <memory>
#include <string>

#include "haptics/core/Types.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "vtkHapticSoftBodyData.h"

/// A soft body as a scene file describes it: a file, or a box of cells.
struct vtkHapticSoftDescription
{
  std::string File; ///< tetrahedra, or a closed surface to be filled; "": the box
  palpate::Vec3 BoxSize_u = palpate::Vec3::Zero();
  palpate::Vec3 BoxMiddle_W = palpate::Vec3::Zero();
  double Edge_u = 0.0; ///< of its cells, or of tetrahedra that fill a surface; 0: chosen
  std::string Fixed;   ///< sides of its box, or a point array
  vtkHapticSoftMaterial Material;
};

/// The resulting body; null with a problem.
struct vtkHapticDescribedSoft
{
  std::shared_ptr<const palpate::SoftBodyInput> Input;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::string Problem;
};

/// Reads or makes the body; a relative file is looked for in `folder`.
[[nodiscard]] vtkHapticDescribedSoft vtkHapticMakeSoft(
  const vtkHapticSoftDescription& description, const std::string& folder);

/// A rigid surface, read from a file and put at a place; a relative file is looked for in `folder`.
[[nodiscard]] palpate::Outcome<std::shared_ptr<const palpate::SidedSurface>> vtkHapticReadRigidMesh(
  const std::string& file, const std::string& folder, const palpate::Pose& place_W);

#endif
