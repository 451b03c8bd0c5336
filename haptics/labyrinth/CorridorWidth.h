// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/labyrinth/Labyrinth.h"

namespace palpate
{

/// How wide the corridors of a maze are that does not say so [u]: the narrowest place of the widest way from its start
/// to its exit within the fence (bottleneck path, Pollack 1960), found on a grid of 512 steps along the longer side. It
/// is at most three steps less than the true width, and at most one more. Nothing where there is no way wider than a
/// step, and of what refuse() has something against.
[[nodiscard]] std::optional<double> corridorWidth(const Labyrinth& labyrinth);

} // namespace palpate
