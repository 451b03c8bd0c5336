// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <emmintrin.h>

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
    this->q_ = { _mm_set1_ps(float(q.x())), _mm_set1_ps(float(q.y())), _mm_set1_ps(float(q.z())) };
    this->d_ = { _mm_set1_ps(float(d.x())), _mm_set1_ps(float(d.y())), _mm_set1_ps(float(d.z())) };
    const double reach = perUnit * (m.r + m.tol);
    // Single precision loses 1e-7 of the numbers it handles; a hundred times that is allowed for.
    const double lost = 1e-5 * (q.cwiseAbs().maxCoeff() + d.cwiseAbs().maxCoeff() + reach + extent);
    this->lost_ = _mm_set1_ps(float(lost));
    this->reach_ = _mm_set1_ps(float(reach + lost));
    const Vec3 middle = q + 0.5 * d;
    this->middle_ = { _mm_set1_ps(float(middle.x())), _mm_set1_ps(float(middle.y())), _mm_set1_ps(float(middle.z())) };
    const double around = reach + 0.5 * d.norm() + 2 * lost, lost2 = 0.1 * lost * (lost / 1e-5);
    this->around2_ = _mm_set1_ps(float(around * around + lost2));
    this->lost2_ = _mm_set1_ps(float(lost2));
  }

  /// The same for the ball around the whole way, without a division or a root: few more lanes where the way is short.
  [[nodiscard]] int near(const DiscQuad& quad) const noexcept
  {
    const Triple q = { _mm_sub_ps(this->middle_.x, _mm_load_ps(quad.cx.data())),
      _mm_sub_ps(this->middle_.y, _mm_load_ps(quad.cy.data())),
      _mm_sub_ps(this->middle_.z, _mm_load_ps(quad.cz.data())) };
    const Triple n = { _mm_load_ps(quad.nx.data()), _mm_load_ps(quad.ny.data()), _mm_load_ps(quad.nz.data()) };
    const __m128 radius = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->lost_),
                 radius2 = _mm_mul_ps(radius, radius);
    const __m128 h = dot(n, q), q2 = dot(q, q);
    const __m128 lateral2 = _mm_add_ps(_mm_sub_ps(q2, _mm_mul_ps(h, h)), this->lost2_);
    // (lateral - radius)^2 + h^2 > around^2, where the centre is beside the disc
    const __m128 beyond = _mm_sub_ps(_mm_add_ps(q2, radius2), this->around2_);
    const __m128 far = _mm_and_ps(_mm_cmpgt_ps(beyond, _mm_setzero_ps()),
      _mm_cmpgt_ps(_mm_mul_ps(beyond, beyond), _mm_mul_ps(_mm_set1_ps(4.0f), _mm_mul_ps(radius2, lateral2))));
    const __m128 beside = _mm_and_ps(far, _mm_cmpgt_ps(lateral2, radius2));
    const __m128 above = _mm_cmpgt_ps(_mm_mul_ps(h, h), this->around2_);
    return ~_mm_movemask_ps(_mm_or_ps(beside, above)) & 15;
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
    // Distance of the way from the disc's axis. Both are laid into the disc's plane first: differences of their squares
    // would lose the rest of a long path that stands nearly upright on the disc.
    const Triple across = alongPlane(q, n, h0), way = alongPlane(this->d_, n, hd);
    const __m128 safe = _mm_max_ps(dot(way, way), _mm_set1_ps(std::numeric_limits<float>::min()));
    const __m128 t =
      _mm_min_ps(_mm_max_ps(_mm_div_ps(_mm_sub_ps(zero, dot(across, way)), safe), zero), _mm_set1_ps(1.0f));
    const Triple lateral = { at(across.x, way.x, t), at(across.y, way.y, t), at(across.z, way.z, t) };
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
  /// v without its share along n, which is h long.
  static Triple alongPlane(const Triple& v, const Triple& n, __m128 h) noexcept
  {
    return { _mm_sub_ps(v.x, _mm_mul_ps(h, n.x)), _mm_sub_ps(v.y, _mm_mul_ps(h, n.y)),
      _mm_sub_ps(v.z, _mm_mul_ps(h, n.z)) };
  }
  static __m128 at(__m128 q, __m128 d, __m128 t) noexcept { return _mm_add_ps(q, _mm_mul_ps(t, d)); }
  static __m128 absolute(__m128 v) noexcept { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }

  Triple q_, d_, middle_;
  __m128 lost_, reach_, around2_, lost2_;
};

} // namespace palpate
