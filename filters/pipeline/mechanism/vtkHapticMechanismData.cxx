// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/mechanism/sided/SidedSurface.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticWireFile.h"
#include "vtkHapticWireShape.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkThreshold.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

namespace
{
constexpr const char* TextName = "HapticMechanism";
constexpr const char* FolderName = "HapticMechanismFolder";
constexpr const char* ServerName = "HapticMechanismOfServer";
constexpr const char* VesselName = "HapticMechanismVessel";
constexpr const char* BoundsName = "HapticMechanismBounds";

void AddText(vtkDataObject& data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data.GetFieldData()->AddArray(array);
}

std::string TextOf(vtkDataObject& data, const char* name)
{
  auto* const array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

vtkSmartPointer<vtkPolyData> Moved(vtkPolyData& shape, vtkTransform& transform)
{
  vtkNew<vtkTransformPolyDataFilter> move;
  move->SetInputData(&shape);
  move->SetTransform(&transform);
  move->Update();
  return move->GetOutput();
}

/// Where a body is at first, of a shape in its own frame.
vtkSmartPointer<vtkPolyData> Placed(vtkPolyData& shape, const palpate::MechanismBody& body)
{
  const Eigen::AngleAxisd turn(body.pose_W.q);
  const palpate::Vec3 axis = turn.axis();
  vtkNew<vtkTransform> pose;
  pose->Translate(body.pose_W.p.data());
  pose->RotateWXYZ(vtkMath::DegreesFromRadians(turn.angle()), axis.data());
  return Moved(shape, *pose);
}

vtkSmartPointer<vtkPolyData> BoxOf(const palpate::MechanismBody& body)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0 * body.halfSize_u.x());
  cube->SetYLength(2.0 * body.halfSize_u.y());
  cube->SetZLength(2.0 * body.halfSize_u.z());
  cube->Update();
  return Placed(*cube->GetOutput(), body);
}

vtkSmartPointer<vtkPolyData> BorderOf(vtkUnstructuredGrid& grid)
{
  vtkNew<vtkDataSetSurfaceFilter> border;
  border->SetInputData(&grid);
  border->PassThroughPointIdsOn();
  border->Update();
  return border->GetOutput();
}

vtkSmartPointer<vtkPolyData> ShapeOf(const palpate::MechanismBody& body, vtkUnstructuredGrid* grid)
{
  using enum palpate::MechanismBodyKind;
  const bool loose = body.kind == Rigid && body.mesh;
  const bool wire = body.wire && body.wire->plan;
  return wire                 ? vtkHapticWireShape(*body.wire->plan)
         : body.kind == Held  ? Placed(*vtkHapticHeldShape(body), body)
         : loose              ? Placed(*vtkHapticToPolyData(body.mesh->rightHanded()), body)
         : body.mesh          ? vtkHapticToPolyData(body.mesh->rightHanded())
         : body.kind == Rigid ? BoxOf(body)
         : grid               ? BorderOf(*grid)
                              : nullptr;
}

template<class Array, class Value>
vtkSmartPointer<Array> Filled(const char* name, int components, vtkIdType count, Value value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  array->Fill(value);
  return array;
}

/// The arrays of all shapes, and none of one kind of shape alone, normals say.
void Describe(vtkPolyData& shape, int body)
{
  const vtkIdType count = shape.GetNumberOfPoints();
  vtkDataArray* const ids = shape.GetPointData()->GetArray("vtkOriginalPointIds");
  const auto vertices = Filled<vtkIntArray>(vtkHapticMechanismArray::Vertex, 1, count, -1);
  for (vtkIdType i = 0; ids && i < count; ++i)
  {
    vertices->SetValue(i, static_cast<int>(ids->GetComponent(i, 0)));
  }
  shape.GetPointData()->Initialize();
  shape.GetCellData()->Initialize();
  shape.GetPointData()->AddArray(Filled<vtkIntArray>(vtkHapticMechanismArray::Body, 1, count, body));
  shape.GetPointData()->AddArray(vertices);
  shape.GetPointData()->AddArray(Filled<vtkDoubleArray>(vtkHapticMechanismArray::Displacement, 3, count, 0.0));
  shape.GetPointData()->AddArray(Filled<vtkDoubleArray>(vtkHapticMechanismArray::Dent, 3, count, 0.0));
  shape.GetCellData()->AddArray(Filled<vtkIntArray>(vtkHapticMechanismArray::Body, 1, shape.GetNumberOfCells(), body));
}
} // namespace

/// The held rod runs along +z, the needle of a source hangs below its origin.
vtkSmartPointer<vtkPolyData> vtkHapticHeldShape(const palpate::MechanismBody& body)
{
  if (body.mesh)
  {
    return vtkHapticToPolyData(body.mesh->rightHanded());
  }
  vtkNew<vtkHapticNeedle> needle;
  needle->SetLength(body.length_u);
  needle->SetDiameter(body.diameter_u);
  needle->Update();
  vtkNew<vtkTransform> up;
  up->RotateX(180.0);
  return Moved(*needle->GetOutput(), *up);
}

