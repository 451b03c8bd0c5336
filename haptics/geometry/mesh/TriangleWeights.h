// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// Barycentric coordinates of a point's foot in a triangle that has an area: none is below 0, they add up to 1.
[[nodiscard]] inline Vec3 weightsOnTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p_W) noexcept
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 normal = u.cross(v);
  const double area2 = normal.squaredNorm();
  const double wb = (p_W - a).cross(v).dot(normal) / area2;
  const double wc = u.cross(p_W - a).dot(normal) / area2;
  const Vec3 w = Vec3(1.0 - wb - wc, wb, wc).cwiseMax(0.0);
  return w / w.sum();
}

} // namespace palpate
