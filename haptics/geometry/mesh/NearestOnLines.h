// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// The nearest points of two lines through a and b along u and v, as multiples of u and v; false where they are
/// parallel. Where the lines are nearly parallel, cancellation shifts the first point along its line. The second point is
/// the nearest one to the first, so that the shift changes the distance of the two points to second order only.
[[nodiscard]] inline bool nearestOnLines(
  const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v, double& onA, double& onB) noexcept
{
  constexpr double parallelBelow = 1e-16; // sine squared
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = u.cross(v).squaredNorm();
  if (!(determinant > parallelBelow * uu * vv))
  {
    return false;
  }
  const Vec3 d = a - b;
  onA = (uv * v.dot(d) - vv * u.dot(d)) / determinant;
  onB = v.dot(d + onA * u) / vv;
  return true;
}

} // namespace palpate
