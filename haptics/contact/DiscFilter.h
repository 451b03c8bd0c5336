// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <emmintrin.h>

#include "haptics/contact/Motion.h"
#include "haptics/geometry/SurfaceData.h"

namespace palpate
{

/// Four discs against the swept ball in single precision; bit k is set where lane k may be touched.
class DiscFilter
{
public:
  /// `extent`: how large the disc's coordinates relative to origin_W may be [u].
  DiscFilter(const Motion& m, const Vec3& origin_W, double extent) noexcept
  {
    const Vec3 q = m.x_W - origin_W;
    this->q_ = { _mm_set1_ps(float(q.x())), _mm_set1_ps(float(q.y())), _mm_set1_ps(float(q.z())) };
    this->d_ = { _mm_set1_ps(float(m.d.x())), _mm_set1_ps(float(m.d.y())), _mm_set1_ps(float(m.d.z())) };
    this->dd_ = _mm_set1_ps(float(m.dd));
    // Single precision loses 1e-7 of the numbers it handles; a hundred times that is allowed for.
    const double lost = 1e-5 * (q.cwiseAbs().maxCoeff() + m.d.cwiseAbs().maxCoeff() + m.r + extent);
    this->lost_ = _mm_set1_ps(float(lost));
    this->reach_ = _mm_set1_ps(float(m.r + m.tol + lost));
  }

  [[nodiscard]] int touched(const DiscQuad& quad) const noexcept
  {
    const Triple n = { _mm_load_ps(quad.nx.data()), _mm_load_ps(quad.ny.data()), _mm_load_ps(quad.nz.data()) };
    const Triple q = { _mm_sub_ps(this->q_.x, _mm_load_ps(quad.cx.data())),
      _mm_sub_ps(this->q_.y, _mm_load_ps(quad.cy.data())), _mm_sub_ps(this->q_.z, _mm_load_ps(quad.cz.data())) };
    const __m128 zero = _mm_setzero_ps();
    const __m128 h0 = dot(n, q), hd = dot(n, this->d_);
    const __m128 h1 = _mm_add_ps(h0, hd);
    const __m128 crosses = _mm_cmple_ps(_mm_mul_ps(h0, h1), zero);
    __m128 h = _mm_andnot_ps(crosses, _mm_min_ps(absolute(h0), absolute(h1)));
    h = _mm_max_ps(zero, _mm_sub_ps(h, this->lost_));
    // Distance of the way from the disc's axis, in the disc's plane.
    const __m128 qd = _mm_sub_ps(dot(q, this->d_), _mm_mul_ps(h0, hd));
    const __m128 ddLateral = _mm_max_ps(_mm_sub_ps(this->dd_, _mm_mul_ps(hd, hd)), zero);
    const __m128 safe = _mm_max_ps(ddLateral, _mm_set1_ps(std::numeric_limits<float>::min()));
    const __m128 t = _mm_min_ps(_mm_max_ps(_mm_div_ps(_mm_sub_ps(zero, qd), safe), zero), _mm_set1_ps(1.0f));
    const Triple c = { at(q.x, this->d_.x, t), at(q.y, this->d_.y, t), at(q.z, this->d_.z, t) };
    const __m128 hc = _mm_add_ps(h0, _mm_mul_ps(t, hd));
    const Triple lateral = { at(c.x, n.x, _mm_sub_ps(zero, hc)), at(c.y, n.y, _mm_sub_ps(zero, hc)),
      at(c.z, n.z, _mm_sub_ps(zero, hc)) };
    const __m128 radius = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->lost_);
    const __m128 excess = _mm_max_ps(zero, _mm_sub_ps(_mm_sqrt_ps(dot(lateral, lateral)), radius));
    const __m128 distance2 = _mm_add_ps(_mm_mul_ps(h, h), _mm_mul_ps(excess, excess));
    const __m128 clear = _mm_cmpgt_ps(distance2, _mm_mul_ps(this->reach_, this->reach_));
    return ~_mm_movemask_ps(clear) & 15;
  }

private:
  struct Triple
  {
    __m128 x, y, z;
  };
  static __m128 dot(const Triple& a, const Triple& b) noexcept
  {
    return _mm_add_ps(_mm_add_ps(_mm_mul_ps(a.x, b.x), _mm_mul_ps(a.y, b.y)), _mm_mul_ps(a.z, b.z));
  }
  static __m128 at(__m128 q, __m128 d, __m128 t) noexcept { return _mm_add_ps(q, _mm_mul_ps(t, d)); }
  static __m128 absolute(__m128 v) noexcept { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }

  Triple q_, d_;
  __m128 dd_, lost_, reach_;
};

} // namespace palpate
