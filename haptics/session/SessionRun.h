// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "haptics/core/Clock.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/Recordings.h"
#include "haptics/session/ServoLoop.h"

namespace palpate
{

struct SessionWorkers;

/// Everything that lives from start() to stop().
struct HapticSession::Run
{
  Run();
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  std::unique_ptr<HapticDevice> device;
  std::unique_ptr<TickTimer> timer;
  MonotonicClock clock;
  ServoLinks links;
  std::unique_ptr<SessionWorkers> workers;
  std::optional<Recordings> recordings;
  std::optional<ServoLoop> loop;
  std::mutex schedulingMutex; ///< taken once by the servo thread, before its first tick
  SchedulingReport scheduling;
  RealtimeThread thread;
  bool virtualTime = false;
  double period_s = 1e-3;
  double virtual_s = 0.0;   ///< time of the last tick, in virtual time
  HapticParameters adapted; ///< the parameters that the servo runs with
  BallLead lead;            ///< the last one
  StabilityLimits limits;

  /// A virtual time goes by itself, whatever the device would pace.
  void pace(std::int64_t period_ns);
  /// From where the ball comes in this scene; nothing: from where it is.
  void leadFrom(const Scene* scene, const std::optional<Vec3>& from_W)
  {
    const bool leads = scene != nullptr && from_W;
    this->lead = { this->lead.number + 1, leads ? scene->geometryHash() : 0, from_W.value_or(Vec3::Zero()) };
  }

  /// Limits come from eigenvalues: computed again only when something they depend on has changed.
  void adapt(const HapticParameters& parameters, double characteristic_u, bool first);

private:
  LoopSettings loop_;
  double viscousAt_N_per_m_ = -1.0; ///< stiffness that the viscosity was found for
  double viscosity_Ns_per_m_ = 0.0;
};

} // namespace palpate
