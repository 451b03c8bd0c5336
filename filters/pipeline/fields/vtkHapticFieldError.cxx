// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldError.h"

#include <algorithm>
#include <cmath>

using palpate::FieldBlockGrid;
using palpate::Vec3;

namespace
{
/// Points in the middle of cells, evenly over the grid.
FieldBlockGrid MiddlesOf(const FieldBlockGrid& grid)
{
  constexpr int most = 12;
  FieldBlockGrid middles = grid;
  Vec3 first;
  for (int k = 0; k < 3; ++k)
  {
    const int cells = grid.size[k] - 1, step = std::max(1, cells / most);
    middles.size[k] = (cells - 1) / step + 1;
    middles.spacing_u[k] = step * grid.spacing_u[k];
    first[k] = 0.5;
  }
  middles.pose_W.p = grid.toWorld(first);
  return middles;
}
} // namespace

double vtkHapticFieldError(
  const palpate::FieldBlock& brick, const vtkHapticFieldPart& part, const HapticFieldCells& cells)
{
  if (palpate::componentsOf(part.Role) != 1)
  {
    return 0.0;
  }
  const FieldBlockGrid middles = MiddlesOf(brick.grid());
  const std::vector<float> values = cells(part, middles);
  double largest = 0.0, low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto row = static_cast<std::size_t>(middles.size[0]), layer = row * static_cast<std::size_t>(middles.size[1]);
    const Vec3 index(1.0 * (i % row), 1.0 * (i % layer / row), 1.0 * (i / layer));
    const auto sample = brick.sample(part.Role, middles.toWorld(index));
    if (sample && std::isfinite(values[i]))
    {
      largest = std::max(largest, std::abs(sample->value - part.Offset - values[i]));
      low = std::min(low, sample->value);
      high = std::max(high, sample->value);
    }
  }
  return high > low ? largest / (high - low) : 0.0;
}
