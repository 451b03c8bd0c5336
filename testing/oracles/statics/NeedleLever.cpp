// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/statics/NeedleLever.h"

#include <cmath>

#include <Eigen/LU>

namespace palpate::test
{

HeldRod NeedleLever::rod(double hand_m) const
{
  return { hand_m * Eigen::Vector3d::UnitY(), Eigen::Quaterniond::Identity(), this->coupling_N_per_m,
    this->turning_Nm_per_rad };
}

Eigen::VectorXd NeedleLever::rest(double hand_m) const
{
  const HeldRod held = this->rod(hand_m);
  const auto energy = [&](const FiniteStatics::Coordinates& z)
  {
    Jet sum = held.energy(z);
    for (int i = 0; i < 2; ++i)
    {
      const auto first = static_cast<std::size_t>(6 + 4 * i);
      const JetVector force = this->coupling_N_per_m * FiniteStatics::vectorOf(z, first + 1);
      const JetVector shaft = held.direction(z, Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d hole(0.0, 0.0, this->place_m[i]);
      sum = sum + dot(force, FiniteStatics::vectorOf(z, 0) + z[first] * shaft - hole) -
            0.5 / this->stiffness_N_per_m[i] * dot(force, force);
    }
    return sum;
  };
  Eigen::VectorXd z = Eigen::VectorXd::Zero(14);
  z[6] = this->place_m[0];
  z[10] = this->place_m[1];
  return FiniteStatics::makeStationary(energy, z) ? z : Eigen::VectorXd();
}

NeedleLever::Two NeedleLever::forceOfTurn_N(double hand_m) const
{
  const Eigen::VectorXd z = this->rest(hand_m);
  return z.size() > 0 ? Two(-this->coupling_N_per_m * Two(z[8], z[12])) : Two(Two::Constant(std::nan("")));
}

NeedleLever::Two NeedleLever::forceByEnergy_N(double hand_m) const
{
  Eigen::Matrix2d hessian = Two(this->coupling_N_per_m, this->turning_Nm_per_rad).asDiagonal();
  for (int i = 0; i < 2; ++i)
  {
    const Two row(1.0, this->place_m[i]);
    hessian += this->stiffness_N_per_m[i] * row * row.transpose();
  }
  const Two pose = hessian.inverse() * Two(this->coupling_N_per_m * hand_m, 0.0);
  return -this->stiffness_N_per_m.cwiseProduct((pose[0] + this->place_m.array() * pose[1]).matrix());
}

NeedleLever::Two NeedleLever::forceBySpot_N(double hand_m) const
{
  const Eigen::Array2d yield_m_per_N = 1.0 / this->coupling_N_per_m +
                                       this->place_m.array().square() / this->turning_Nm_per_rad +
                                       this->stiffness_N_per_m.array().inverse();
  return -hand_m / yield_m_per_N;
}

} // namespace palpate::test
