// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/motion/Turn.h"

#include <cmath>

namespace palpate
{

Vec3 rotationVector(const Quat& q) noexcept
{
  constexpr int halvings = 3; // to at most pi / 16, where the series is short
  constexpr int terms = 12;
  Vec3 sine = q.w() < 0.0 ? Vec3(-q.vec()) : Vec3(q.vec());
  double cosine = q.w() < 0.0 ? -q.w() : q.w();
  double factor = 2.0;
  for (int i = 0; i < halvings; ++i)
  {
    const double half = std::sqrt(0.5 * (1.0 + cosine));
    sine /= 2.0 * half;
    cosine = half;
    factor *= 2.0;
  }
  // asin(x) / x = 1 + x^2 / 6 + 3 x^4 / 40 + ...
  const double x2 = sine.squaredNorm();
  double term = 1.0, sum = 1.0;
  for (int k = 0; k < terms; ++k)
  {
    term *= x2 * (2 * k + 1) / (2 * k + 2);
    sum += term / (2 * k + 3);
  }
  return factor * sum * sine;
}

Quat turnBy(const Vec3& turn_rad) noexcept
{
  constexpr int terms = 14; // (pi / 2)^28 / 28! is below rounding
  const Vec3 half = 0.5 * turn_rad;
  const double h2 = half.squaredNorm();
  double cosineTerm = 1.0, cosine = 1.0, sineTerm = 1.0, sine = 1.0;
  constexpr double nothing = 1e-20; // negligible beside one
  for (int k = 1; k <= terms && std::abs(cosineTerm) > nothing; ++k)
  {
    cosineTerm *= -h2 / ((2 * k - 1) * (2 * k));
    sineTerm *= -h2 / ((2 * k) * (2 * k + 1));
    cosine += cosineTerm;
    sine += sineTerm;
  }
  Quat q(cosine, sine * half.x(), sine * half.y(), sine * half.z());
  q.normalize();
  return q;
}

} // namespace palpate
