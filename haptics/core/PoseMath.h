// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// Poses compose as rigid transforms do: a_WS * p_S is p_W, and a_WS * b_SB is the pose of B in W. Inverses are of unit
/// quaternions.

[[nodiscard]] inline Vec3 operator*(const Pose& a, const Vec3& p) noexcept
{
  return a.p + a.q * p;
}

[[nodiscard]] inline Pose operator*(const Pose& a, const Pose& b) noexcept
{
  return { a * b.p, a.q * b.q };
}

/// inverse(a) * p, with one rounding less than an inverse pose would have.
[[nodiscard]] inline Vec3 into(const Pose& a, const Vec3& p) noexcept
{
  return a.q.conjugate() * (p - a.p);
}

[[nodiscard]] inline Pose into(const Pose& a, const Pose& b) noexcept
{
  return { into(a, b.p), a.q.conjugate() * b.q };
}

} // namespace palpate
