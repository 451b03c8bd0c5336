// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/DeviceSample.h"

namespace palpate
{

/// Controls that a hand must hold for a force to be given. None of both: nothing.
struct DeadMan
{
  std::uint32_t buttons = 0; ///< bit i: button i + 1 will do
  bool grip = false;         ///< the grip sensor will do

  friend bool operator==(const DeadMan&, const DeadMan&) = default;
};

/// True if nothing must be held, or any of it is. Pure; real-time safe.
[[nodiscard]] constexpr bool isHeld(const DeadMan& deadMan, std::uint32_t buttons, bool grip) noexcept
{
  const bool nothing = deadMan.buttons == 0 && !deadMan.grip;
  return nothing || (deadMan.buttons & buttons) != 0 || (deadMan.grip && grip);
}

} // namespace palpate
