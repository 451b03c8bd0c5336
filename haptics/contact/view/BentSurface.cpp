// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/view/BentSurface.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceRecords.h"

namespace palpate
{
namespace
{

/// Between these nothing under- or overflows: a tick computes the same face several times, and this is the quick way.
constexpr double leastArea2 = 1e-250, mostArea2 = 1e250;
/// A record holds it in single precision, which ends at 3e38.
constexpr double mostSliver = 1e30;

} // namespace

FaceRecord BentSurface::face(std::uint32_t triangle) const noexcept
{
  if (!this->bends())
  {
    return this->data_.face(triangle);
  }
  const FacePlane& end = this->data_.plane(triangle);
  FaceRecord face;
  face.corner_W = this->cornersOf(triangle);
  face.owned = end.owned;
  const Vec3 e = face.corner_W[1] - face.corner_W[0], f = face.corner_W[2] - face.corner_W[0], cross = e.cross(f);
  const double area2 = cross.squaredNorm(), sides2 = e.squaredNorm() * f.squaredNorm();
  if (area2 > leastArea2 && area2 < mostArea2)
  {
    const double inverse = 1.0 / std::sqrt(area2);
    face.normal_W = inverse * cross;
    face.sliver = static_cast<float>(std::min(inverse * std::sqrt(sides2), mostSliver));
    if (face.sliver <= needleSliver)
    {
      return face;
    }
  }
  face = makeFace(face.corner_W, isSegment(this->data_.corners(triangle)), end.owned);
  if (!face.normal_W.allFinite())
  {
    face.normal_W = end.normal_W;
  }
  return face;
}

bool hasArea(const BentSurface& s, const FaceRecord& face) noexcept
{
  constexpr float certainly = 1e9F; // the normal's rounding leaves no doubt below
  const auto& [a, b, c] = face.corner_W;
  return !s.bends() || face.sliver < certainly || !exactlyCollinear(a, b, c);
}

} // namespace palpate
