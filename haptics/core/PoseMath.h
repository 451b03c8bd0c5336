// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/core/Across.h"

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

/// The smallest rotation that takes the direction of one vector to that of another; both of any length but 0. Half of
/// the rotation leads to the direction halfway, so that no decomposition is needed and the quaternion keeps its length
/// next to half a turn. Opposite directions have none halfway: half a turn about a direction at right angles.
[[nodiscard]] inline Quat shortestTurn(const Vec3& from, const Vec3& to) noexcept
{
  constexpr double opposite = 2e-8; // from there on the sum's rounding turns it less than its length
  const Vec3 a = from.normalized(), sum = a + to.normalized();
  Quat turn;
  if (sum.norm() < opposite)
  {
    turn.w() = 0.0;
    turn.vec() = acrossOf(a);
    return turn;
  }
  const Vec3 halfway = sum.normalized();
  turn.w() = a.dot(halfway);
  turn.vec() = a.cross(halfway);
  return turn;
}

} // namespace palpate
