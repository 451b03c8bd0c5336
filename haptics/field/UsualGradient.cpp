// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/UsualGradient.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace palpate
{

double usualGradient(const FieldBlock& brick)
{
  constexpr int across = 16; // along each axis: some thousand places, which is microseconds
  const FieldBlockGrid& grid = brick.grid();
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < across * across * across; ++i)
  {
    const std::array<int, 3> step{ i % across, i / across % across, i / (across * across) };
    Vec3 index;
    for (int k = 0; k < 3; ++k)
    {
      const int cells = grid.size[k] - 1;
      index[k] = std::min(cells - 1, step[k] * cells / across) + 0.5;
    }
    if (const std::optional<FieldSample> sample = brick.sample(FieldBlockRole::Scalar, grid.toWorld(index)))
    {
      sum += sample->gradient_W.squaredNorm();
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

} // namespace palpate
