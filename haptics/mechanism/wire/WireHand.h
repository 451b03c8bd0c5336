// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/wire/WireTick.h"

namespace palpate
{

/// Place of the hand along the sheath, from its mouth on. Real-time safe.
[[nodiscard]] double handAlong_u(const WireInput& input) noexcept;

/// The outer end of a wire follows the hand, which leads it by at most so much and turns it, by the state. The result
/// is how far the hand has led it in this tick. Real-time safe.
[[nodiscard]] double takeWireHand(const WireInput& input, double most_u, WireState& state) noexcept;

} // namespace palpate
