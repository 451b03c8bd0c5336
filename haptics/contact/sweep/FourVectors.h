// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <emmintrin.h>

#include "haptics/core/Types.h"

namespace palpate
{

/// Four vectors in single precision, a coordinate of all of them at a time.
struct FourVectors
{
  __m128 x, y, z;
};

/// Calls visit(k) for each lane k whose bit is set, from the lowest on.
template<class Visit>
void forEachLane(int lanes, Visit visit) noexcept
{
  for (auto left = static_cast<unsigned>(lanes); left != 0; left &= left - 1)
  {
    visit(static_cast<std::uint32_t>(__builtin_ctz(left)));
  }
}

/// The same vector four times.
[[nodiscard]] inline FourVectors fourOf(const Vec3& v) noexcept
{
  return { _mm_set1_ps(float(v.x())), _mm_set1_ps(float(v.y())), _mm_set1_ps(float(v.z())) };
}

[[nodiscard]] inline FourVectors fourFrom(
  const std::array<float, 4>& x, const std::array<float, 4>& y, const std::array<float, 4>& z) noexcept
{
  return { _mm_load_ps(x.data()), _mm_load_ps(y.data()), _mm_load_ps(z.data()) };
}

[[nodiscard]] inline FourVectors minus(const FourVectors& a, const FourVectors& b) noexcept
{
  return { _mm_sub_ps(a.x, b.x), _mm_sub_ps(a.y, b.y), _mm_sub_ps(a.z, b.z) };
}

/// a + t b
[[nodiscard]] inline FourVectors along(const FourVectors& a, __m128 t, const FourVectors& b) noexcept
{
  return { _mm_add_ps(a.x, _mm_mul_ps(t, b.x)), _mm_add_ps(a.y, _mm_mul_ps(t, b.y)),
    _mm_add_ps(a.z, _mm_mul_ps(t, b.z)) };
}

[[nodiscard]] inline __m128 dot(const FourVectors& a, const FourVectors& b) noexcept
{
  return _mm_add_ps(_mm_add_ps(_mm_mul_ps(a.x, b.x), _mm_mul_ps(a.y, b.y)), _mm_mul_ps(a.z, b.z));
}

[[nodiscard]] inline __m128 absolute(__m128 v) noexcept
{
  return _mm_andnot_ps(_mm_set1_ps(-0.0f), v);
}

} // namespace palpate
