// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/LabyrinthRun.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "devices/simulated/BlindHand.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/HeldWalls.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/ForceRenderer.h"

namespace palpate
{
namespace
{

constexpr double device_s = 1e-3; // between two looks of the simulation at its device
constexpr double stiffness_N_per_m = 1000.0;
constexpr double fastest_m_per_s = 0.04;

HapticParameters parametersOf(const Labyrinth& labyrinth, const DeviceInfo& info, double host_s)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = stiffness_N_per_m;
  parameters.contact.radius_u = labyrinth.radius_u();
  parameters.map = fitted(labyrinth, info.workspaceRadius_m.value);
  parameters.safety = SafetyLimits::forDevice(info);
  parameters.safety.needsEngage = false;
  return adaptToDevice(parameters, info, stabilityLimits(info, loopSettings(parameters, host_s)));
}

BlindPlan planOf(const Labyrinth& labyrinth, const LabyrinthRun& run, const WorkspaceMap& map)
{
  constexpr double pressing_N = 2.0;
  BlindPlan plan;
  plan.step_m = 0.5 * labyrinth.corridor_u / map.scale_u_per_m;
  plan.near_m = 0.75 * labyrinth.radius_u() / map.scale_u_per_m;
  plan.again_m = 1.2 * labyrinth.radius_u() / map.scale_u_per_m;
  plan.speed_m_per_s = std::min(fastest_m_per_s, 0.1 * plan.step_m * run.host_Hz);
  plan.touch_N = 0.3;
  plan.lead_m = (pressing_N + run.device.friction_N) / run.hand.stiffness_N_per_m;
  plan.grain_m = std::max(0.1 * plan.step_m, run.device.encoderStep_m);
  return plan;
}

class Runner
{
public:
  Runner(const Labyrinth& labyrinth, const LabyrinthRun& run)
    : labyrinth_(labyrinth), run_(run),
      every_(std::max(1, static_cast<int>(std::lround(1.0 / (run.host_Hz * device_s))))),
      device_(run.device, run.hand, { { this->start_D() } }, { .period_s = device_s }),
      scene_(SceneBuilder().build({ wallsOf(labyrinth) }).scene), curves_(fenced(labyrinth)),
      parameters_(parametersOf(labyrinth, this->device_.info(), this->host_s())),
      hand_(planOf(labyrinth, run, this->parameters_.map), this->start_D())
  {
  }

  LabyrinthOutcome go()
  {
    this->outcome_.problem = this->device_.open();
    const auto most = static_cast<std::int64_t>(this->run_.mostTime_s / device_s);
    for (std::int64_t tick = 1; this->outcome_.problem.empty() && tick <= most; ++tick)
    {
      DeviceSample sample;
      (void)this->device_.read(static_cast<double>(tick) * device_s, sample);
      if (tick % this->every_ == 0 && this->host(sample))
      {
        return this->finish();
      }
    }
    if (this->outcome_.problem.empty())
    {
      this->outcome_.problem = "it did not arrive in the time it was given";
    }
    return this->finish();
  }

private:
  [[nodiscard]] double host_s() const { return this->every_ * device_s; }

  [[nodiscard]] Vec3 start_D() const
  {
    const Eigen::Vector2d& start = *this->labyrinth_.start_W;
    return fitted(this->labyrinth_, infoOf(this->run_.device).workspaceRadius_m.value)
      .toDevice({ start.x(), start.y(), 0 });
  }

  /// One update of the host. True when the disc has arrived.
  bool host(const DeviceSample& sample)
  {
    TickInput input;
    input.tick = ++this->ticks_;
    input.dt_s = this->host_s();
    input.sample = sample;
    input.scene = this->scene_.get();
    const TickOutput out = renderTick(input, this->parameters_, this->renderer_);
    const Vec3 location_D = this->parameters_.map.toDevice(out.state.proxy_W.p);
    DeviceCommand command = out.command;
    if (this->run_.deviceHoldsWalls)
    {
      command = this->heldRound(out.state, sample.pose_D.p, location_D);
    }
    this->device_.write(command);
    const double K = out.state.stiffness_N_per_m;
    const Felt felt{ sample.pose_D.p, location_D, K * (location_D - sample.pose_D.p) };
    this->device_.lead(this->hand_.look(felt, this->host_s()));
    this->note(out.state, felt.force_D.norm());
    if (this->hand_.exhausted() || this->hand_.lost())
    {
      this->outcome_.problem = this->hand_.lost() ? "it could not get back to where it came from"
                                                  : "it has been everywhere it could reach, and nowhere was the exit";
    }
    return (out.state.proxy_W.p.head<2>() - *this->labyrinth_.exit_W).norm() <= this->labyrinth_.exitReach_u();
  }

  /// The walls round the virtual location, for the device's own loop.
  [[nodiscard]] DeviceCommand heldRound(const HapticState& state, const Vec3& handle_D, const Vec3& location_D)
  {
    const WorkspaceMap& map = this->parameters_.map;
    const Eigen::Vector2d x = state.proxy_W.p.head<2>();
    const double r = this->parameters_.contact.radius_u, reach_u = 1.0 * this->labyrinth_.corridor_u;
    std::vector<NearWall> walls;
    for (const auto& [a, b] : this->curves_.segments)
    {
      const Eigen::Vector2d p = this->curves_.points_W[a], d = this->curves_.points_W[b] - p;
      const double t = std::clamp((x - p).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const Eigen::Vector2d away = x - (p + t * d);
      const double gap_u = away.norm() - r;
      if (gap_u < reach_u)
      {
        walls.push_back({ Vec3(away.x(), away.y(), 0).normalized(), std::max(0.0, gap_u) / map.scale_u_per_m });
      }
    }
    this->held_ = ledTo(this->held_, wallsAround(location_D, walls), handle_D, 0.5e-3);
    DeviceCommand command;
    palpate::command(this->held_, state.stiffness_N_per_m, command);
    return command;
  }

  void note(const HapticState& state, double force_N)
  {
    const Vec3& location_W = state.proxy_W.p;
    this->outcome_.time_s = static_cast<double>(this->ticks_) * this->host_s();
    this->outcome_.way_u += this->ticks_ > 1 ? (location_W - this->location_W_).norm() : 0.0;
    this->outcome_.peakForce_N = std::max(this->outcome_.peakForce_N, force_N);
    this->location_W_ = location_W;
    const std::uint64_t every = std::max(1, 10 / this->every_);
    if (this->run_.trace && this->ticks_ % every == 0)
    {
      this->outcome_.trace.push_back({ this->outcome_.time_s, state.device_W.p, location_W, force_N });
    }
  }

  LabyrinthOutcome finish()
  {
    this->outcome_.places = this->hand_.memory().places();
    return std::move(this->outcome_);
  }

  const Labyrinth& labyrinth_;
  const LabyrinthRun& run_;
  int every_; ///< periods of the device to an update of the host
  SimulatedDevice device_;
  std::shared_ptr<const Scene> scene_;
  CurveSet curves_;
  HapticParameters parameters_;
  BlindHand hand_;
  RendererState renderer_;
  AxisWalls held_;
  Vec3 location_W_ = Vec3::Zero();
  std::uint64_t ticks_ = 0;
  LabyrinthOutcome outcome_;
};

} // namespace

LabyrinthOutcome runBlind(const Labyrinth& labyrinth, const LabyrinthRun& run)
{
  LabyrinthOutcome refused;
  refused.problem = refuse(labyrinth);
  return refused.problem.empty() ? Runner(labyrinth, run).go() : refused;
}

} // namespace palpate
