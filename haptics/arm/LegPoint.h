// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/arm/ArmTypes.h"

namespace palpate
{

/// The point at a share of the distance from one point to another.
[[nodiscard]] inline LinkPoint between(const LinkPoint& from, const LinkPoint& to, double share) noexcept
{
  return { from.p + share * (to.p - from.p), from.jacobian + share * (to.jacobian - from.jacobian) };
}

[[nodiscard]] inline LinkPoint tipOf(const Posture& posture) noexcept
{
  return { posture.tip.p, posture.jacobian.topRows<3>() };
}

} // namespace palpate
