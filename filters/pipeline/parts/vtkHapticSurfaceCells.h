// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfaceCells_h
#define vtkHapticSurfaceCells_h

#include <span>

#include "vtkCellArray.h"
#include "vtkPolyData.h"

/// Polygons and strips of a surface, counted through.
[[nodiscard]] inline vtkIdType vtkHapticCountSurfaceCells(vtkPolyData* surface)
{
  return surface->GetNumberOfPolys() + surface->GetNumberOfStrips();
}

[[nodiscard]] inline bool vtkHapticIsStrip(vtkPolyData* surface, vtkIdType cell)
{
  return cell >= surface->GetNumberOfPolys();
}

/// Of those, the points of one, until another is asked for.
[[nodiscard]] inline std::span<const vtkIdType> vtkHapticSurfaceCell(vtkPolyData* surface, vtkIdType cell)
{
  const bool strip = vtkHapticIsStrip(surface, cell);
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  vtkCellArray* const cells = strip ? surface->GetStrips() : surface->GetPolys();
  cells->GetCellAtId(strip ? cell - surface->GetNumberOfPolys() : cell, count, points);
  return { points, static_cast<std::size_t>(count) };
}

#endif
