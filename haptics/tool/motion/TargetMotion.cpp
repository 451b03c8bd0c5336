// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/motion/TargetMotion.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

constexpr double longestLead_rad = 1.5; // the logarithm changes its sign at half a turn

} // namespace

Vec6 wishedMotion(const Pose& from_W, const Pose& to_W, double characteristic_u, bool& cut) noexcept
{
  const Vec3 turn_rad = turnFromTo(from_W.q, to_W.q);
  const Vec3 led_rad = clampMagnitude(turn_rad, longestLead_rad);
  cut = led_rad != turn_rad;
  return whitened(to_W.p - from_W.p, led_rad, characteristic_u);
}

double wishedDistance2(const Pose& from_W, const Pose& to_W, double characteristic_u) noexcept
{
  bool cut = false;
  const double distance2 = wishedMotion(from_W, to_W, characteristic_u, cut).squaredNorm();
  const double over_rad = cut ? turnFromTo(from_W.q, to_W.q).norm() - longestLead_rad : 0.0;
  return distance2 + 2.0 * characteristic_u * characteristic_u * longestLead_rad * over_rad;
}

} // namespace palpate
