// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/PosedSurface.h"

#include <algorithm>

namespace palpate
{

FaceRecord PosedSurface::face(std::uint32_t triangle) const noexcept
{
  FaceRecord face = this->data_.face(triangle);
  for (Vec3& corner : face.corner_W)
  {
    corner = this->toWorld(corner);
  }
  face.normal_W = this->turned(face.normal_W);
  constexpr float roundedTwice = 4.0f; // corners and normal are each rounded once more
  face.sliver *= roundedTwice;
  return face;
}

Motion PosedSurface::toSurface(const Motion& m) const noexcept
{
  Motion moved = m;
  moved.x_W = this->toSurface(m.x_W);
  moved.e_W = this->toSurface(m.e_W);
  moved.d = this->turn_WS_.transpose() * m.d;
  Resolution resolution;
  resolution.include(moved.x_W);
  resolution.include(moved.e_W);
  resolution.include(this->shift_W_);
  moved.tol = m.tol + resolution.tol();
  return moved;
}

} // namespace palpate
