// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/TurningPart.h"

#include <algorithm>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{

TurningPart::TurningPart(const TurningModel& device, const TurningModel& hand, double period_s)
  : device_(device), hand_(hand), period_s_(period_s),
    plant_(device.inertia_kg_m2 + hand.inertia_kg_m2, device.damping_Nms + hand.damping_Nms, hand.stiffness_Nm_per_rad,
      device.friction_Nm, period_s)
{
}

void TurningPart::begin(const Quat& turn_D) noexcept
{
  this->turn_D_ = turn_D;
  this->axes_ = {};
}

void TurningPart::step(const Quat& ledFrom_D, const Quat& ledTo_D, const Vec3& torque_Nm) noexcept
{
  const double asked = torque_Nm.norm();
  const Vec3 given_Nm =
    asked > this->device_.maxTorque_Nm ? Vec3(this->device_.maxTorque_Nm / asked * torque_Nm) : torque_Nm;
  const Vec3 spring_Nm = this->hand_.stiffness_Nm_per_rad * turnFromTo(this->turn_D_, ledTo_D);
  const Vec3 damper_Nm = this->hand_.damping_Nms / this->period_s_ * turnFromTo(ledFrom_D, ledTo_D);
  Vec3 turned;
  for (int axis = 0; axis < 3; ++axis)
  {
    FrictionPlant::State& s = this->axes_[static_cast<std::size_t>(axis)];
    s.x_m = 0.0; // relative to the rotation at the start of the period
    this->plant_.step(s, spring_Nm[axis] + damper_Nm[axis] + given_Nm[axis]);
    turned[axis] = s.x_m;
  }
  this->turn_D_ = (turnBy(turned) * this->turn_D_).normalized();
}

Vec3 TurningPart::rate_D() const noexcept
{
  return { this->axes_[0].v_m_per_s, this->axes_[1].v_m_per_s, this->axes_[2].v_m_per_s };
}

Quat TurningPart::shown_D() const noexcept
{
  const double step = this->device_.step_rad;
  return step > 0.0 ? turnBy((rotationVector(this->turn_D_) / step).array().floor() * step) : this->turn_D_;
}

} // namespace palpate
