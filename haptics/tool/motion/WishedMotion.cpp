// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/motion/WishedMotion.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{

Vec6 wishedMotion(const Pose& from_W, const Pose& to_W, double lever_u, bool& cut) noexcept
{
  constexpr double longestLead_rad = 1.5; // the logarithm changes its sign at half a turn
  const Vec3 turn_rad = turnFromTo(from_W.q, to_W.q);
  const Vec3 led_rad = clampMagnitude(turn_rad, longestLead_rad);
  cut = led_rad != turn_rad;
  return whitened(to_W.p - from_W.p, led_rad, lever_u);
}

} // namespace palpate
