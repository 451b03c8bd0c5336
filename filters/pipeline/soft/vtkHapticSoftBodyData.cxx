// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSoftBodyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "haptics/compliance/element/Materials.h"
#include "haptics/compliance/mesh/ThinPlaces.h"
#include "haptics/core/Text.h"
#include "haptics/session/settings/Setting.h"
#include "vtkCellData.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticSoftLoad.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
constexpr const char* FixedName = "Fixed";
constexpr const char* YoungName = "Young";
constexpr const char* MaterialName = "SoftBody";
constexpr const char* BallName = "SoftBodyBall";

/// A vertex is on a side of the box within this share of its diagonal.
constexpr double SideWithin = 1e-6;

bool IsTetra(vtkUnstructuredGrid& grid, vtkIdType cell)
{
  return grid.GetCellType(cell) == VTK_TETRA;
}

bool AllTetra(vtkUnstructuredGrid& grid)
{
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (!IsTetra(grid, cell))
    {
      return false;
    }
  }
  return grid.GetNumberOfCells() > 0;
}

/// Which end of which axis a side is; -1: no side.
int SideOf(const std::string& name)
{
  static const std::array<std::string, 6> names = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

vtkDataArray* OneNumberEach(vtkUnstructuredGrid& body, const char* name)
{
  vtkDataArray* const array = body.GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

/// The body's own array of fixed vertices, with those that were fixed before: that array may be its input's, too.
vtkSmartPointer<vtkIntArray> OwnFixed(vtkUnstructuredGrid& body)
{
  vtkDataArray* const before = OneNumberEach(body, FixedName);
  vtkNew<vtkIntArray> made;
  made->SetName(FixedName);
  made->SetNumberOfTuples(body.GetNumberOfPoints());
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    made->SetValue(i, before && before->GetTuple1(i) != 0.0 ? 1 : 0);
  }
  body.GetPointData()->AddArray(made);
  return made;
}

/// Poisson's ratio, the number of a model, metres a unit, and density, which older files have not: files say anything.
bool IsDescription(vtkDataArray& material)
{
  const int components = material.GetNumberOfComponents();
  if ((components != 3 && components != 4) || material.GetNumberOfTuples() < 1)
  {
    return false;
  }
  const double model = material.GetComponent(0, 1);
  return model == 0.0 || model == 1.0 || model == 2.0;
}

void FixSide(vtkUnstructuredGrid& body, int side, double rough, vtkIntArray& fixed)
{
  const double end = body.GetBounds()[side];
  const double within = std::max(SideWithin * body.GetLength(), rough);
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    if (std::abs(body.GetPoint(i)[side / 2] - end) <= within)
    {
      fixed.SetValue(i, 1);
    }
  }
}

palpate::TetraMesh MeshOf(vtkUnstructuredGrid& body)
{
  palpate::TetraMesh mesh;
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    mesh.vertices_W.emplace_back(body.GetPoint(i));
  }
  for (vtkIdType cell = 0; cell < body.GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    body.GetCellPoints(cell, count, corners);
    palpate::Tetra tetra{};
    std::copy(corners, corners + 4, tetra.begin());
    mesh.tetras.push_back(tetra);
  }
  return mesh;
}

std::array<double, 6> Six(const palpate::Mat3& m)
{
  return { m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2) };
}

vtkSmartPointer<vtkDoubleArray> Array(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.0);
  return array;
}

/// Field data are shared between shallow copies: the additions are the body's own.
void AddToFieldData(vtkUnstructuredGrid& body, vtkDataArray* array)
{
  vtkNew<vtkFieldData> own;
  own->ShallowCopy(body.GetFieldData());
  own->AddArray(array);
  body.SetFieldData(own);
}

/// Strain and stress of each tetrahedron; 0 of those that are no part of the body.
void SetStress(vtkUnstructuredGrid& body, const palpate::SoftBodyInput& input, const palpate::CheckedTetras* checked,
  const palpate::BodyShape* shape)
{
  const auto strain = Array("Strain", 6, body.GetNumberOfCells());
  const auto stress = Array("Stress", 6, body.GetNumberOfCells());
  for (std::size_t i = 0; shape && checked && i < checked->sourceTetra.size(); ++i)
  {
    const std::uint32_t cell = checked->sourceTetra[i];
    const palpate::Mat3& f = shape->deformation[i];
    const double young_Pa = input.young_Pa[input.young_Pa.size() == 1 ? 0 : cell];
    const palpate::ElasticModuli moduli = palpate::moduliOf(young_Pa, input.poisson, 1.0).value;
    const palpate::Mat3 cauchy_Pa = palpate::stressOf(input.model, moduli, f) * f.transpose() / f.determinant();
    strain->SetTuple(cell, Six(0.5 * (f.transpose() * f - palpate::Mat3::Identity())).data());
    stress->SetTuple(cell, Six(cauchy_Pa).data());
  }
  body.GetCellData()->AddArray(strain);
  body.GetCellData()->AddArray(stress);
}

