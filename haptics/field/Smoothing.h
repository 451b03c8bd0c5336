// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/field/cells/GridPlace.h"

namespace palpate
{

/// Above this noise, in spacings of the grid, pits of the noise trap a proxy, and a field is smoothed once unless a
/// person says otherwise: at half a spacing 97 of 100 ticks were trapped, after one pass none.
inline constexpr double trappingNoise = 0.2;

/// The same values after `passes` weightings by (1, 2, 1) / 4 along each axis. Where a neighbour along an axis is
/// missing, at the rim or beside a NaN, nothing is mixed along that axis: a field that is linear stays as it is
/// everywhere, to rounding.
[[nodiscard]] std::vector<float> smoothed(std::vector<float> values, const GridIndex& size, int passes);

/// How far the noise of the values moves the surface f = level, in spacings of the grid: the median of |f - smoothed f|
/// over |gradient of smoothed f| at the points beside the surface. White noise that moves it by one standard deviation
/// gives 0.60 of that. 0 where there is no such surface, and where f - smoothed f goes on from point to point: that is
/// a wave or a bend of the data, not noise.
[[nodiscard]] double measuredNoise(const std::vector<float>& values, const GridIndex& size, double level);

} // namespace palpate
