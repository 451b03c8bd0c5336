// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/CapMotion.h"

#include <algorithm>
#include <cmath>

#include "haptics/safety/ForceLimits.h"

namespace palpate
{

double CapMotion::pressed(double share) const noexcept
{
  const double beyond = std::max(0.0, std::fabs(share) - this->options_.restShare) / (1.0 - this->options_.restShare);
  return std::copysign(beyond, share);
}

void CapMotion::step(const Cap& cap, double dt_s) noexcept
{
  const Vec3 pushed_D(this->pressed(cap.at[0]), -this->pressed(cap.at[1]), -this->pressed(cap.at[2]));
  const Vec3 turned_D(this->pressed(cap.at[3]), -this->pressed(cap.at[4]), -this->pressed(cap.at[5]));
  const Vec3 from_D = this->pose_D_.p;
  this->pose_D_.p = clampMagnitude(from_D + this->options_.speed_m_per_s * dt_s * pushed_D, this->options_.radius_m);
  this->velocity_D_.angular = this->options_.turn_rad_per_s * turned_D;
  this->velocity_D_.linear = dt_s > 0.0 ? Vec3((this->pose_D_.p - from_D) / dt_s) : Vec3(Vec3::Zero());
  // First order, then normalised: the rotation within a tick is of milliradians.
  const Vec3 half_D = 0.5 * dt_s * this->velocity_D_.angular;
  this->pose_D_.q = (Quat(1.0, half_D.x(), half_D.y(), half_D.z()) * this->pose_D_.q).normalized();
}

} // namespace palpate
