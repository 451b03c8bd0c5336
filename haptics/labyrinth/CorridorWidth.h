// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/labyrinth/Labyrinth.h"

namespace palpate
{

/// The width of the corridors of a maze that does not say its own [u]: the narrowest place of the widest path from
/// start to exit within the fence (bottleneck path, Pollack 1960), found on a grid of 512 steps along the longer side.
/// The result is at most three steps less than the true width, and at most one more. Nothing where there is no path
/// wider than a step, nor for a labyrinth that refuse() refuses.
[[nodiscard]] std::optional<double> corridorWidth(const Labyrinth& labyrinth);

} // namespace palpate
