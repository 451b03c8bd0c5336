// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/statics/FiniteStatics.h"

#include <algorithm>
#include <limits>

#include <Eigen/LU>

namespace palpate::test
{

bool FiniteStatics::makeStationary(const Energy& energy, Eigen::VectorXd& z)
{
  constexpr int most = 100;
  constexpr double longest = 0.3, rounding = 1e-11;
  constexpr double nothing = 1e-18; // near 0 steps get ever smaller
  const Eigen::Index n = z.size();
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most; ++i)
  {
    Coordinates x;
    for (Eigen::Index k = 0; k < n; ++k)
    {
      x.push_back(Jet::coordinate(z[k], k, n));
    }
    const Jet e = energy(x);
    const Eigen::VectorXd step = -e.second.fullPivLu().solve(e.first);
    const double size = step.lpNorm<Eigen::Infinity>();
    z += std::min(1.0, longest / size) * step;
    if (size <= nothing || (size < rounding * (1.0 + z.lpNorm<Eigen::Infinity>()) && size >= 0.5 * last))
    {
      return true;
    }
    last = size;
  }
  return false;
}

JetVector FiniteStatics::constant(const Eigen::Vector3d& v, const Coordinates& z)
{
  const auto n = static_cast<Eigen::Index>(z.size());
  return { Jet::constant(v.x(), n), Jet::constant(v.y(), n), Jet::constant(v.z(), n) };
}

JetVector FiniteStatics::turned(const JetVector& turn, const JetVector& r)
{
  const Jet square = dot(turn, turn);
  const JetVector once = cross(turn, r);
  const JetVector twice = cross(turn, once);
  // sin a / a and (1 - cos a) / a^2 as functions of a^2: by their series, which are entire.
  double sine[3] = {}, cosine[3] = {};
  const double s = square.value;
  double power[3] = { 1.0, 0.0, 0.0 }; // s^k and its derivatives by s, over (2 k + 1)! with the sign
  for (int k = 0; k < 40; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      sine[d] += power[d];
      cosine[d] += power[d] / (2 * k + 2);
    }
    const double by = -1.0 / ((2 * k + 2) * (2 * k + 3));
    power[2] = by * (power[2] * s + 2.0 * power[1]);
    power[1] = by * (power[1] * s + power[0]);
    power[0] = by * power[0] * s;
  }
  return r + square.by(sine[0], sine[1], sine[2]) * once + square.by(cosine[0], cosine[1], cosine[2]) * twice;
}

} // namespace palpate::test
