// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/LedArm.h"

#include <Eigen/LU>

namespace palpate::test
{

Mat3 LedArm::ways() const
{
  constexpr double h_rad = 1e-5;
  Mat3 ways;
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 step_rad = h_rad * Vec3::Unit(i);
    ways.col(i) =
      (this->tipOf(this->joints_rad_ + step_rad) - this->tipOf(this->joints_rad_ - step_rad)) / (2.0 * h_rad);
  }
  return ways;
}

bool LedArm::lead(const Vec3& tip_m)
{
  constexpr double reached_m = 1e-10;
  constexpr int most = 50;
  for (int i = 0; i < most; ++i)
  {
    const Vec3 left_m = tip_m - this->tip_m();
    if (left_m.norm() < reached_m)
    {
      return true;
    }
    this->joints_rad_ += this->ways().partialPivLu().solve(left_m);
  }
  return false;
}

Vec3 LedArm::forceOf(const Vec3& torque_Nm) const
{
  return this->ways().transpose().partialPivLu().solve(torque_Nm);
}

} // namespace palpate::test
