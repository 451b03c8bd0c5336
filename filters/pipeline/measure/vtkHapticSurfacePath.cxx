// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfacePath.h"

#include <array>
#include <optional>
#include <vector>

#include "haptics/geometry/measure/SurfacePath.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticMeasuredSurface.h"
#include "vtkHapticPieces.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkHapticSurfacePath);

namespace
{
using palpate::Vec3;

/// Nothing if a table has no coordinates.
std::optional<std::vector<Vec3>> MarksOf(vtkDataObject* data)
{
  std::vector<Vec3> marks;
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      marks.emplace_back(points->GetPoint(i));
    }
    return marks;
  }
  auto* table = vtkTable::SafeDownCast(data);
  std::array<vtkDataArray*, 3> columns{};
  for (std::size_t axis = 0; axis < columns.size(); ++axis)
  {
    const std::array<const char*, 3> names = { "X", "Y", "Z" };
    columns[axis] = table ? vtkDataArray::SafeDownCast(table->GetColumnByName(names[axis])) : nullptr;
    if (!columns[axis])
    {
      return std::nullopt;
    }
  }
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    marks.emplace_back(columns[0]->GetComponent(i, 0), columns[1]->GetComponent(i, 0), columns[2]->GetComponent(i, 0));
  }
  return marks;
}

/// The output while it grows: a polyline a path.
class Ways
{
public:
  Ways()
  {
    this->Points->SetDataTypeToDouble();
    this->Way->SetName("Way");
    this->Length->SetName("Length");
    this->Straight->SetName("Straight");
  }

  void Add(const palpate::SurfacePath& path)
  {
    double way_u = 0.0;
    this->Lines->InsertNextCell(static_cast<int>(path.points_W.size()));
    for (std::size_t i = 0; i < path.points_W.size(); ++i)
    {
      way_u += i > 0 ? (path.points_W[i] - path.points_W[i - 1]).norm() : 0.0;
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(path.points_W[i].data()));
      this->Way->InsertNextValue(way_u);
    }
    this->Length->InsertNextValue(path.length_u);
    this->Straight->InsertNextValue((path.points_W.back() - path.points_W.front()).norm());
  }

  void MoveTo(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->AddArray(this->Way);
    output->GetCellData()->AddArray(this->Length);
    output->GetCellData()->AddArray(this->Straight);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Way;
  vtkNew<vtkDoubleArray> Length;
  vtkNew<vtkDoubleArray> Straight;
};
} // namespace

vtkHapticSurfacePath::vtkHapticSurfacePath()
{
  this->SetNumberOfInputPorts(2);
}

vtkHapticSurfacePath::~vtkHapticSurfacePath() = default;

void vtkHapticSurfacePath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Closed: " << this->Closed << '\n';
}

void vtkHapticSurfacePath::SetMarksConnection(vtkAlgorithmOutput* marks)
{
  this->SetInputConnection(1, marks);
}

int vtkHapticSurfacePath::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkCompositeDataSet" : "vtkTable");
  return 1;
}

int vtkHapticSurfacePath::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (const std::string refusal = vtkHapticRefusePieces(output); !refusal.empty())
  {
    vtkErrorMacro("Nothing is measured: " << refusal);
    return 0;
  }
  const vtkSmartPointer<vtkDataObject> whole = vtkHapticWholeSurface(vtkDataObject::GetData(input[0]));
  const vtkSmartPointer<vtkDataObject> marked = vtkHapticOnePiece(vtkDataObject::GetData(input[1]));
  if (vtkHapticRank() > 0)
  {
    return 1; // the first rank has the path
  }
  const std::optional<std::vector<Vec3>> marks = MarksOf(marked);
  if (!marks || marks->size() < 2)
  {
    vtkErrorMacro("A path needs at least two marks: points, or a table with the columns X, Y and Z");
    return 0;
  }
  std::string problem;
  const auto surface = vtkHapticMeasuredSurface(whole, problem);
  if (!surface)
  {
    vtkErrorMacro("There is no path on the surface: " << problem);
    return 0;
  }
  Ways ways;
  const std::size_t count = this->Closed ? marks->size() : marks->size() - 1;
  for (std::size_t i = 0; i < count && !this->CheckAbort(); ++i)
  {
    this->UpdateProgress(static_cast<double>(i) / static_cast<double>(count));
    const std::size_t next = (i + 1) % marks->size();
    const palpate::SurfacePath path = palpate::shortestPath(*surface, (*marks)[i], (*marks)[next]);
    if (!path.problem.empty())
    {
      vtkWarningMacro("No path from mark " << i << " to mark " << next << ": " << path.problem);
      continue;
    }
    ways.Add(path);
  }
  ways.MoveTo(vtkPolyData::GetData(output));
  return 1;
}
