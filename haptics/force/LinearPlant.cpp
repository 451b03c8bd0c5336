// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/LinearPlant.h"

namespace palpate
{
namespace
{

/// exp(M) by scaling and squaring of its Taylor series: exact to rounding.
Eigen::Matrix3d exponential(const Eigen::Matrix3d& m)
{
  int halvings = 0;
  for (double norm = m.cwiseAbs().rowwise().sum().maxCoeff(); norm > 0.5; norm /= 2)
  {
    ++halvings;
  }
  const Eigen::Matrix3d small = m / static_cast<double>(1 << halvings);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Identity(), term = sum;
  constexpr int terms = 18;
  for (int k = 1; k <= terms; ++k)
  {
    term = term * small / k;
    sum += term;
  }
  for (int k = 0; k < halvings; ++k)
  {
    sum = (sum * sum).eval();
  }
  return sum;
}

} // namespace

LinearPlant::LinearPlant(double mass_kg, double damping_Ns_per_m, double stiffness_N_per_m, double period_s)
{
  Eigen::Matrix3d system = Eigen::Matrix3d::Zero(); // of (x, v, u)
  system(0, 1) = 1.0;
  system(1, 0) = -stiffness_N_per_m / mass_kg;
  system(1, 1) = -damping_Ns_per_m / mass_kg;
  system(1, 2) = 1.0 / mass_kg;
  const Eigen::Matrix3d step = exponential(system * period_s);
  this->free_ = step.topLeftCorner<2, 2>();
  this->held_ = step.topRightCorner<2, 1>();
}

void LinearPlant::step(Vec3& x_m, Vec3& v_m_per_s, const Vec3& u_N) const noexcept
{
  const Vec3 x = this->free_(0, 0) * x_m + this->free_(0, 1) * v_m_per_s + this->held_(0) * u_N;
  v_m_per_s = this->free_(1, 0) * x_m + this->free_(1, 1) * v_m_per_s + this->held_(1) * u_N;
  x_m = x;
}

} // namespace palpate
