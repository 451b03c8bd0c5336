// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSoftBodyData_h
#define vtkHapticSoftBodyData_h

#include <memory>
#include <string>

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/session/soft/BodyMaker.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkDataObject;

/// What a body is made of.
struct vtkHapticSoftMaterial
{
  static constexpr double UsualYoungPa = 20e3; ///< about that of liver; nobody has measured this one
  static constexpr double UsualPoisson = 0.4;   ///< the most that is true with few tetrahedra

  double Young_Pa = UsualYoungPa;
  double Poisson = UsualPoisson;
  palpate::ElasticModel Model = palpate::ElasticModel::NeoHookean;
  double Unit_m = 1.0; ///< metres a unit of the data
};

/// Data as a soft body, or why they are none.
struct vtkHapticSoftBodyResult
{
  std::shared_ptr<palpate::SoftBodyInput> Input; ///< null on a problem
  std::string Problem;                           ///< one line without a name in front
};

/// The tetrahedra of a data set, other cells that fill space cut into tetrahedra; points and cells of none of them are
/// left out. Null with a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkUnstructuredGrid> vtkHapticTetrahedra(
  vtkDataObject* data, std::string& problem);

/// Whose vertices are held: sides of its box (xmin, xmax, ymin, ymax, zmin, zmax, with commas between them), or the
/// name of a point array, where it is not 0. "": none. The point array "Fixed" says so then; false with a problem.
/// A vertex is on a side within a millionth of the diagonal, or within `rough` [u], by which its border is known.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticFixBody(
  vtkUnstructuredGrid& body, const std::string& fixed, double rough, std::string& problem);

/// Describes a body by arrays: Young [Pa] of its cells, from an array of theirs if one is named, and its material as
/// field data. False with a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticDescribeBody(vtkUnstructuredGrid& body,
  const vtkHapticSoftMaterial& material, const std::string& youngArray, std::string& problem);

/// A body that has been described.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticSoftBodyResult vtkHapticToSoftBody(vtkDataObject* data);

/// Gives a described body the points and the arrays Displacement [u], Strain (Green's, xx yy zz xy yz xz) and Stress
/// (Cauchy's, likewise [Pa]) of a state. `checked`: what `shape` has displacements of; null: at rest.
VTKHAPTICPIPELINE_EXPORT void vtkHapticBendBody(vtkUnstructuredGrid& body, const palpate::SoftBodyInput& input,
  const palpate::CheckedTetras* checked, const palpate::BodyShape* shape);

/// "Young's modulus 20 kPa (assumed), ...": what is modelled, with "assumed" beside what is as it was set out with.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticSoftBodyText(const palpate::SoftBodyInput& input);

#endif
