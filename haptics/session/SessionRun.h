// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

#include "haptics/force/Viscosity.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/DeviceTimer.h"
#include "haptics/session/HapticSession.h"
#include "haptics/tool/servo/RubbedWish.h"

namespace palpate
{

/// Everything that lives from start() to stop().
struct HapticSession::Run
{
  std::unique_ptr<HapticDevice> device;
  std::unique_ptr<TickTimer> timer;
  MonotonicClock clock;
  ServoLinks links;
  std::optional<ToolWorker> tool;
  std::optional<SoftWorker> soft;
  std::optional<MechanismWorker> mechanism;
  std::optional<Recordings> recordings;
  std::optional<ServoLoop> loop;
  std::mutex schedulingMutex; ///< taken once by the servo thread, before its first tick
  SchedulingReport scheduling;
  RealtimeThread thread;
  bool virtualTime = false;
  double period_s = 1e-3;
  double virtual_s = 0.0;   ///< time of the last tick, in virtual time
  HapticParameters adapted; ///< what the servo runs with
  BallLead lead;            ///< the last one
  StabilityLimits limits;

  /// A virtual time goes by itself, whatever the device would pace.
  void pace(std::int64_t period_ns)
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

  /// In virtual time, after the last tick.
  void stepWorkers()
  {
    this->tool->step(this->virtual_s);
    this->soft->step(this->virtual_s);
    this->mechanism->step(this->virtual_s);
  }

  /// From where the ball comes in this scene; nothing: from where it is.
  void leadFrom(const Scene* scene, const std::optional<Vec3>& from_W)
  {
    const bool leads = scene != nullptr && from_W;
    this->lead = { this->lead.number + 1, leads ? scene->geometryHash() : 0, from_W.value_or(Vec3::Zero()) };
  }

  /// Limits come from eigenvalues: computed again only when something they depend on has changed.
  void adapt(const HapticParameters& parameters, double lever_u, bool first)
  {
    const LoopSettings loop = loopSettings(parameters, this->period_s, lever_u);
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
    rubs = lever_u > 0.0 ? std::min(rubs, largestToolFriction) : rubs;
  }

private:
  LoopSettings loop_;
  double viscousAt_N_per_m_ = -1.0; ///< stiffness that the viscosity was found for
  double viscosity_Ns_per_m_ = 0.0;
};

} // namespace palpate
