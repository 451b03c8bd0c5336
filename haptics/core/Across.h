// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

/// A direction at right angles to a unit vector, by the axis that is far from it.
[[nodiscard]] inline Vec3 acrossOf(const Vec3& n) noexcept
{
  const Vec3 axis = std::abs(n.x()) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
  return n.cross(axis).normalized();
}

/// Two directions that make a right-handed frame with it, after it.
[[nodiscard]] inline std::array<Vec3, 2> tangentsOf(const Vec3& n) noexcept
{
  const Vec3 first = acrossOf(n);
  return { first, n.cross(first) };
}

} // namespace palpate
