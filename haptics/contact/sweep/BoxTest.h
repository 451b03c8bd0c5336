// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <emmintrin.h>

#include "haptics/contact/view/SweptBall.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// One coordinate of both boxes, axis by axis.
struct Lanes
{
  __m128d axis[3];

  __m128d& operator[](int k) noexcept { return this->axis[k]; }
  const __m128d& operator[](int k) const noexcept { return this->axis[k]; }
};

struct Entries
{
  std::array<double, 2> time; ///< infinity: missed
};

/// Two boxes at once against the way up to the best hit so far. Every bound is grown by tol, which is more than the
/// arithmetic here rounds: a box is only passed over when the swept ball misses it.
class BoxTest
{
public:
  explicit BoxTest(const SweptBall& m) noexcept : m_(m), ordered_(m.length > m.r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const bool moves = std::fabs(m.d[k]) > 1e-290; // the inverse of less could be infinite
      this->x_[k] = _mm_set1_pd(m.x_W[k]);
      this->inverse_[k] = _mm_set1_pd(moves ? 1.0 / m.d[k] : 0.0);
      this->zeroBias_[k] = _mm_set1_pd(moves ? 0.0 : std::numeric_limits<double>::infinity());
    }
    this->grow_ = _mm_set1_pd(m.r + m.tol);
    this->shortenTo(1.0);
  }

  /// Only the first part of the way, up to fraction t, still matters.
  void shortenTo(double t) noexcept
  {
    const Vec3 centre_W = this->m_.x_W + 0.5 * t * this->m_.d;
    for (int k = 0; k < 3; ++k)
    {
      this->centre_[k] = _mm_set1_pd(centre_W[k]);
    }
    const double reach = this->m_.r + 0.5 * t * this->m_.length + this->m_.tol;
    this->reach2_ = _mm_set1_pd(reach * reach * (1.0 + 1e-14)); // more than sum and square are rounded, some 1e-15
    this->last_ = _mm_set1_pd(t);
  }

  /// Earliest fraction of the way at which each box can be touched. A short way is not worth ordering: 0.
  [[nodiscard, gnu::always_inline]] Entries operator()(const Lanes& low, const Lanes& high) const noexcept
  {
    const __m128d zero = _mm_setzero_pd();
    __m128d distance2 = zero;
    for (int k = 0; k < 3; ++k)
    {
      const __m128d below = _mm_sub_pd(low[k], this->centre_[k]), above = _mm_sub_pd(this->centre_[k], high[k]);
      const __m128d out = _mm_max_pd(_mm_max_pd(below, above), zero);
      distance2 = _mm_add_pd(distance2, _mm_mul_pd(out, out));
    }
    __m128d missed = _mm_cmpgt_pd(distance2, this->reach2_);
    __m128d entry = zero;
    if (this->ordered_ && _mm_movemask_pd(missed) != 3)
    {
      __m128d exit = this->last_;
      for (int k = 0; k < 3; ++k)
      {
        const __m128d t0 = _mm_mul_pd(_mm_sub_pd(_mm_sub_pd(low[k], this->grow_), this->x_[k]), this->inverse_[k]);
        const __m128d t1 = _mm_mul_pd(_mm_sub_pd(_mm_add_pd(high[k], this->grow_), this->x_[k]), this->inverse_[k]);
        entry = _mm_max_pd(entry, _mm_sub_pd(_mm_min_pd(t0, t1), this->zeroBias_[k]));
        exit = _mm_min_pd(exit, _mm_add_pd(_mm_max_pd(t0, t1), this->zeroBias_[k]));
      }
      const __m128d roundOff = _mm_set1_pd(1e-12); // of the way; times are quotients, rounded by 1e-15
      missed = _mm_or_pd(missed, _mm_cmpgt_pd(entry, _mm_add_pd(exit, roundOff)));
      entry = _mm_max_pd(zero, _mm_sub_pd(entry, roundOff));
    }
    entry =
      _mm_or_pd(_mm_andnot_pd(missed, entry), _mm_and_pd(missed, _mm_set1_pd(std::numeric_limits<double>::infinity())));
    Entries entries;
    _mm_storeu_pd(entries.time.data(), entry);
    return entries;
  }

  [[nodiscard, gnu::always_inline]] Entries operator()(const TreeNode& node) const noexcept
  {
    const auto load = [](const std::array<std::array<double, 2>, 3>& corner) {
      return Lanes{ { _mm_load_pd(corner[0].data()), _mm_load_pd(corner[1].data()), _mm_load_pd(corner[2].data()) } };
    };
    return (*this)(load(node.low_W), load(node.high_W));
  }

  [[nodiscard]] double one(const Vec3& low_W, const Vec3& high_W) const noexcept
  {
    const auto both = [](const Vec3& v) {
      return Lanes{ { _mm_set1_pd(v.x()), _mm_set1_pd(v.y()), _mm_set1_pd(v.z()) } };
    };
    return (*this)(both(low_W), both(high_W)).time[0];
  }

private:
  const SweptBall& m_;
  bool ordered_;
  Lanes x_, inverse_, zeroBias_, centre_;
  __m128d grow_, reach2_, last_;
};

} // namespace palpate
