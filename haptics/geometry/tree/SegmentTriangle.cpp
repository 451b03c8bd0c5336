// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/SegmentTriangle.h"

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

// Segment and triangle are apart if an edge of the triangle or the segment itself is a separating line.
bool meetsInPlane(const Vec3& p, const Vec3& q, const FaceRecord& face) noexcept
{
  int drop = 0;
  face.normal_W.cwiseAbs().maxCoeff(&drop);
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const auto turn = [i, j](const Vec3& a, const Vec3& b, const Vec3& c)
  { return orientation2(a[i], a[j], b[i], b[j], c[i], c[j]); };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 &a = face.corner_W[k], &b = face.corner_W[(k + 1) % 3], &c = face.corner_W[(k + 2) % 3];
    const int inside = turn(a, b, c);
    if (turn(a, b, p) == -inside && turn(a, b, q) == -inside)
    {
      return false;
    }
  }
  const int u = turn(p, q, face.corner_W[0]), v = turn(p, q, face.corner_W[1]), w = turn(p, q, face.corner_W[2]);
  return !(u == v && v == w && u != 0);
}

bool linePassesThrough(const Vec3& p, const Vec3& q, const FaceRecord& face) noexcept
{
  const auto& [a, b, c] = face.corner_W;
  const int u = orientation(p, q, a, b), v = orientation(p, q, b, c), w = orientation(p, q, c, a);
  const bool positive = u > 0 || v > 0 || w > 0, negative = u < 0 || v < 0 || w < 0;
  return !(positive && negative);
}

} // namespace palpate
