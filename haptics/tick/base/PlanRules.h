// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace palpate::stage
{

/// Tolerance for the length of a unit vector or quaternion.
inline constexpr double unitRounding = 1e-6;

[[nodiscard]] inline bool nonNegative(double value) noexcept
{
  return std::isfinite(value) && value >= 0.0;
}

} // namespace palpate::stage
