// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/Extrema.h"

#include <algorithm>

namespace palpate
{
namespace
{

/// Comparison of an inner point with its 26 neighbours.
struct Around
{
  int below = 0, above = 0;
  double sum = 0.0;
};

Around lookAround(const FieldBlockComponent& field, const GridIndex& at, double value) noexcept
{
  Around around;
  for (int i = 0; i < 27; ++i)
  {
    const double other = field.at({ at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1 });
    around.below += other < value;
    around.above += other > value;
    around.sum += other;
  }
  around.sum -= value;
  return around;
}

} // namespace

std::vector<Extremum> findExtrema(const FieldBlock& brick, std::size_t most)
{
  const FieldBlockComponent field = brick.component(FieldBlockRole::Scalar);
  std::vector<Extremum> found;
  const GridIndex size = field.exists() ? field.size() : GridIndex{};
  for (int z = 1; z + 1 < size[2]; ++z)
  {
    for (int y = 1; y + 1 < size[1]; ++y)
    {
      for (int x = 1; x + 1 < size[0]; ++x)
      {
        const GridIndex at{ x, y, z };
        const double value = field.at(at);
        const Around around = lookAround(field, at, value);
        if (around.below == 26 || around.above == 26)
        {
          found.push_back(
            { brick.grid().toWorld(Vec3(x, y, z)), value, std::fabs(value - around.sum / 26.0), around.below == 26 });
        }
      }
    }
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &Extremum::prominence);
  found.resize(std::min(found.size(), most));
  return found;
}

} // namespace palpate