std::string Assumed(double value, double usual)
{
  return value == usual ? " (assumed)" : "";
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> vtkHapticTetrahedra(vtkDataObject* data, std::string& problem)
{
  auto* const set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    problem = "the data have several blocks: choose one block";
    return nullptr;
  }
  auto body = vtkSmartPointer<vtkUnstructuredGrid>::New();
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(set);
  if (grid && AllTetra(*grid))
  {
    body->ShallowCopy(grid);
    return body;
  }
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(set);
  cut->TetrahedraOnlyOn();
  cut->Update();
  body->ShallowCopy(cut->GetOutput());
  problem = AllTetra(*body) ? "" : "the data have no volume cells: use tetrahedra, a closed surface or a label image";
  return problem.empty() ? body : nullptr;
}

bool vtkHapticFixBody(vtkUnstructuredGrid& body, const std::string& fixed, double rough, std::string& problem)
{
  const vtkSmartPointer<vtkDataArray> given = OneNumberEach(body, fixed.c_str()); // may be the one replaced
  const auto array = OwnFixed(body);
  const std::vector<std::string> words = palpate::partsOf(fixed, ',');
  const bool sides = std::all_of(words.begin(), words.end(), [](const auto& word) { return SideOf(word) >= 0; });
  if (sides)
  {
    for (const std::string& word : words)
    {
      FixSide(body, SideOf(word), rough, *array);
    }
    return true;
  }
  if (!given)
  {
    problem = "fixed vertices: '" + fixed +
              "' is neither a point array with one component nor sides of the bounding box (xmin, xmax, ymin, ymax, "
              "zmin, zmax)";
    return false;
  }
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    array->SetValue(i, array->GetValue(i) != 0 || given->GetTuple1(i) != 0.0 ? 1 : 0);
  }
  return true;
}

bool vtkHapticDescribeBody(
  vtkUnstructuredGrid& body, const vtkHapticSoftMaterial& material, const std::string& youngArray, std::string& problem)
{
  const auto young = Array(YoungName, 1, body.GetNumberOfCells());
  vtkDataArray* const given = youngArray.empty() ? nullptr : body.GetCellData()->GetArray(youngArray.c_str());
  if (!youngArray.empty() && (!given || given->GetNumberOfComponents() != 1))
  {
    problem = "modulus: '" + youngArray + "' is not a cell array with one component";
    return false;
  }
  for (vtkIdType cell = 0; cell < body.GetNumberOfCells(); ++cell)
  {
    young->SetValue(cell, given ? given->GetTuple1(cell) : material.Young_Pa);
    const double young_Pa = young->GetValue(cell);
    const std::string modulus = palpate::refuseModulus(young_Pa);
    problem = modulus.empty() ? palpate::moduliOf(young_Pa, material.Poisson, material.Unit_m).problem : modulus;
    if (!problem.empty())
    {
      return false;
    }
  }
  const auto rest = Array(MaterialName, 4, 1);
  rest->SetTuple4(0, material.Poisson, static_cast<double>(material.Model), material.Unit_m, material.Density_kg_m3);
  OwnFixed(body);
  body.GetCellData()->AddArray(young);
  AddToFieldData(body, rest);
  return true;
}

bool vtkHapticIsSoftBody(vtkDataObject* data)
{
  return data && data->IsA("vtkUnstructuredGrid") && data->GetFieldData()->GetArray(MaterialName);
}

vtkHapticSoftBodyResult vtkHapticToSoftBody(vtkDataObject* data)
{
  auto* const body = vtkUnstructuredGrid::SafeDownCast(data);
  vtkDataArray* const material = body ? body->GetFieldData()->GetArray(MaterialName) : nullptr;
  vtkDataArray* const young = body ? body->GetCellData()->GetArray(YoungName) : nullptr;
  if (!material || !IsDescription(*material) || !young || !AllTetra(*body))
  {
    return { nullptr, "not a soft body: apply the filter Soft Body first" };
  }
  auto input = std::make_shared<palpate::SoftBodyInput>();
  input->mesh = MeshOf(*body);
  for (vtkIdType cell = 0; cell < body->GetNumberOfCells(); ++cell)
  {
    input->young_Pa.push_back(young->GetTuple1(cell));
  }
  vtkDataArray* const fixed = OneNumberEach(*body, FixedName);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    input->fixed.push_back(fixed && fixed->GetTuple1(i) != 0.0);
  }
  input->poisson = material->GetComponent(0, 0);
  input->model = static_cast<palpate::ElasticModel>(static_cast<int>(material->GetComponent(0, 1)));
  input->unit_m = material->GetComponent(0, 2);
  input->density_kg_per_m3 =
    material->GetNumberOfComponents() > 3 ? material->GetComponent(0, 3) : vtkHapticSoftMaterial::UsualDensity;
  if (!(input->density_kg_per_m3 > 0.0 && std::isfinite(input->density_kg_per_m3)))
  {
    return { nullptr, "the density must be a finite number above 0 [kg/m3]" };
  }
  vtkDataArray* const load = body->GetPointData()->GetArray(vtkHapticLoadName);
  for (vtkIdType i = 0; load && load->GetNumberOfComponents() == 3 && i < body->GetNumberOfPoints(); ++i)
  {
    input->load_N.emplace_back(load->GetTuple3(i));
  }
  input->element = palpate::usualElement(input->mesh, input->young_Pa, input->poisson, input->model);
  return { input, "" };
}

