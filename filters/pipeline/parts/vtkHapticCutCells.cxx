// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCutCells.h"

#include <algorithm>

#include "vtkCellData.h"
#include "vtkHapticSurfaceCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace
{
vtkSmartPointer<vtkIdList> ListOf(const std::vector<vtkIdType>& ids, vtkIdType plus = 0)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  list->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::transform(ids.begin(), ids.end(), list->GetPointer(0), [plus](vtkIdType id) { return id + plus; });
  return list;
}

/// From `from`, as many as there are.
void TakeRows(vtkDataSetAttributes* all, vtkIdList* from, vtkDataSetAttributes* taken)
{
  taken->CopyAllOn();
  taken->CopyAllocate(all, from->GetNumberOfIds());
  vtkNew<vtkIdList> to;
  to->SetNumberOfIds(from->GetNumberOfIds());
  for (vtkIdType i = 0; i < to->GetNumberOfIds(); ++i)
  {
    to->SetId(i, i);
  }
  taken->CopyData(all, from, to);
}
} // namespace

std::vector<vtkIdType> vtkHapticPointsOfCells(vtkPolyData* surface, const std::vector<vtkIdType>& cells)
{
  std::vector<vtkIdType> points;
  for (const vtkIdType cell : cells)
  {
    const auto own = vtkHapticSurfaceCell(surface, cell);
    points.insert(points.end(), own.begin(), own.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

bool vtkHapticSharesPoint(vtkPolyData* surface, vtkIdType cell, const std::vector<vtkIdType>& points)
{
  const auto own = vtkHapticSurfaceCell(surface, cell);
  return std::any_of(own.begin(), own.end(),
    [&points](vtkIdType point) { return std::binary_search(points.begin(), points.end(), point); });
}

vtkSmartPointer<vtkPolyData> vtkHapticCutCells(vtkPolyData* surface, std::vector<vtkIdType> cells)
{
  std::sort(cells.begin(), cells.end());
  const std::vector<vtkIdType> points = vtkHapticPointsOfCells(surface, cells);
  vtkNew<vtkPoints> places;
  places->SetDataType(surface->GetPoints() ? surface->GetPoints()->GetDataType() : VTK_FLOAT);
  places->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  if (!points.empty())
  {
    places->GetData()->InsertTuplesStartingAt(0, ListOf(points), surface->GetPoints()->GetData());
  }
  vtkNew<vtkCellArray> polygons, strips;
  std::vector<vtkIdType> own;
  for (const vtkIdType cell : cells)
  {
    const auto was = vtkHapticSurfaceCell(surface, cell);
    own.resize(was.size());
    std::transform(was.begin(), was.end(), own.begin(),
      [&points](vtkIdType point) { return std::lower_bound(points.begin(), points.end(), point) - points.begin(); });
    vtkCellArray* const to = vtkHapticIsStrip(surface, cell) ? strips : polygons;
    to->InsertNextCell(static_cast<vtkIdType>(own.size()), own.data());
  }
  cut->SetPoints(places);
  cut->SetPolys(polygons);
  cut->SetStrips(strips);
  TakeRows(surface->GetPointData(), ListOf(points), cut->GetPointData());
  // Cells of a surface are counted from its vertices and lines on.
  TakeRows(surface->GetCellData(), ListOf(cells, surface->GetNumberOfVerts() + surface->GetNumberOfLines()),
    cut->GetCellData());
  return cut;
}
