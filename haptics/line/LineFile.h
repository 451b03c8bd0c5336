// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/line/LineWorld.h"

namespace palpate
{

/// A value along a path as text: a header with s and value and, if wanted, friction, in any order; then a line of
/// finite numbers per place, s [m of the hand] growing, friction in N:
///
///     s,value,friction
///     -0.04,12.5,0
///     0.04,17,0.2
///
/// Potentials are the values, as yet without a unit. Or one phrase with the number of the line.
[[nodiscard]] Outcome<std::vector<LinePlace>> parseLine(std::string_view text);

/// Makes the steepest slope of the values draw with that force: their unit becomes joules. Values that are all the same
/// stay flat.
void scaleToHardest(std::vector<LinePlace>& places, double hardest_N) noexcept;

} // namespace palpate
