// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "haptics/core/Types.h"

namespace palpate
{

/// The resolution of double precision at the ball, from the coordinates at hand,
/// never from the size of the scene.
struct Resolution
{
  double magnitude = 0.0; ///< largest coordinate in play [u]

  void include(const Vec3& v) noexcept { this->magnitude = std::max(this->magnitude, v.cwiseAbs().maxCoeff()); }

  /// Rounding of one computed coordinate [u]: a few operations at half an ulp each.
  [[nodiscard]] double del() const noexcept { return 4 * std::numeric_limits<double>::epsilon() * this->magnitude; }
  /// Lengths below this count as zero [u]. Sixteen del: distances are sums of products of rounded coordinates, and the
  /// tolerance of touching must exceed the rounding of each of them. A projection leaves a plane violated by a quarter
  /// of tol at most, so that the planes on which the ball rests still touch. A move below 4 tol is no progress: each
  /// end is known to tol only.
  [[nodiscard]] double tol() const noexcept { return 64 * std::numeric_limits<double>::epsilon() * this->magnitude; }
  /// Largest violation of a plane after a projection [u].
  [[nodiscard]] double slack() const noexcept { return 0.25 * this->tol(); }
  /// The largest error of a plane or of a corner that is believed [u], 6e-11 of a coordinate: a larger error,
  /// as the normal of a sliver or the line of two planes that are all but parallel, tells nothing.
  [[nodiscard]] double mostError() const noexcept { return 4096 * this->tol(); }
};

} // namespace palpate
