// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/core/Across.h"

namespace palpate
{

/// Tangential motion of a tool's point at its contact, as columns that multiply a whitened motion.
using Tangents = Eigen::Matrix<double, 6, 2>;

[[nodiscard]] inline Tangents tangentsOf(const Vec3& n_W, const Vec3& arm_W, double characteristic_u) noexcept
{
  const auto [first, second] = tangentsOf(n_W);
  Tangents along;
  along.col(0) << first, arm_W.cross(first) / characteristic_u;
  along.col(1) << second, arm_W.cross(second) / characteristic_u;
  return along;
}

/// Larger eigenvalue of the product of the two columns: steps of its inverse never overshoot.
[[nodiscard]] inline double stiffest(const Tangents& along) noexcept
{
  const double a = along.col(0).squaredNorm(), b = along.col(1).squaredNorm(), c = along.col(0).dot(along.col(1));
  return 0.5 * (a + b + std::sqrt((a - b) * (a - b) + 4.0 * c * c));
}

} // namespace palpate
