// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticClosedLevel.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double openShare = 0.02; ///< of the points at the border, above the level
constexpr double leastStep = 0.05; ///< of the range, from the highest at the border to the highest of all

struct Border
{
  vtkIdType Points = 0;
  vtkIdType Above = 0; ///< of the level
  double Highest = std::numeric_limits<double>::lowest();
};

bool DimensionsOf(vtkDataObject* data, int size[3])
{
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(size);
    return true;
  }
  if (auto* const grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(size);
    return true;
  }
  auto* const grid = vtkStructuredGrid::SafeDownCast(data);
  if (grid)
  {
    grid->GetDimensions(size);
  }
  return grid != nullptr;
}

Border BorderOf(vtkDataArray& values, const int size[3], double level)
{
  Border border;
  vtkIdType at = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const bool whole = k == 0 || k + 1 == size[2] || j == 0 || j + 1 == size[1];
      const int step = whole ? 1 : std::max(1, size[0] - 1); // of a row within, its two ends
      for (int i = 0; i < size[0]; i += step)
      {
        const double value = values.GetComponent(at + i, 0);
        ++border.Points;
        border.Above += value > level;
        border.Highest = std::max(border.Highest, value);
      }
      at += size[0];
    }
  }
  return border;
}
} // namespace

double vtkHapticClosedLevel(vtkDataObject* data, const std::string& array, double level)
{
  int size[3];
  auto* const set = vtkDataSet::SafeDownCast(data);
  vtkDataArray* const values = set ? set->GetPointData()->GetArray(array.c_str()) : nullptr;
  if (!values || values->GetNumberOfComponents() != 1 || !DimensionsOf(data, size))
  {
    return level;
  }
  if (std::min({ size[0], size[1], size[2] }) < 2) // all of an image of one slice is its border
  {
    return level;
  }
  const Border border = BorderOf(*values, size, level);
  double range[2];
  values->GetFiniteRange(range, 0);
  const bool open = static_cast<double>(border.Above) > openShare * static_cast<double>(border.Points);
  const bool closes = range[1] - border.Highest > leastStep * (range[1] - range[0]);
  return open && closes ? 0.5 * (border.Highest + range[1]) : level;
}
