// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace palpate::lab
{

/// The exact step of m x'' + b x' = u, u held over a period: (x, v) becomes free (x, v) + held u.
struct ExactStep
{
  Eigen::Matrix2d free;
  Eigen::Vector2d held;

  [[nodiscard]] static ExactStep of(double mass_kg, double damping_Ns_per_m, double period_s);
  /// Under u = -K x.
  [[nodiscard]] Eigen::Matrix2d onSpring(double K) const;
};

/// The largest modulus of an eigenvalue: beyond 1 the motion grows from step to step.
[[nodiscard]] double spectralRadius(const Eigen::MatrixXd& loop);

/// The number from 1 to 1e6 from which on `tooMuch` holds, within a share of it.
template<class Predicate>
[[nodiscard]] double threshold(const Predicate& tooMuch, double share)
{
  double low = 1.0, high = 1e6;
  while (high / low > 1.0 + share)
  {
    const double middle = std::sqrt(low * high);
    (tooMuch(middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

} // namespace palpate::lab
