// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// Nearest point of a closed triangle (regions of its corners, edges and inside in turn).
[[nodiscard]] inline Vec3 nearestOnTriangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) noexcept
{
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(x - a), d2 = ac.dot(x - a);
  const double d3 = ab.dot(x - b), d4 = ac.dot(x - b);
  const double d5 = ab.dot(x - c), d6 = ac.dot(x - c);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0)
  {
    return a;
  }
  if (d3 >= 0 && d4 <= d3)
  {
    return b;
  }
  if (d6 >= 0 && d5 <= d6)
  {
    return c;
  }
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    return a + d1 / (d1 - d3) * ab;
  }
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    return a + d2 / (d2 - d6) * ac;
  }
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

} // namespace palpate
