// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/ForceLimits.h"

#include <algorithm>
#include <cmath>

namespace palpate
{

Vec3 clampMagnitude(const Vec3& force, double maxForce_N) noexcept
{
  const double magnitude = force.norm();
  return magnitude > maxForce_N ? Vec3(force * (maxForce_N / magnitude)) : force;
}

Vec3 limitRise(const Vec3& force, const Vec3& previous, double maxRise_N_per_s, double dt_s) noexcept
{
  return clampMagnitude(force, previous.norm() + maxRise_N_per_s * dt_s);
}

double smoothstep(double s) noexcept
{
  const double c = std::clamp(s, 0.0, 1.0);
  return c * c * (3.0 - 2.0 * c);
}

bool isFinite(const DeviceSample& sample) noexcept
{
  constexpr double furthest_m = 1e9; // of a hand that is somewhere: squares of more than 1e154 are none any more
  return sample.pose_D.p.allFinite() && sample.pose_D.p.cwiseAbs().maxCoeff() <= furthest_m &&
         sample.pose_D.q.coeffs().allFinite() && sample.velocity_D.linear.allFinite() &&
         sample.velocity_D.angular.allFinite() && std::isfinite(sample.time_s);
}

} // namespace palpate
