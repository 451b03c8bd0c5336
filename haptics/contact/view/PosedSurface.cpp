// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/view/PosedSurface.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/mesh/ExactPredicates.h"

namespace palpate
{

FaceRecord PosedSurface::face(std::uint32_t triangle) const noexcept
{
  FaceRecord face = this->shape_.face(triangle);
  this->place(face.corner_W);
  face.normal_W = this->turned(face.normal_W);
  return face;
}

int PosedSurface::sideOf(std::uint32_t triangle, const Vec3& x_W) const noexcept
{
  const auto& [a, b, c] = this->shape_.cornersOf(triangle);
  return orientation(a, b, c, this->toSurface(x_W));
}

SweptBall PosedSurface::toSurface(const SweptBall& m) const noexcept
{
  SweptBall moved = m;
  moved.x_W = this->toSurface(m.x_W);
  moved.e_W = this->toSurface(m.e_W);
  moved.d = moved.e_W - moved.x_W;
  moved.dd = moved.d.squaredNorm();
  moved.length = std::sqrt(moved.dd);
  Resolution resolution;
  resolution.include(moved.x_W);
  resolution.include(moved.e_W);
  resolution.include(this->shift_W_);
  moved.tol = m.tol + resolution.tol();
  moved.magnitude = std::max(m.magnitude, resolution.magnitude);
  return moved;
}

} // namespace palpate
