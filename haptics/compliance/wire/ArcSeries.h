// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace palpate
{

/// An angle by 1 - its cosine: its square, and its ratio to its sine with two derivatives by the cosine.
struct ArcSeries
{
  double squared = 0.0;
  double ratio = 1.0;
  double first = 0.0;
  double second = 0.0;
};

/// The series of a / sin a in s = 1 - cos a, whose coefficients are the products of k / (2 k + 1). To rounding up to a
/// right angle; less exact beyond, and finite everywhere. Without functions of the mathematical library.
[[nodiscard]] inline ArcSeries arcOf(double s) noexcept
{
  constexpr int most = 60;
  constexpr double nothing = 1e-17;
  ArcSeries arc{ 2.0 * s, 1.0, 0.0, 0.0 };
  double coefficient = 1.0; // of s^k
  double power = 1.0;       // s^(k - 1)
  for (int k = 1; k <= most; ++k)
  {
    coefficient *= k / (2.0 * k + 1.0);
    const double term = coefficient * power;
    arc.first -= k * term;
    arc.second += (k + 1) * k * coefficient * (k + 1) / (2.0 * k + 3.0) * power;
    arc.ratio += term * s;
    arc.squared += 2.0 * term * s * s / (k + 1);
    power *= s;
    if (k * k * term < nothing)
    {
      break;
    }
  }
  return arc;
}

} // namespace palpate
