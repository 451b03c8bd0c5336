// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCellChecks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
/// The least and the largest number, 0 and -1 of none. VTK's own GetRange() keeps what it found with the array, which
/// is not for two threads.
template<class Array>
std::pair<long long, long long> EndsOf(Array* numbers)
{
  if (numbers->GetNumberOfValues() == 0)
  {
    return { 0, -1 };
  }
  const auto* const first = numbers->GetPointer(0);
  const auto [least, most] = std::minmax_element(first, first + numbers->GetNumberOfValues());
  return { *least, *most };
}

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
  const auto [least, most] =
    cells->IsStorage64Bit() ? EndsOf(cells->GetConnectivityArray64()) : EndsOf(cells->GetConnectivityArray32());
  if (least < 0 || most >= points)
  {
    return "a cell names point " + std::to_string(least < 0 ? least : most) + "; there are " + std::to_string(points) +
           " points, counted from 0";
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
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  const vtkIdType cells = grid->GetCells() ? grid->GetCells()->GetNumberOfCells() : 0;
  if ((types ? types->GetNumberOfTuples() : 0) != cells)
  {
    return "the number of cell types differs from the number of cells";
  }
  LeastPoints least;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const int type = types->GetValue(cell);
    const int points = least.Of(type);
    if (points < 0 || grid->GetCells()->GetCellSize(cell) < points)
    {
      return "cell " + std::to_string(cell) + " has " + std::to_string(grid->GetCells()->GetCellSize(cell)) +
             " points, which does not fit its type " + std::to_string(type);
    }
  }
  return "";
}

/// The faces of polyhedra: [number of faces, {number of points, points...}...] at the place of each.
bool IsPolyhedronValid(vtkIdTypeArray* faces, vtkIdType at, vtkIdType points)
{
  const vtkIdType size = faces->GetNumberOfTuples();
  if (at < 0 || at >= size)
  {
    return false;
  }
  vtkIdType next = at + 1;
  for (vtkIdType left = faces->GetValue(at); left > 0; --left)
  {
    const vtkIdType corners = next < size ? faces->GetValue(next) : -1;
    if (corners < 1 || corners > size - next - 1)
    {
      return false;
    }
    for (vtkIdType i = next + 1; i <= next + corners; ++i)
    {
      if (faces->GetValue(i) < 0 || faces->GetValue(i) >= points)
      {
        return false;
      }
    }
    next += corners + 1;
  }
  return true;
}

std::string CheckPolyhedra(vtkUnstructuredGrid* grid)
{
  vtkIdTypeArray* faces = grid->GetFaces();
  vtkIdTypeArray* places = grid->GetFaceLocations();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const bool polyhedron = grid->GetCellType(cell) == VTK_POLYHEDRON;
    if (polyhedron && (!faces || !places || cell >= places->GetNumberOfTuples() ||
                        !IsPolyhedronValid(faces, places->GetValue(cell), grid->GetNumberOfPoints())))
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
