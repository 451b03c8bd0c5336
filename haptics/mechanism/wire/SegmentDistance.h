// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate
{

/// Nearest places of two segments: how far along the first, from 0 to 1, and the place on the second.
struct SegmentPair
{
  double along = 0.0;
  Vec3 on = Vec3::Zero();
  double away_u = std::numeric_limits<double>::infinity();
};

/// Of the segments from a to b and from c to d, which have a length each (Ericson 2005, section 5.1.9).
[[nodiscard]] inline SegmentPair nearestOfSegments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept
{
  const Vec3 first = b - a, second = d - c, between = a - c;
  const double aa = first.squaredNorm(), ee = second.squaredNorm(), f = second.dot(between);
  const double ca = first.dot(between), ab = first.dot(second);
  const double across = aa * ee - ab * ab;
  double s = across > 0.0 ? std::clamp((ab * f - ca * ee) / across, 0.0, 1.0) : 0.0;
  double t = (ab * s + f) / ee;
  if (t < 0.0 || t > 1.0)
  {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((t * ab - ca) / aa, 0.0, 1.0);
  }
  const Vec3 on = c + t * second;
  return { s, on, (a + s * first - on).norm() };
}

/// Distance of a segment from a triangle that it does not cross.
[[nodiscard]] inline double awayFromTriangle(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& corner) noexcept
{
  double away_u = std::min((nearestOnTriangle(a, corner[0], corner[1], corner[2]) - a).norm(),
    (nearestOnTriangle(b, corner[0], corner[1], corner[2]) - b).norm());
  for (int k = 0; k < 3; ++k)
  {
    away_u = std::min(away_u, nearestOfSegments(a, b, corner[k], corner[(k + 1) % 3]).away_u);
  }
  return away_u;
}

} // namespace palpate
