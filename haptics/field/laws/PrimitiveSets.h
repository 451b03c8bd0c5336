// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "haptics/field/laws/Primitives.h"

namespace palpate
{

/// The part of a displacement that a primitive resists: all of it, across a line, along a plane's normal, none.
[[nodiscard]] inline Vec3 resisted(const Primitive& p, const Vec3& way) noexcept
{
  switch (p.kind)
  {
    case PrimitiveKind::Point:
      return way;
    case PrimitiveKind::Line:
      return way - p.axis.dot(way) * p.axis;
    case PrimitiveKind::Plane:
      return p.axis.dot(way) * p.axis;
    case PrimitiveKind::Directed:
      break;
  }
  return Vec3::Zero();
}

/// The pull nearest to a force that the strength of a primitive allows.
[[nodiscard]] inline Vec3 allowedPull(const Primitive& p, const Vec3& force_N) noexcept
{
  if (p.kind == PrimitiveKind::Directed)
  {
    return p.strength_N * p.axis;
  }
  if (p.kind == PrimitiveKind::Plane)
  {
    return std::clamp(p.axis.dot(force_N), 0.0, p.strength_N) * p.axis;
  }
  const Vec3 across_N = resisted(p, force_N);
  const double size_N = across_N.norm();
  return size_N <= p.strength_N ? across_N : Vec3(across_N * (p.strength_N / size_N));
}

/// How far a place is from where a primitive wants it [u].
[[nodiscard]] inline double missed(const Primitive& p, const Vec3& x) noexcept
{
  const Vec3 way = x - p.anchor;
  return p.kind == PrimitiveKind::Plane ? std::max(0.0, -p.axis.dot(way)) : resisted(p, way).norm();
}

} // namespace palpate
