// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

/// So far from length 1 are rotations and normals that are none: far more than products of turns leave.
inline constexpr double offUnitLength = 1e-6;

[[nodiscard]] inline bool isTurn(const Quat& q)
{
  return std::abs(q.norm() - 1.0) <= offUnitLength;
}

[[nodiscard]] inline bool isPlace(const Pose& pose)
{
  return pose.p.allFinite() && isTurn(pose.q);
}

} // namespace palpate
