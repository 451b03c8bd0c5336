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
class vtkDoubleArray;

/// Material of a body.
struct vtkHapticSoftMaterial
{
  static constexpr double UsualYoungPa = 20e3;   ///< about that of liver; the body's own is not measured
  static constexpr double UsualPoisson = 0.4;    ///< the most that is true with few tetrahedra
  static constexpr double UsualDensity = 1000.0; ///< as water

  double Young_Pa = UsualYoungPa;
  double Poisson = UsualPoisson;
  palpate::ElasticModel Model = palpate::ElasticModel::NeoHookean;
  double Unit_m = 1.0; ///< metres a unit of the data
  double Density_kg_m3 = UsualDensity;
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

/// Which vertices are fixed: sides of its box (xmin, xmax, ymin, ymax, zmin, zmax, with commas between them), or the
/// name of a point array, where it is not 0. "": none. The point array "Fixed" says so then; false with a problem. A
/// vertex is on a side within a millionth of the diagonal, or within `rough` [u], by which its border is known.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticFixBody(
  vtkUnstructuredGrid& body, const std::string& fixed, double rough, std::string& problem);

/// Describes a body by arrays: Young [Pa] of its cells, from an array of theirs if one is named, and its material as
/// field data. False with a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticDescribeBody(vtkUnstructuredGrid& body,
  const vtkHapticSoftMaterial& material, const std::string& youngArray, std::string& problem);

/// Whether data were described as a body.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsSoftBody(vtkDataObject* data);

/// A body that has been described.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticSoftBodyResult vtkHapticToSoftBody(vtkDataObject* data);

/// The contact on a body: a ball in the scene, or none with a radius of 0.
struct vtkHapticBall
{
  palpate::Vec3 Centre_W = palpate::Vec3::Zero();
  double Radius_u = 0.0;
};

/// Where a place of a pressed body is shown: within the ball, which dents the body, on the ball straight from its
/// middle. The surface under a contact comes as deep as the ball is felt to.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT palpate::Vec3 vtkHapticOutOf(
  const vtkHapticBall& ball, const palpate::Vec3& p_W);

/// Vectors [u] of each point of a described body.
struct vtkHapticBodyWay
{
  static constexpr const char* DisplacementName = "Displacement";
  static constexpr const char* DentName = "Dent";
  vtkSmartPointer<vtkDoubleArray> Displacement; ///< how far it has gone: of the finite elements' node
  vtkSmartPointer<vtkDoubleArray> Dent;         ///< how much further it is shown, where something presses
};

/// Displacement of each point of a described body in a state. `checked`: the tetrahedra of `shape`; either null: at
/// rest.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticBodyWay vtkHapticWayOf(
  const palpate::SoftBodyInput& input, const palpate::CheckedTetras* checked, const palpate::BodyShape* shape);

/// Gives a described body the arrays Displacement and Dent [u], Strain (Green's, xx yy zz xy yz xz) and Stress
/// (Cauchy's, likewise [Pa]) of a state, and the points at rest moved by both of the former. `checked`: the tetrahedra
/// of `shape`; null: at rest. The dent is that of `ball` and of points under a force; displacement, strain and stress
/// are those of the tetrahedra, without the dent.
VTKHAPTICPIPELINE_EXPORT void vtkHapticBendBody(vtkUnstructuredGrid& body, const palpate::SoftBodyInput& input,
  const palpate::CheckedTetras* checked, const palpate::BodyShape* shape, const vtkHapticBall& ball = {});

/// The ball that a body was given with its last state.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticBall vtkHapticBallOn(vtkUnstructuredGrid& body);

/// Largest |F - 1| within which a model of small strains is true to 1 %, and from which on any model is qualitative.
struct vtkHapticStrain
{
  static constexpr double Small = 0.1, Large = 0.5;
};

/// "12 % at (1, 2, 3): a linear model errs by about 10 %": the largest strain of a body, where it is, and how far the
/// model is off there.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticStrainText(const palpate::BodyShape& shape);

/// "Young's modulus 20 kPa (assumed), ...": the model, with "assumed" beside each default.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticSoftBodyText(const palpate::SoftBodyInput& input);

#endif
