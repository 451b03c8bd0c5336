// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "haptics/core/Types.h"

namespace palpate::test
{

/// A hand that winds around a ball of 50 mm with one of 15 mm, turning by 1.5 rad/s, and presses and lets go five times
/// a second: 1 mm free to 4 mm deep.
inline Pose windingHand(double time_s, double speed_mm_s)
{
  constexpr double round_mm = 65.0, press_Hz = 5.0, turn_rad_s = 1.5;
  const double along = speed_mm_s * time_s / round_mm, tilt = 0.5 * std::sin(0.3 * along);
  const double depth_mm = 1.5 + 2.5 * std::sin(2.0 * std::numbers::pi * press_Hz * time_s);
  const Vec3 direction(std::cos(along) * std::cos(tilt), std::sin(along) * std::cos(tilt), std::sin(tilt));
  return { (round_mm - depth_mm) * direction, Quat(Eigen::AngleAxisd(turn_rad_s * time_s, Vec3(1, 2, 2) / 3.0)) };
}

} // namespace palpate::test
