// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCutCells_h
#define vtkHapticCutCells_h

#include <vector>

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;

/// Points of cells of a surface (vtkHapticSurfaceCells.h), each once, ascending.
[[nodiscard]] std::vector<vtkIdType> vtkHapticPointsOfCells(vtkPolyData* surface, const std::vector<vtkIdType>& cells);

/// Whether a cell has one of these points, which are ascending.
[[nodiscard]] bool vtkHapticSharesPoint(vtkPolyData* surface, vtkIdType cell, const std::vector<vtkIdType>& points);

/// Those cells alone, in the order of the surface, with the points that they have and all arrays. As long as the
/// answer takes, whatever the size of the surface.
[[nodiscard]] vtkSmartPointer<vtkPolyData> vtkHapticCutCells(vtkPolyData* surface, std::vector<vtkIdType> cells);

#endif