palpate::Vec3 vtkHapticOutOf(const vtkHapticBall& ball, const palpate::Vec3& p_W)
{
  const palpate::Vec3 away = p_W - ball.Centre_W;
  const double distance = away.norm();
  const bool within = distance < ball.Radius_u && distance > 0.0;
  return within ? palpate::Vec3(ball.Centre_W + ball.Radius_u / distance * away) : p_W;
}

vtkHapticBodyWay vtkHapticWayOf(
  const palpate::SoftBodyInput& input, const palpate::CheckedTetras* checked, const palpate::BodyShape* shape)
{
  const auto count = static_cast<vtkIdType>(input.mesh.vertices_W.size());
  vtkHapticBodyWay way{ Array(vtkHapticBodyWay::DisplacementName, 3, count),
    Array(vtkHapticBodyWay::DentName, 3, count) };
  for (std::size_t v = 0; shape && checked && v < checked->sourceVertex.size(); ++v)
  {
    way.Displacement->SetTuple(checked->sourceVertex[v], shape->displacement_u[v].data());
    way.Dent->SetTuple(checked->sourceVertex[v], shape->dent_u[v].data());
  }
  return way;
}

void vtkHapticBendBody(vtkUnstructuredGrid& body, const palpate::SoftBodyInput& input,
  const palpate::CheckedTetras* checked, const palpate::BodyShape* shape, const vtkHapticBall& ball)
{
  const vtkHapticBodyWay way = vtkHapticWayOf(input, checked, shape);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(body.GetNumberOfPoints());
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    const palpate::Vec3 moved_W =
      input.mesh.vertices_W[static_cast<std::size_t>(i)] + palpate::Vec3(way.Displacement->GetPointer(3 * i));
    const palpate::Vec3 place_W = vtkHapticOutOf(ball, moved_W + palpate::Vec3(way.Dent->GetPointer(3 * i)));
    points->SetPoint(i, place_W.data());
    way.Dent->SetTuple(i, palpate::Vec3(place_W - moved_W).data());
  }
  body.SetPoints(points);
  body.GetPointData()->AddArray(way.Displacement);
  body.GetPointData()->AddArray(way.Dent);
  SetStress(body, input, checked, shape);
  const auto presses = Array(BallName, 4, 1);
  presses->SetTuple4(0, ball.Centre_W.x(), ball.Centre_W.y(), ball.Centre_W.z(), ball.Radius_u);
  AddToFieldData(body, presses);
}

vtkHapticBall vtkHapticBallOn(vtkUnstructuredGrid& body)
{
  vtkDataArray* const ball = body.GetFieldData()->GetArray(BallName);
  if (!ball || ball->GetNumberOfComponents() != 4 || ball->GetNumberOfTuples() < 1)
  {
    return {};
  }
  const double* const numbers = ball->GetTuple4(0);
  return { palpate::Vec3(numbers), numbers[3] };
}

std::string vtkHapticSoftBodyText(const palpate::SoftBodyInput& input)
{
  static const char* const models[] = { "linear", "co-rotational", "stable neo-Hookean" };
  const auto [low, high] = std::minmax_element(input.young_Pa.begin(), input.young_Pa.end());
  std::string text = std::string(models[static_cast<int>(input.model)]) + ", Young's modulus " +
                     palpate::quantity(*low, "Pa") + (*low < *high ? " to " + palpate::quantity(*high, "Pa") : "") +
                     (*low < *high ? "" : Assumed(*low, vtkHapticSoftMaterial::UsualYoungPa));
  text += ", Poisson's ratio " + palpate::quantity(input.poisson, "") +
          Assumed(input.poisson, vtkHapticSoftMaterial::UsualPoisson);
  if (!input.load_N.empty())
  {
    const palpate::Vec3 sum = std::accumulate(input.load_N.begin(), input.load_N.end(), palpate::Vec3(0, 0, 0));
    text += ", total load " + palpate::quantity(sum.norm(), "N");
  }
  text += ", one unit is " + palpate::quantity(input.unit_m, "m") + Assumed(input.unit_m, 1.0) + ", " +
          std::to_string(input.mesh.tetras.size()) + " tetrahedra";
  const std::string thin = palpate::thinPlacesOf(input.mesh).sentence();
  return text + (thin.empty() ? "" : "; " + thin);
}

std::string vtkHapticStrainText(const palpate::BodyShape& shape)
{
  std::ostringstream text;
  text.precision(2);
  text << 100.0 * shape.mostGradient << " %";
  if (shape.mostGradient > 0.0)
  {
    const palpate::Vec3& at = shape.worst_W;
    text.precision(4);
    text << " at (" << at.x() << ", " << at.y() << ", " << at.z() << ")";
  }
  text << (shape.mostGradient > vtkHapticStrain::Large   ? ": results are only qualitative"
           : shape.mostGradient > vtkHapticStrain::Small ? ": a linear model errs by about 10 %"
                                                         : "");
  return text.str();
}
