// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/iso/IsoSpace.h"

namespace palpate
{

/// The motion of a proxy that friction allows in a tick.
struct IsoFriction
{
  bool sticks = false;
  Vec3 shift_u = Vec3::Zero(); ///< from the hand to where it would have to be to draw a proxy without friction as far
};

/// The friction cone of the proxy on the patches that hold it, as judgeFriction() has it on surfaces (Harwin & Melder
/// 2002). `q_u`: from the proxy to the hand.
[[nodiscard]] IsoFriction judgeIsoFriction(
  const IsoSpace& space, const FrictionPlan& friction, const Vec3& q_u, IsoState& state) noexcept;

} // namespace palpate
