// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/labyrinth/LabyrinthRun.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

#include "devices/simulated/SimulatedDevice.h"
#include "devices/simulated/labyrinth/BlindHand.h"
#include "haptics/force/Viscosity.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/scene/TouchedData.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{
namespace
{

constexpr double device_s = 1e-3; // between two steps of the simulated device
constexpr double stiffness_N_per_m = 1000.0;
constexpr double fastest_m_per_s = 0.04;

HapticParameters parametersOf(const Labyrinth& labyrinth, const LabyrinthRun& run, const DeviceInfo& info)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = stiffness_N_per_m;
  parameters.contact.radius_u = labyrinth.radius_u();
  parameters.map = fitted(labyrinth, info.workspaceRadius_m.value);
  parameters.walls.hold = run.deviceHoldsWalls;
  parameters.game = gameOf(labyrinth);
  parameters.safety = SafetyLimits::forDevice(info);
  parameters.safety.needsEngage = false;
  const double loop_s = run.deviceHoldsWalls ? device_s : 1.0 / run.host_Hz;
  const StabilityLimits limits = stabilityLimits(info, loopSettings(parameters, loop_s));
  const double held_N_per_m = std::min(stiffness_N_per_m, limits.largest_N_per_m);
  return adaptToDevice(parameters, info, limits, run.deviceHoldsWalls ? corridorViscosity(info, held_N_per_m) : 0.0);
}

/// Distance at which a new place is reached, as a share of the disc's radius.
constexpr double near = 0.75;

} // namespace

BlindPlan blindPlan(const Labyrinth& labyrinth, const LabyrinthRun& run, const WorkspaceMap& map)
{
  constexpr double pressing_N = 2.0;
  BlindPlan plan;
  plan.step_m = 0.5 * labyrinth.corridor_u / map.scale_u_per_m;
  plan.near_m = near * labyrinth.radius_u() / map.scale_u_per_m;
  plan.again_m = 1.2 * labyrinth.radius_u() / map.scale_u_per_m;
  plan.speed_m_per_s = std::min(fastest_m_per_s, 0.1 * plan.step_m * run.host_Hz);
  plan.touch_N = std::min(0.3, 0.5 * stiffness_N_per_m * labyrinth.radius_u() / map.scale_u_per_m);
  plan.friction_m = run.device.friction_N / run.hand.stiffness_N_per_m;
  plan.lead_m = pressing_N / run.hand.stiffness_N_per_m + plan.friction_m;
  plan.grain_m = std::max(0.1 * plan.step_m, run.device.encoderStep_m);
  return plan;
}

Felt feltOf(const HapticState& state, const Vec3& handle_D, const WorkspaceMap& map)
{
  const Vec3 location_D = map.toDevice(state.proxy_W.p);
  return { handle_D, location_D, state.stiffness_N_per_m * (location_D - handle_D) };
}

namespace
{

class Runner
{
public:
  Runner(const Labyrinth& labyrinth, const LabyrinthRun& run)
    : run_(run), every_(std::max(1, static_cast<int>(std::lround(1.0 / (run.host_Hz * device_s))))),
      device_(run.device, run.hand, { { Vec3::Zero() } }, { .period_s = device_s }),
      scene_(wholeScene({ wallsOf(labyrinth) }).scene), parameters_(parametersOf(labyrinth, run, this->device_.info())),
      hand_(blindPlan(labyrinth, run, this->parameters_.map),
        this->parameters_.map.toDevice(this->parameters_.game.start_W))
  {
  }

  LabyrinthOutcome go()
  {
    this->outcome_.problem = this->device_.open();
    const auto most = static_cast<std::int64_t>(this->run_.mostTime_s / device_s);
    for (std::int64_t tick = 1; this->outcome_.problem.empty() && tick <= most; ++tick)
    {
      DeviceSample sample;
      this->device_.lead(this->arm_D(tick));
      (void)this->device_.read(static_cast<double>(tick) * device_s, sample);
      if (tick % this->every_ == 0 && this->host(sample))
      {
        return this->finish();
      }
    }
    if (this->outcome_.problem.empty())
    {
      this->outcome_.problem = this->outcome_.explored ? "the hand did not arrive in time" : this->notBrought();
    }
    return this->finish();
  }

private:
  [[nodiscard]] double host_s() const { return this->every_ * device_s; }

  /// The arm moves at constant speed from look to look.
  [[nodiscard]] Vec3 arm_D(std::int64_t tick) const
  {
    const double share = static_cast<double>((tick - 1) % this->every_ + 1) / this->every_;
    return this->from_D_ + share * (this->to_D_ - this->from_D_);
  }

