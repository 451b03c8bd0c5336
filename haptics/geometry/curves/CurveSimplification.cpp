// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/CurveSimplification.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

struct Span
{
  std::uint32_t from, to;
};

struct Farthest
{
  std::uint32_t index = 0;
  double distance_u = -1.0;
};

Farthest farthest(std::span<const Vec3> points_W, const Span& span)
{
  Farthest found;
  for (std::uint32_t i = span.from + 1; i < span.to; ++i)
  {
    const double distance_u = distanceToSegment(points_W[i], points_W[span.from], points_W[span.to]);
    if (distance_u > found.distance_u)
    {
      found = { i, distance_u };
    }
  }
  return found;
}

} // namespace

double distanceToSegment(const Vec3& p_W, const Vec3& a_W, const Vec3& b_W) noexcept
{
  const Vec3 along = b_W - a_W, to = p_W - a_W;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(to.dot(along) / length2, 0.0, 1.0) : 0.0;
  return (to - share * along).norm();
}

SimplifiedCurve simplify(std::span<const Vec3> points_W, double tolerance_u)
{
  SimplifiedCurve result;
  const auto count = static_cast<std::uint32_t>(points_W.size());
  if (count == 0)
  {
    return result;
  }
  result.kept.push_back(0);
  const bool ring = count > 2 && points_W.front() == points_W.back();
  std::vector<Span> open;
  if (count > 1)
  {
    open.push_back({ 0, count - 1 });
  }
  // The left part of a span is looked at first, so the points that stay come in their order.
  while (!open.empty())
  {
    const Span span = open.back();
    open.pop_back();
    const Farthest far = farthest(points_W, span);
    const bool whole = span.from == 0 && span.to == count - 1;
    if (far.distance_u > tolerance_u || (ring && whole && far.distance_u > 0.0))
    {
      open.push_back({ far.index, span.to });
      open.push_back({ span.from, far.index });
      continue;
    }
    result.error_u = std::max(result.error_u, far.distance_u);
    result.kept.push_back(span.to);
  }
  return result;
}

} // namespace palpate
