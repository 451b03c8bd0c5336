// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/SessionRun.h"

#include <algorithm>

#include "haptics/force/Viscosity.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/DeviceTimer.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/tool/servo/FrictionTarget.h"

namespace palpate
{

HapticSession::Run::Run() = default;
HapticSession::Run::~Run() = default;

void HapticSession::Run::pace(std::int64_t period_ns)
{
  if (this->virtualTime)
  {
    this->timer = std::make_unique<VirtualTimer>(period_ns);
  }
  else if (this->device->info().pacing == Pacing::Timer)
  {
    this->timer = std::make_unique<PeriodicTimer>(period_ns);
  }
  else
  {
    this->timer = std::make_unique<DeviceTimer>(*this->device, this->clock, period_ns);
  }
}

void HapticSession::Run::adapt(const HapticParameters& parameters, double characteristic_u, bool first)
{
  const LoopSettings loop = loopSettings(parameters, this->period_s, characteristic_u);
  if (first || loop != this->loop_)
  {
    this->loop_ = loop;
    this->limits = stabilityLimits(this->device->info(), loop);
  }
  const DeviceInfo& info = this->device->info();
  const double stiffness_N_per_m =
    std::min({ parameters.stiffness_N_per_m, this->limits.largest_N_per_m, info.heldStiffness_N_per_m.value });
  if (parameters.walls.hold && info.closesWalls() && stiffness_N_per_m != this->viscousAt_N_per_m_)
  {
    this->viscousAt_N_per_m_ = stiffness_N_per_m;
    this->viscosity_Ns_per_m_ = corridorViscosity(info, stiffness_N_per_m);
  }
  this->adapted = adaptToDevice(parameters, info, this->limits, this->viscosity_Ns_per_m_);
  this->adapted.ballLead = this->lead;
  double& rubs = this->adapted.contact.friction.kinetic;
  rubs = characteristic_u > 0.0 ? std::min(rubs, largestToolFriction) : rubs;
}

} // namespace palpate
