// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCellChecks.h"

#include <algorithm>
#include <array>

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkHapticVtkVersions.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace
{
std::string CheckCellArray(vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return "";
  }
  if (!cells->IsValid())
  {
    return "its list of cells is inconsistent";
  }
  // Into a list of its own: VTK's shorter form, and GetRange(), keep their results, which is not for two threads.
  const vtkNew<vtkIdList> copy;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(cell, size, corners, copy);
    const auto* const beyond =
      std::find_if(corners, corners + size, [points](vtkIdType corner) { return corner < 0 || corner >= points; });
    if (beyond != corners + size)
    {
      return "a cell names point " + std::to_string(*beyond) + "; there are " + std::to_string(points) +
             " points, counted from 0";
    }
  }
  return "";
}

/// How many points a cell of each type has at least; -1 for a type that VTK does not know.
class LeastPoints
{
public:
  LeastPoints() { this->Known.fill(Unasked); }

  int Of(int type)
  {
    int& least = this->Known[static_cast<std::size_t>(type)];
    if (least == Unasked)
    {
      auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      least = cell ? static_cast<int>(cell->GetNumberOfPoints()) : type == VTK_EMPTY_CELL ? 0 : -1;
    }
    return least;
  }

private:
  static constexpr int Unasked = -2;
  std::array<int, 256> Known{};
};

std::string CheckTypes(vtkUnstructuredGrid* grid)
{
  vtkDataArray* types = vtkHapticCellTypes(grid);
  const vtkIdType cells = grid->GetCells() ? grid->GetCells()->GetNumberOfCells() : 0;
  if ((types ? types->GetNumberOfTuples() : 0) != cells)
  {
    return "the number of cell types differs from the number of cells";
  }
  LeastPoints least;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const int type = static_cast<int>(types->GetComponent(cell, 0));
    const int points = least.Of(type);
    if (points < 0 || grid->GetCells()->GetCellSize(cell) < points)
    {
      return "cell " + std::to_string(cell) + " has " + std::to_string(grid->GetCells()->GetCellSize(cell)) +
             " points, which does not fit its type " + std::to_string(type);
    }
  }
  return "";
}

std::string CheckPolyhedra(vtkUnstructuredGrid* grid)
{
  vtkHapticPolyhedra polyhedra(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_POLYHEDRON && !polyhedra.IsValid(cell))
    {
      return "the faces of polyhedron " + std::to_string(cell) + " are broken";
    }
  }
  return "";
}
} // namespace

std::string vtkHapticCellChecks::CheckPolyData(vtkPolyData* data)
{
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    if (std::string problem = CheckCellArray(cells, data->GetNumberOfPoints()); !problem.empty())
    {
      return problem;
    }
  }
  return "";
}

std::string vtkHapticCellChecks::CheckGrid(vtkUnstructuredGrid* grid)
{
  std::string problem = CheckCellArray(grid->GetCells(), grid->GetNumberOfPoints());
  problem = problem.empty() ? CheckTypes(grid) : problem;
  return problem.empty() ? CheckPolyhedra(grid) : problem;
}
