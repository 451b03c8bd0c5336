// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/contact/sweep/FourVectors.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// Four discs against the swept ball in single precision; bit k is set where lane k may be touched.
class DiscFilter
{
public:
  /// Discs are given relative to origin_W in a unit of which 1 u is `perUnit`, and none of their coordinates is larger
  /// than `extent` of it. In the scene's own unit the squares of a nanometre or of a light year leave single precision.
  DiscFilter(const SweptBall& m, const Vec3& origin_W, double perUnit, double extent = 1.0) noexcept
  {
    const Vec3 q = perUnit * (m.x_W - origin_W), d = perUnit * m.d;
    this->q_ = fourOf(q);
    this->d_ = fourOf(d);
    const double reach = perUnit * (m.r + m.tol);
    // Single precision loses 1e-7 of the numbers it handles; a hundred times that is allowed for.
    const double lost = 1e-5 * (q.cwiseAbs().maxCoeff() + d.cwiseAbs().maxCoeff() + reach + extent);
    this->lost_ = _mm_set1_ps(float(lost));
    this->reach_ = _mm_set1_ps(float(reach + lost));
  }

  [[nodiscard, gnu::always_inline]] int touched(const DiscQuad& quad) const noexcept
  {
    const FourVectors n = fourFrom(quad.nx, quad.ny, quad.nz);
    const FourVectors q = minus(this->q_, fourFrom(quad.cx, quad.cy, quad.cz));
    const __m128 zero = _mm_setzero_ps();
    const __m128 h0 = dot(n, q), hd = dot(n, this->d_);
    const __m128 h1 = _mm_add_ps(h0, hd);
    const __m128 crosses = _mm_cmple_ps(_mm_mul_ps(h0, h1), zero);
    __m128 h = _mm_andnot_ps(crosses, _mm_min_ps(absolute(h0), absolute(h1)));
    h = _mm_max_ps(zero, _mm_sub_ps(h, this->lost_));
    // Distance of the way from the disc's axis. Both are laid into the disc's plane first: differences of their squares
    // would lose the rest of a long path that stands nearly upright on the disc.
    const FourVectors across = alongPlane(q, n, h0), way = alongPlane(this->d_, n, hd);
    const __m128 safe = _mm_max_ps(dot(way, way), _mm_set1_ps(std::numeric_limits<float>::min()));
    const __m128 t =
      _mm_min_ps(_mm_max_ps(_mm_div_ps(_mm_sub_ps(zero, dot(across, way)), safe), zero), _mm_set1_ps(1.0f));
    const FourVectors lateral = along(across, t, way);
    const __m128 radius = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->lost_);
    const __m128 excess = _mm_max_ps(zero, _mm_sub_ps(_mm_sqrt_ps(dot(lateral, lateral)), radius));
    const __m128 distance2 = _mm_add_ps(_mm_mul_ps(h, h), _mm_mul_ps(excess, excess));
    const __m128 clear = _mm_cmpgt_ps(distance2, _mm_mul_ps(this->reach_, this->reach_));
    return ~_mm_movemask_ps(clear) & 15;
  }

private:
  /// v without its share along n, which is h long.
  static FourVectors alongPlane(const FourVectors& v, const FourVectors& n, __m128 h) noexcept
  {
    return { _mm_sub_ps(v.x, _mm_mul_ps(h, n.x)), _mm_sub_ps(v.y, _mm_mul_ps(h, n.y)),
      _mm_sub_ps(v.z, _mm_mul_ps(h, n.z)) };
  }

  FourVectors q_, d_;
  __m128 lost_, reach_;
};

} // namespace palpate
