// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "testing/support/WireTube.h"

namespace palpate::test
{

inline constexpr double way_mm = 0.1;      // a tick: .1 m/s
inline constexpr double length_mm = 250.0; // of a wire

/// A tube that is straight, bends, and is straight again.
inline Tube bentTube()
{
  return { .first_mm = 40.0, .angle_rad = 0.75 * std::numbers::pi, .last_mm = 60.0, .around = 24, .ring_mm = 0.5 };
}

} // namespace palpate::test
