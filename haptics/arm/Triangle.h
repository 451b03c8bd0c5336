// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{

/// The angle [rad] between sides a and b of a triangle, opposite to c, without cancellation (Kahan, Miscalculating area
/// and angles of a needle-like triangle, 2014): a stretched arm loses no digits. Nothing where no triangle closes.
[[nodiscard]] inline std::optional<double> angleBetween(double a, double b, double c) noexcept
{
  if (a < b)
  {
    std::swap(a, b);
  }
  const double narrow = b >= c ? c - (a - b) : b - (a - c);
  const double far = (a - c) + b;
  if (!(b > 0.0 && narrow >= 0.0 && far >= 0.0))
  {
    return std::nullopt;
  }
  return 2.0 * std::atan2(std::sqrt(((a - b) + c) * narrow), std::sqrt((a + (b + c)) * far));
}

} // namespace palpate
