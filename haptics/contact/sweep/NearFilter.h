// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/sweep/FourVectors.h"
#include "haptics/contact/view/FaceList.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// Four discs of a list against the ball around the whole way in single precision; bit k is set where lane k may be
/// near. Takes a third of the time of DiscFilter, as there is no division and no root, and lets few more lanes pass
/// where the way is short.
class NearFilter
{
public:
  NearFilter(const SweptBall& m, const FaceList::Frame& frame) noexcept
  {
    const Vec3 middle = frame.perUnit * (m.x_W + 0.5 * m.d - frame.centre_W);
    const double reach = frame.perUnit * (m.r + m.tol + 0.5 * m.d.norm());
    // Single precision loses 1e-7 of the numbers it handles, and as much of their squares: a hundred times that and ten
    // times that are allowed for.
    const double handled = middle.cwiseAbs().maxCoeff() + reach + frame.extent;
    const double lost = 1e-5 * handled, lost2 = 1e-6 * handled * handled;
    this->middle_ = fourOf(middle);
    this->lost_ = _mm_set1_ps(float(lost));
    this->lost2_ = _mm_set1_ps(float(lost2));
    this->reach2_ = _mm_set1_ps(float((reach + 2 * lost) * (reach + 2 * lost) + lost2));
  }

  [[nodiscard]] int near(const DiscQuad& quad) const noexcept
  {
    const FourVectors q = minus(this->middle_, fourFrom(quad.cx, quad.cy, quad.cz));
    const __m128 radius = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->lost_);
    const __m128 radius2 = _mm_mul_ps(radius, radius);
    const __m128 h = dot(fourFrom(quad.nx, quad.ny, quad.nz), q), h2 = _mm_mul_ps(h, h), q2 = dot(q, q);
    const __m128 lateral2 = _mm_add_ps(_mm_sub_ps(q2, h2), this->lost2_);
    // Where the centre is beside the disc: (lateral - radius)^2 + h^2 > reach^2.
    const __m128 beyond = _mm_sub_ps(_mm_add_ps(q2, radius2), this->reach2_);
    const __m128 twice2 = _mm_mul_ps(_mm_set1_ps(4.0f), _mm_mul_ps(radius2, lateral2));
    const __m128 further =
      _mm_and_ps(_mm_cmpgt_ps(beyond, _mm_setzero_ps()), _mm_cmpgt_ps(_mm_mul_ps(beyond, beyond), twice2));
    const __m128 beside = _mm_and_ps(further, _mm_cmpgt_ps(lateral2, radius2));
    return ~_mm_movemask_ps(_mm_or_ps(beside, _mm_cmpgt_ps(h2, this->reach2_))) & 15;
  }

private:
  FourVectors middle_;
  __m128 lost_, lost2_, reach2_;
};

/// The same of balls that go straight with faces, at a moment of the rest of their way, 0..1.
class GoingFilter
{
public:
  GoingFilter(const SweptBall& still, const FaceList::Frame& frame, double moment) noexcept
  {
    const Vec3 centre = frame.perUnit * (still.x_W - frame.centre_W);
    const double reach = frame.perUnit * (still.r + still.tol);
    const double handled = centre.cwiseAbs().maxCoeff() + reach + frame.extent;
    this->centre_ = fourOf(centre);
    this->moment_ = _mm_set1_ps(float(moment));
    this->reach_ = _mm_set1_ps(float(reach + 2e-5 * handled)); // as in NearFilter
    this->lost2_ = _mm_set1_ps(float(1e-6 * handled * handled));
  }

  [[nodiscard]] int near(const DiscQuad& quad) const noexcept
  {
    const FourVectors at =
      along(fourFrom(quad.cx, quad.cy, quad.cz), this->moment_, fourFrom(quad.nx, quad.ny, quad.nz));
    const FourVectors q = minus(this->centre_, at);
    const __m128 touches = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->reach_);
    const __m128 touches2 = _mm_add_ps(_mm_mul_ps(touches, touches), this->lost2_);
    return _mm_movemask_ps(_mm_cmple_ps(dot(q, q), touches2)) & 15;
  }

private:
  FourVectors centre_;
  __m128 moment_, reach_, lost2_;
};

/// Calls visit(i) for each face of a list that may be near, in its order.
template<class Filter, class Visit>
void forEachNear(const FaceList& list, const Filter& filter, const Visit& visit) noexcept
{
  for (int quad = 0; quad < list.quads(); ++quad)
  {
    forEachLane(filter.near(list.discs(quad)) & list.lanesOf(quad),
      [&](std::uint32_t lane) { visit(quad * 4 + static_cast<int>(lane)); });
  }
}

} // namespace palpate
