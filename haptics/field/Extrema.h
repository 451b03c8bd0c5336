// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// A place where a scalar is larger or smaller than all around.
struct Extremum
{
  Vec3 p_W = Vec3::Zero();
  double value = 0.0;
  double prominence = 0.0; ///< difference to the mean of its 26 neighbours: how clearly it stands out
  bool highest = true;     ///< else lowest
};

/// Points of the grid whose value is above, or below, those of all 26 neighbours; a trilinear field has its extrema at
/// points. Not at the rim nor beside a point without value. The clearest `most` come first.
[[nodiscard]] std::vector<Extremum> findExtrema(const FieldBlock& brick, std::size_t most);

} // namespace palpate
