// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/contact/view/SweepQuery.h"

namespace palpate
{

/// The part of a query that is the same for all leaves.
struct SweptBall
{
  Vec3 x_W, e_W, d;
  double r, del, tol, magnitude;
  double length;
  double dd; ///< |d|^2
};

[[nodiscard]] inline SweptBall sweptBallOf(const SweepQuery& q) noexcept
{
  SweptBall m;
  m.x_W = q.from_W;
  m.e_W = q.to_W;
  m.d = q.to_W - q.from_W;
  m.r = q.radius_u;
  m.del = q.resolution.del();
  m.tol = q.resolution.tol();
  m.magnitude = q.resolution.magnitude;
  m.dd = m.d.squaredNorm();
  m.length = std::sqrt(m.dd);
  return m;
}

/// The same way of a ball that is larger by the coat of a surface, which lies as near as the surface was.
[[nodiscard]] inline SweptBall coated(SweptBall m, double coat_u) noexcept
{
  m.r += coat_u;
  Resolution resolution;
  resolution.include(Vec3::Constant(m.r));
  m.tol = std::max(m.tol, resolution.tol());
  return m;
}

} // namespace palpate
