// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolTick.h"

#include "haptics/safety/ForceLimits.h"

namespace palpate
{

ToolFelt ToolTick::step(const ToolContacts& newest, const Pose& device_W, const ToolFeel& feel, double dt_s) noexcept
{
  const ToolPush push = toolPush(newest, device_W, feel.stiffness_N_per_m, feel.coupling);
  ToolFelt felt;
  felt.active = push.active;
  if (newest.revision != this->set_.revision)
  {
    felt.injected_J = push.stored - toolPush(this->set_, device_W, feel.stiffness_N_per_m, feel.coupling).stored;
    this->set_ = newest;
  }
  const SafetyLimits& most = feel.limits;
  const Wrench& asked = push.wrench_W;
  felt.wrench.force =
    limitRise(clampMagnitude(asked.force, most.maxForce_N), this->last_.force, most.maxRise_N_per_s, dt_s);
  felt.wrench.torque =
    limitRise(clampMagnitude(asked.torque, most.maxTorque_Nm), this->last_.torque, most.maxTorqueRise_Nm_per_s, dt_s);
  felt.limited = felt.wrench.force != asked.force || felt.wrench.torque != asked.torque;
  this->last_ = felt.wrench;
  return felt;
}

} // namespace palpate
