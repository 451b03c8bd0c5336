// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/BentSurface.h"

#include "haptics/geometry/ExactPredicates.h"
#include "haptics/geometry/SurfaceRecords.h"

namespace palpate
{

FaceRecord BentSurface::face(std::uint32_t triangle) const noexcept
{
  const FaceRecord& end = this->data_.face(triangle);
  if (!this->bends())
  {
    return end;
  }
  FaceRecord face = makeFace(this->cornersOf(triangle), isSegment(this->data_.corners(triangle)), end.owned);
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
