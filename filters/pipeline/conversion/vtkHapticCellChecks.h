// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCellChecks_h
#define vtkHapticCellChecks_h

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

/// VTK's filters trust the indices of a data set; a file may hold any. To be called before any filter runs on the
/// output of a reader. Each returns an empty string, or the fault.
namespace vtkHapticCellChecks
{
[[nodiscard]] std::string CheckPolyData(vtkPolyData* data);
[[nodiscard]] std::string CheckGrid(vtkUnstructuredGrid* grid);
} // namespace vtkHapticCellChecks

#endif