  /// One update of the host. True on arrival at the exit.
  bool host(const DeviceSample& sample)
  {
    TickInput input;
    input.tick = ++this->ticks_;
    input.dt_s = this->host_s();
    input.sample = sample;
    input.scene = this->scene_.get();
    const TickOutput out = renderTick(input, this->parameters_, this->renderer_);
    this->device_.write(out.command);
    if (out.state.game == GamePhase::Explores)
    {
      this->explore(sample, out.state);
    }
    else
    {
      this->from_D_ = this->to_D_ = sample.pose_D.p; // the arm follows the handle
      this->lead_N_ = std::max(this->lead_N_, out.state.force_D.norm());
    }
    return out.state.game == GamePhase::Arrived;
  }

  void explore(const DeviceSample& sample, const HapticState& state)
  {
    const Felt felt = feltOf(state, sample.pose_D.p, this->parameters_.map);
    this->from_D_ = std::exchange(this->to_D_, this->hand_.look(felt, this->host_s()));
    this->note(state);
    if (this->hand_.exhausted() || this->hand_.lost())
    {
      this->outcome_.problem = this->hand_.lost()
                                 ? "the hand could not return to its previous position"
                                 : "the hand explored all reachable corridors without finding the exit";
    }
  }

  void note(const HapticState& state)
  {
    const Vec3& location_W = state.proxy_W.p;
    const double force_N = state.force_D.norm();
    this->outcome_.lead_s = this->outcome_.explored ? this->outcome_.lead_s : state.time_s;
    this->outcome_.time_s = state.gameTime_s;
    this->outcome_.way_u += this->outcome_.explored ? (location_W - this->location_W_).norm() : 0.0;
    this->outcome_.peakForce_N = std::max(this->outcome_.peakForce_N, force_N);
    this->location_W_ = location_W;
    this->outcome_.explored = true;
    const int every = std::max(1, 10 / this->every_);
    if (this->run_.trace && this->ticks_ % static_cast<std::uint64_t>(every) == 0)
    {
      this->outcome_.trace.push_back({ state.gameTime_s, state.device_W.p, location_W, force_N });
    }
  }

  /// The slower a host is, the more gently it must guide the hand, and then it may not overcome the device's friction.
  [[nodiscard]] std::string notBrought() const
  {
    std::ostringstream text;
    text << "the hand could not be guided to the start in time";
    if (this->lead_N_ <= this->run_.device.friction_N)
    {
      text << ": a host of " << this->run_.host_Hz << " Hz may pull the hand with " << this->lead_N_
           << " N at most, and the friction of the device is " << this->run_.device.friction_N
           << " N; a faster host, or a device that holds its walls itself, can";
    }
    return text.str();
  }

  LabyrinthOutcome finish()
  {
    this->outcome_.places = this->hand_.memory().places();
    return std::move(this->outcome_);
  }

  const LabyrinthRun& run_;
  int every_; ///< periods of the device per update of the host
  SimulatedDevice device_;
  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  BlindHand hand_;
  RendererState renderer_;
  Vec3 from_D_ = Vec3::Zero(), to_D_ = Vec3::Zero(); ///< position of the arm at the last look and the next [m]
  Vec3 location_W_ = Vec3::Zero();
  std::uint64_t ticks_ = 0;
  double lead_N_ = 0.0; ///< the largest force on the path to the start
  LabyrinthOutcome outcome_;
};

} // namespace

std::string refuse(const Labyrinth& labyrinth, const LabyrinthRun& run)
{
  std::string problem = refuse(labyrinth);
  if (!problem.empty())
  {
    return problem;
  }
  if (!(run.hand.stiffness_N_per_m > 0.0))
  {
    return "the hand '" + run.hand.name + "' has no stiffness, so that the handle does not move; choose another hand";
  }
  const double scale_u_per_m = fitted(labyrinth, run.device.workspaceRadius_m).scale_u_per_m;
  const double coarsest_m = near * labyrinth.radius_u() / scale_u_per_m / std::sqrt(2.0);
  if (run.device.encoderStep_m > coarsest_m)
  {
    std::ostringstream text;
    text << "the device '" << run.device.name << "' has a resolution of " << 1e3 * run.device.encoderStep_m
         << " mm, but corridors of " << 1e3 * labyrinth.corridor_u / scale_u_per_m << " mm need " << 1e3 * coarsest_m
         << " mm or finer";
    return text.str();
  }
  return {};
}

LabyrinthOutcome runBlind(const Labyrinth& labyrinth, const LabyrinthRun& run)
{
  LabyrinthOutcome refused;
  refused.problem = refuse(labyrinth, run);
  return refused.problem.empty() ? Runner(labyrinth, run).go() : refused;
}

} // namespace palpate
