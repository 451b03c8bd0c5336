// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace palpate::lab
{

// The least that a hand feels (docs/theory.md, "What a hand tells apart").
inline constexpr double forceJnd = 0.07;                                ///< change of a force, as a share of it
inline constexpr double directionJnd_rad = 18 * std::numbers::pi / 180; ///< turn of a force
inline constexpr double leastForce_N = 0.07;                            ///< force where there was none

} // namespace palpate::lab
