// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfaceCheck.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "haptics/geometry/measure/SurfaceFaults.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticPieces.h"
#include "vtkHapticWholeInput.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkHapticSurfaceCheck);

namespace
{
constexpr double NotThin = std::numeric_limits<double>::quiet_NaN();

/// Cells of a mesh with the points they need and no more.
class Excerpt
{
public:
  explicit Excerpt(const palpate::TriangleMesh& mesh) : Mesh(mesh) { this->Points->SetDataTypeToDouble(); }

  template<typename Corners>
  void Add(const Corners& corners)
  {
    this->Cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const std::uint32_t corner : corners)
    {
      const auto [at, isNew] = this->Known.try_emplace(corner, this->Points->GetNumberOfPoints());
      if (isNew)
      {
        this->Points->InsertNextPoint(this->Mesh.vertices_W[corner].data());
      }
      this->Cells->InsertCellPoint(at->second);
    }
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> Triangles() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetPolys(this->Cells);
    return data;
  }
  [[nodiscard]] vtkSmartPointer<vtkPolyData> Lines() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetLines(this->Cells);
    return data;
  }

private:
  const palpate::TriangleMesh& Mesh;
  std::map<std::uint32_t, vtkIdType> Known;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

template<typename Array, typename Value>
void AddCellArray(vtkPolyData& data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value value : values)
  {
    array->InsertNextValue(value);
  }
  data.GetCellData()->AddArray(array);
}

/// The findings at each triangle of a mesh.
struct Said
{
  std::vector<vtkIdType> Flipped;
  std::vector<double> Thickness;

  Said(const palpate::TriangleMesh& mesh, const palpate::SurfaceFaults& faults)
    : Flipped(mesh.triangles.size(), 0), Thickness(mesh.triangles.size(), NotThin)
  {
    for (std::size_t part = 0; part < faults.flipped.size(); ++part)
    {
      for (const std::uint32_t triangle : faults.flipped[part].triangles)
      {
        this->Flipped[triangle] = static_cast<vtkIdType>(part) + 1;
      }
    }
    for (const palpate::ThinPlace& place : faults.thin)
    {
      this->Thickness[place.triangle] = place.thickness_u;
    }
  }
};

vtkSmartPointer<vtkPolyData> TrianglesOf(
  const palpate::TriangleMesh& mesh, const Said& said, const std::vector<std::uint32_t>& triangles)
{
  Excerpt excerpt(mesh);
  std::vector<vtkIdType> numbers, flipped;
  std::vector<double> thickness;
  for (const std::uint32_t triangle : triangles)
  {
    excerpt.Add(mesh.triangles[triangle]);
    numbers.push_back(triangle);
    flipped.push_back(said.Flipped[triangle]);
    thickness.push_back(said.Thickness[triangle]);
  }
  vtkSmartPointer<vtkPolyData> data = excerpt.Triangles();
  AddCellArray<vtkIdTypeArray>(*data, "Triangle", numbers);
  AddCellArray<vtkIdTypeArray>(*data, "Flipped", flipped);
  AddCellArray<vtkDoubleArray>(*data, "Thickness", thickness);
  return data;
}

vtkSmartPointer<vtkPolyData> SurfaceOf(const palpate::TriangleMesh& mesh, const Said& said)
{
  vtkSmartPointer<vtkPolyData> data = vtkHapticToPolyData(mesh);
  AddCellArray<vtkIdTypeArray>(*data, "Flipped", said.Flipped);
  AddCellArray<vtkDoubleArray>(*data, "Thickness", said.Thickness);
  return data;
}

vtkSmartPointer<vtkPolyData> HolesOf(const palpate::TriangleMesh& mesh, const palpate::SurfaceFaults& faults)
{
  Excerpt excerpt(mesh);
  std::vector<vtkIdType> numbers;
  std::vector<double> lengths;
  for (std::size_t hole = 0; hole < faults.holes.size(); ++hole)
  {
    for (const auto& edge : faults.holes[hole].edges)
    {
      excerpt.Add(edge);
      numbers.push_back(static_cast<vtkIdType>(hole) + 1);
      lengths.push_back(faults.holes[hole].length_u);
    }
  }
  vtkSmartPointer<vtkPolyData> data = excerpt.Lines();
  AddCellArray<vtkIdTypeArray>(*data, "Hole", numbers);
  AddCellArray<vtkDoubleArray>(*data, "Length", lengths);
  return data;
}

void AddBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkPolyData* data)
{
  const unsigned int number = blocks->GetNumberOfBlocks();
  blocks->SetBlock(number, data);
  blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name);
}
} // namespace

void vtkHapticSurfaceCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ThinBelow: " << this->ThinBelow << " u\n";
}

int vtkHapticSurfaceCheck::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHapticSurfaceCheck::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  const std::string refusal = vtkHapticRefusePieces(output);
  vtkMultiBlockDataSet* const blocks = vtkMultiBlockDataSet::GetData(output);
  const vtkSmartPointer<vtkDataObject> whole = vtkHapticWholeSurface(vtkDataObject::GetData(input[0]));
  if (vtkHapticRank() > 0)
  {
    for (const char* name : { "Surface", "Holes", "Flipped", "Thin" })
    {
      AddBlock(blocks, name, vtkSmartPointer<vtkPolyData>::New()); // the first rank has the findings
    }
    return 1;
  }
  const vtkHapticConversionResult converted = vtkHapticToMesh(whole);
  if (!refusal.empty() || !converted.Mesh)
  {
    vtkErrorMacro("Nothing is checked: " << (refusal.empty() ? converted.Problem : refusal));
    return 0;
  }
  const palpate::TriangleMesh& mesh = *converted.Mesh;
  const palpate::SurfaceFaults faults = palpate::findFaults(mesh, this->ThinBelow);
  const Said said(mesh, faults);
  std::vector<std::uint32_t> flipped, thin;
  for (const palpate::FlippedPart& part : faults.flipped)
  {
    flipped.insert(flipped.end(), part.triangles.begin(), part.triangles.end());
  }
  for (const palpate::ThinPlace& place : faults.thin)
  {
    thin.push_back(place.triangle);
  }
  AddBlock(blocks, "Surface", SurfaceOf(mesh, said));
  AddBlock(blocks, "Holes", HolesOf(mesh, faults));
  AddBlock(blocks, "Flipped", TrianglesOf(mesh, said, flipped));
  AddBlock(blocks, "Thin", TrianglesOf(mesh, said, thin));
  return 1;
}
