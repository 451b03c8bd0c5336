// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCellBins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "vtkHapticSurfaceCells.h"
#include "vtkPolyData.h"

namespace
{
constexpr double cellsPerBin = 32.0; ///< fewer cost memory, more cost looking at cells that are elsewhere
constexpr double mostBins = 1e7;     ///< beyond that they are looked through no faster
} // namespace

vtkHapticCellBins::vtkHapticCellBins(vtkPolyData* surface) : Surface(surface)
{
  const auto count = static_cast<std::uint32_t>(vtkHapticCountSurfaceCells(surface));
  for (std::uint32_t cell = 0; cell < count; ++cell)
  {
    this->Bounds.AddBox(this->BoxOf(cell));
  }
  this->Cells.resize(count);
  this->LayGrid();
  std::vector<std::size_t> counts(this->Boxes.size(), 0);
  for (std::uint32_t cell = 0; cell < count; ++cell)
  {
    const vtkBoundingBox box = this->BoxOf(cell);
    const std::size_t bin = this->BinOf(box);
    this->Boxes[bin].AddBox(box);
    ++counts[bin];
  }
  this->First.assign(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), this->First.begin() + 1);
  std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
  for (std::uint32_t cell = 0; cell < count; ++cell)
  {
    this->Cells[next[this->BinOf(this->BoxOf(cell))]++] = cell;
  }
}

/// Bins as near to cubes as the box of the surface allows.
void vtkHapticCellBins::LayGrid()
{
  const double wanted = std::clamp(static_cast<double>(this->Cells.size()) / cellsPerBin, 1.0, mostBins);
  double lengths[3] = { 0.0, 0.0, 0.0 };
  if (this->Bounds.IsValid())
  {
    this->Bounds.GetLengths(lengths);
  }
  const double longest = std::max({ lengths[0], lengths[1], lengths[2] });
  double volume = 1.0;
  int wide = 0;
  for (double& length : lengths)
  {
    length = longest > 0.0 ? length / longest : 0.0;
    const bool counts = length > 1.0 / wanted;
    volume *= counts ? length : 1.0;
    wide += counts ? 1 : 0;
  }
  const double along = wide > 0 ? std::pow(wanted / volume, 1.0 / wide) : 1.0;
  std::transform(std::begin(lengths), std::end(lengths), std::begin(this->Size),
    [&](double length) { return static_cast<int>(std::clamp(std::ceil(along * length), 1.0, wanted)); });
  this->Boxes.resize(static_cast<std::size_t>(this->Size[0]) * static_cast<std::size_t>(this->Size[1]) *
                     static_cast<std::size_t>(this->Size[2]));
}

vtkBoundingBox vtkHapticCellBins::BoxOf(std::uint32_t cell) const
{
  vtkBoundingBox box;
  double place[3];
  for (const vtkIdType point : vtkHapticSurfaceCell(this->Surface, cell))
  {
    this->Surface->GetPoint(point, place);
    if (!std::all_of(place, place + 3, [](double x) { return std::isfinite(x); }))
    {
      return {};
    }
    box.AddPoint(place);
  }
  return box;
}

/// A cell whose places are no numbers has no box, and is in the first.
std::size_t vtkHapticCellBins::BinOf(const vtkBoundingBox& box) const
{
  std::size_t bin = 0;
  double centre[3] = { 0.0, 0.0, 0.0 };
  if (!box.IsValid())
  {
    return bin;
  }
  box.GetCenter(centre);
  for (int k = 2; k >= 0; --k)
  {
    const double length = this->Bounds.GetLength(k);
    const double share = length > 0.0 ? (centre[k] - this->Bounds.GetBound(2 * k)) / length : 0.0;
    const int at = std::clamp(static_cast<int>(share * this->Size[k]), 0, this->Size[k] - 1);
    bin = bin * static_cast<std::size_t>(this->Size[k]) + static_cast<std::size_t>(at);
  }
  return bin;
}

void vtkHapticCellBins::ForEachWithin(const vtkBoundingBox& box, const Visit& visit) const
{
  for (std::size_t bin = 0; bin < this->Boxes.size(); ++bin)
  {
    if (!this->Boxes[bin].IsValid() || !this->Boxes[bin].Intersects(box))
    {
      continue;
    }
    for (std::size_t i = this->First[bin]; i < this->First[bin + 1]; ++i)
    {
      const vtkBoundingBox own = this->BoxOf(this->Cells[i]);
      if (own.IsValid() && own.Intersects(box))
      {
        visit(this->Cells[i]);
      }
    }
  }
}
