// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/ExactLoops.h"

#include <Eigen/Eigenvalues>

namespace palpate::lab
{

ExactStep ExactStep::of(double mass_kg, double damping_Ns_per_m, double period_s)
{
  ExactStep step;
  if (damping_Ns_per_m == 0.0)
  {
    step.free << 1.0, period_s, 0.0, 1.0;
    step.held << period_s * period_s / (2 * mass_kg), period_s / mass_kg;
    return step;
  }
  const double tau_s = mass_kg / damping_Ns_per_m, left = std::exp(-period_s / tau_s);
  step.free << 1.0, tau_s * (1.0 - left), 0.0, left;
  step.held << (period_s - tau_s * (1.0 - left)) / damping_Ns_per_m, (1.0 - left) / damping_Ns_per_m;
  return step;
}

Eigen::Matrix2d ExactStep::onSpring(double K) const
{
  return this->free - K * this->held * Eigen::RowVector2d(1.0, 0.0);
}

double spectralRadius(const Eigen::MatrixXd& loop)
{
  return loop.eigenvalues().cwiseAbs().maxCoeff();
}

} // namespace palpate::lab
