// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/Lever.h"

#include <cmath>

#include <Eigen/LU>

#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/MechanismRig.h"

namespace palpate::lab
{

using test::kc;

Lever::Two Lever::forceOfTurn_N(double hand_m) const
{
  const test::HeldRod rod{ hand_m * Vec3::UnitY(), Quat::Identity(), kc, this->turning_Nm_per_rad };
  // Of each hole its place along the shaft, and the force there over the hand's spring.
  const auto energy = [&](const test::FiniteStatics::Coordinates& z)
  {
    test::Jet sum = rod.energy(z);
    for (int i = 0; i < 2; ++i)
    {
      const auto first = static_cast<std::size_t>(6 + 4 * i);
      const test::JetVector force = kc * test::FiniteStatics::vectorOf(z, first + 1);
      const test::JetVector shaft = rod.direction(z, Vec3::UnitZ());
      sum = sum +
            dot(force, test::FiniteStatics::vectorOf(z, 0) + z[first] * shaft - Vec3(0.0, 0.0, this->place_m[i])) -
            0.5 / this->stiffness_N_per_m[i] * dot(force, force);
    }
    return sum;
  };
  Eigen::VectorXd z = Eigen::VectorXd::Zero(14);
  z[6] = this->place_m[0];
  z[10] = this->place_m[1];
  const bool ended = test::FiniteStatics::makeStationary(energy, z);
  return ended ? Two(-kc * Two(z[8], z[12])) : Two(Two::Constant(std::nan("")));
}

Lever::Two Lever::forceByEnergy_N(double hand_m) const
{
  Eigen::Matrix2d hessian = Two(kc, this->turning_Nm_per_rad).asDiagonal();
  for (int i = 0; i < 2; ++i)
  {
    const Two row(1.0, this->place_m[i]);
    hessian += this->stiffness_N_per_m[i] * row * row.transpose();
  }
  const Two pose = hessian.inverse() * Two(kc * hand_m, 0.0);
  return -this->stiffness_N_per_m.cwiseProduct((pose[0] + this->place_m.array() * pose[1]).matrix());
}

Lever::Two Lever::forceBySpot_N(double hand_m) const
{
  const Eigen::Array2d yield_m_per_N =
    1.0 / kc + this->place_m.array().square() / this->turning_Nm_per_rad + this->stiffness_N_per_m.array().inverse();
  return -hand_m / yield_m_per_N;
}

} // namespace palpate::lab
