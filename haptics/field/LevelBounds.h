// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "haptics/field/cells/GridPlace.h"

namespace palpate
{

/// How steep a scalar is and how much it bends, at most, anywhere in the data: the limit for the strength of smooth
/// levels. Infinite: they are unknown, and smooth levels do not hold. 0: nothing limits their strength.
struct LevelBounds
{
  double gradient_per_u = 0.0; ///< the largest norm of the gradient
  double bend_per_u2 = 0.0;    ///< the largest norm of the second derivatives

  friend bool operator==(const LevelBounds&, const LevelBounds&) = default;
  /// The bounds of two parts together.
  [[nodiscard]] LevelBounds with(const LevelBounds& other) const noexcept
  {
    return { std::max(this->gradient_per_u, other.gradient_per_u), std::max(this->bend_per_u2, other.bend_per_u2) };
  }
};

inline constexpr LevelBounds unknownLevels{ std::numeric_limits<double>::infinity(),
  std::numeric_limits<double>::infinity() };

/// Bounds for the quadratic B-spline (laws/SmoothScalar.h) of values at the points of a grid, x fastest. On each of its
/// cells the gradient and the second derivatives are polynomials, and a polynomial lies within the convex hull of its
/// Bernstein coefficients (Farin, Curves and Surfaces for CAGD): so the bounds hold, rounding of 1e-12 aside. They are
/// at most a twentieth larger than the largest coefficient. Infinite where a grid has fewer than three points along an
/// axis, since its function has creases. Values that are not finite have no function around them.
[[nodiscard]] LevelBounds levelBounds(std::span<const float> values, const GridIndex& size, const Vec3& spacing_u);

} // namespace palpate