vtkSmartPointer<vtkPolyData> vtkHapticMechanismShapes(const vtkHapticMechanismResult& read)
{
  vtkNew<vtkAppendPolyData> all;
  const auto add = [&all](vtkPolyData& shape, int body)
  {
    Describe(shape, body);
    all->AddInputData(&shape);
  };
  std::size_t soft = 0;
  int number = 0;
  for (const palpate::MechanismBody& body : read.Inputs->mechanism.bodies)
  {
    if (body.wire && body.wire->vessel_W) // which counts as the body behind it
    {
      add(*vtkHapticToPolyData(*body.wire->vessel_W), number + 1);
    }
    const bool gives = body.kind == palpate::MechanismBodyKind::Soft;
    if (const auto shape = ShapeOf(body, gives ? read.SoftGrids[soft].Get() : nullptr))
    {
      add(*shape, number);
    }
    soft += gives ? 1 : 0;
    ++number;
  }
  all->Update();
  return all->GetOutput();
}

void vtkHapticDescribeMechanism(vtkDataObject& data, const std::string& text, const std::string& folder)
{
  AddText(data, TextName, text);
  AddText(data, FolderName, folder);
  if (auto* const shapes = vtkDataSet::SafeDownCast(&data))
  {
    const auto bounds = Filled<vtkDoubleArray>(BoundsName, 6, 1, 0.0);
    bounds->SetTuple(0, shapes->GetBounds());
    data.GetFieldData()->AddArray(bounds);
  }
}

void vtkHapticDescribeVessel(vtkDataObject& data)
{
  AddText(data, VesselName, "among these cells");
}

bool vtkHapticIsWhereMade(vtkDataObject& data)
{
  constexpr double share = 1e-4; // of the diagonal: a filter may round to single precision
  auto* const shapes = vtkDataSet::SafeDownCast(&data);
  vtkDataArray* const made = data.GetFieldData()->GetArray(BoundsName);
  if (!shapes || !made || made->GetNumberOfValues() != 6)
  {
    return true; // no place is given
  }
  const vtkBoundingBox now(shapes->GetBounds()), before(made->GetTuple(0));
  double away = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    away = std::max(away, std::abs(now.GetBound(2 * axis) - before.GetBound(2 * axis)));
    away = std::max(away, std::abs(now.GetBound(2 * axis + 1) - before.GetBound(2 * axis + 1)));
  }
  return away <= share * before.GetDiagonalLength();
}

bool vtkHapticIsMechanism(vtkDataObject* data)
{
  return data && data->GetFieldData() && data->GetFieldData()->GetAbstractArray(TextName);
}

std::string vtkHapticMechanismFileOf(vtkDataObject& data)
{
  return TextOf(data, TextName);
}

std::string vtkHapticMechanismFolderOf(vtkDataObject& data)
{
  return TextOf(data, FolderName);
}

void vtkHapticSetOfServer(vtkDataObject& data)
{
  AddText(data, ServerName, "yes");
}

bool vtkHapticIsOfServer(vtkDataObject& data)
{
  return data.GetFieldData()->GetAbstractArray(ServerName) != nullptr;
}

/// A wire is the only body of its mechanism, and its vessel counts as the one behind it.
std::shared_ptr<const palpate::TriangleMesh> vtkHapticVesselOf(vtkDataObject& data)
{
  constexpr double vessel = 1.0;
  if (!data.GetFieldData()->GetAbstractArray(VesselName))
  {
    return nullptr;
  }
  vtkNew<vtkThreshold> cells;
  cells->SetInputData(&data);
  cells->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkHapticMechanismArray::Body);
  cells->SetLowerThreshold(vessel);
  cells->SetUpperThreshold(vessel);
  cells->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
  cells->Update();
  return vtkHapticToMesh(cells->GetOutput()).Mesh;
}

vtkHapticMechanismResult vtkHapticToMechanism(vtkDataObject& data)
{
  return vtkHapticParseMechanism(
    vtkHapticMechanismFileOf(data), vtkHapticMechanismFolderOf(data), "", {}, vtkHapticVesselOf(data));
}

vtkHapticLooseMass vtkHapticMassOf(const palpate::MechanismBody& body, double unit_m)
{
  const double mass_kg = body.mass.mass_Ns2_per_u / unit_m;
  const double volume_u3 = body.mesh ? palpate::enclosedBy(body.mesh->rightHanded()).volume_u3 : 0.0;
  return { mass_kg, volume_u3 > 0.0 ? mass_kg / (volume_u3 * unit_m * unit_m * unit_m) : 0.0 };
}

std::vector<std::string> vtkHapticMechanismText(
  const palpate::MechanismInputs& inputs, const palpate::MechanismCheck& check)
{
  if (check.wire)
  {
    return vtkHapticWireText(*check.wire);
  }
  std::ostringstream numbers;
  numbers << inputs.mechanism.bodies.size() << " bodies, " << inputs.mechanism.laws.size()
          << " constraints: " << check.rows << " rows of rank " << check.rank << ", " << check.freeTurns
          << " free rotations, condition " << check.condition;
  std::vector<std::string> lines{ numbers.str() };
  if (inputs.mechanism.findsContacts)
  {
    lines.push_back(
      "contacts are found, at most " + std::to_string(palpate::roomForFound(inputs.mechanism)) + " at once");
  }
  for (const palpate::MechanismBody& body : inputs.mechanism.bodies)
  {
    if (palpate::isLoose(body) && body.mesh)
    {
      const vtkHapticLooseMass mass = vtkHapticMassOf(body, inputs.unit_m);
      std::ostringstream text;
      text << body.name << " is loose: " << mass.Mass_kg << " kg at " << mass.Density_kg_per_m3 << " kg/m^3";
      lines.push_back(text.str());
    }
  }
  lines.insert(lines.end(), check.remarks.begin(), check.remarks.end());
  return lines;
}
