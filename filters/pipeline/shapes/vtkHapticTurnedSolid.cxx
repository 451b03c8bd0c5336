// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTurnedSolid.h"

#include <cmath>
#include <numbers>

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
void AddRing(const vtkHapticRing& ring, int around, vtkPoints* points)
{
  for (int i = 0; i < around; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / around;
    const double radius = ring.Radius(angle);
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), ring.Height);
  }
}

void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkCellArray* triangles)
{
  const vtkIdType corners[3] = { a, b, c };
  triangles->InsertNextCell(3, corners);
}

double FromAxis(vtkPoints* points, vtkIdType id)
{
  const double* const p = points->GetPoint(id);
  return std::hypot(p[0], p[1]);
}

/// How unlike the ends of a band's diagonals are in their distance from the axis, all together: from each corner of one
/// ring to the one of the other that is so many corners further on.
double Unlike(vtkIdType from, vtkIdType to, int further, int around, vtkPoints* points)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < around; ++i)
  {
    sum += std::abs(FromAxis(points, from + i) - FromAxis(points, to + (i + further + around) % around));
  }
  return sum;
}

/// The band from one ring to the next. The diagonals join the ends that are more alike: on a thread along its crest,
/// where the others would cut it.
void AddBand(int ring, int next, int around, vtkPoints* points, vtkCellArray* triangles)
{
  const vtkIdType from = static_cast<vtkIdType>(ring) * around, to = static_cast<vtkIdType>(next) * around;
  const bool back = Unlike(from, to, -1, around, points) < Unlike(from, to, 1, around, points);
  for (vtkIdType i = 0; i < around; ++i)
  {
    const vtkIdType j = (i + 1) % around;
    AddTriangle(from + i, from + j, back ? to + i : to + j, triangles);
    AddTriangle(back ? from + j : from + i, to + j, to + i, triangles);
  }
}

/// From a ring to a point of the axis at its height. `ahead`: it is the end of the solid, not its beginning.
void AddFan(const vtkHapticRing& ring, int index, int around, bool ahead, vtkPoints* points, vtkCellArray* triangles)
{
  const vtkIdType pole = points->InsertNextPoint(0.0, 0.0, ring.Height);
  for (vtkIdType i = 0; i < around; ++i)
  {
    const vtkIdType a = static_cast<vtkIdType>(index) * around + i;
    const vtkIdType b = static_cast<vtkIdType>(index) * around + (i + 1) % around;
    AddTriangle(pole, ahead ? a : b, ahead ? b : a, triangles);
  }
}
} // namespace

void vtkHapticTurnSolid(const std::vector<vtkHapticRing>& rings, int around, bool bore, vtkPolyData* solid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const int count = static_cast<int>(rings.size());
  for (const vtkHapticRing& ring : rings)
  {
    AddRing(ring, around, points);
  }
  for (int i = 0; i < (bore ? count : count - 1); ++i)
  {
    AddBand(i, (i + 1) % count, around, points, triangles);
  }
  if (!bore)
  {
    AddFan(rings.front(), 0, around, false, points, triangles);
    AddFan(rings.back(), count - 1, around, true, points, triangles);
  }
  solid->SetPoints(points);
  solid->SetPolys(triangles);
}
