// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSnapPlaces.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkHapticFieldWindow.h"
#include "vtkIdList.h"
#include "vtkNew.h"

using palpate::Vec3;

namespace
{
bool IsPoints(int type)
{
  return type == VTK_VERTEX || type == VTK_POLY_VERTEX;
}

bool IsLine(int type)
{
  return type == VTK_LINE || type == VTK_POLY_LINE;
}

Vec3 PointOf(vtkDataSet& part, vtkIdType point)
{
  Vec3 p_W;
  part.GetPoint(point, p_W.data());
  return p_W;
}

void AddCell(vtkDataSet& part, vtkIdType cell, vtkIdList* corners, palpate::SnapPlaces& places)
{
  part.GetCellPoints(cell, corners);
  const bool line = IsLine(part.GetCellType(cell));
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    const Vec3 p_W = PointOf(part, corners->GetId(i));
    if (!line)
    {
      places.points_W.push_back(p_W);
    }
    else if (i > 0)
    {
      places.lines_W.push_back({ PointOf(part, corners->GetId(i - 1)), p_W });
    }
  }
}

void AddPart(vtkDataSet& part, palpate::SnapPlaces& places)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < part.GetNumberOfCells(); ++i)
  {
    if (IsPoints(part.GetCellType(i)) || IsLine(part.GetCellType(i)))
    {
      AddCell(part, i, corners, places);
    }
  }
  for (vtkIdType i = 0; part.GetNumberOfCells() == 0 && i < part.GetNumberOfPoints(); ++i)
  {
    places.points_W.push_back(PointOf(part, i));
  }
}

/// Places that are no numbers are nowhere.
void KeepFinite(palpate::SnapPlaces& places)
{
  std::erase_if(places.points_W, [](const Vec3& p_W) { return !p_W.allFinite(); });
  std::erase_if(places.lines_W,
    [](const palpate::FieldBlockLine& line_W) { return !(line_W[0].allFinite() && line_W[1].allFinite()); });
}
} // namespace

vtkHapticSnapPlacesResult vtkHapticToSnapPlaces(vtkDataObject* data)
{
  vtkHapticSnapPlacesResult result;
  for (vtkDataSet* part : vtkHapticFieldSets(data))
  {
    AddPart(*part, result.Places);
  }
  KeepFinite(result.Places);
  if (result.Places.points_W.empty() && result.Places.lines_W.empty())
  {
    result.Problem = "the target of the snap has only faces or cells: choose data with points or lines";
  }
  return result;
}
