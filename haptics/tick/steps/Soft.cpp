// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Soft.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// In periods: a snapshot on time is at most two old. From there on more of the force may be bent.
constexpr double latePeriods = 2.0;
constexpr double lateShare = 0.15;

std::span<const SoftSurfaceRef> touchOf(const TickContext& tick) noexcept
{
  return { &tick.input.body->touch, 1 };
}

/// A tick that comes late is as long as those that were missed: ticks are counted with them.
double period_s(const TickContext& tick) noexcept
{
  const std::uint64_t since = tick.input.tick - tick.s.softTick;
  return tick.s.softTick > 0 && since > 0 ? tick.input.dt_s / static_cast<double>(since) : tick.input.dt_s;
}

/// A body that the ball is not on any more, or another one, is met anew.
void takeSnapshot(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const PressedBody& body = *tick.input.body;
  if (tick.scene.replaced || s.softRevision == 0)
  {
    s.soft = SoftState{};
    s.softBalance = {};
  }
  else
  {
    changeSnapshots(touchOf(tick), s.soft);
  }
  s.softRevision = body.revision;
  s.softAge_s = period_s(tick) * static_cast<double>(tick.input.tick - body.snapshot->builtFromTick);
}

bool presses(const SoftState& soft) noexcept
{
  return std::any_of(soft.contacts.begin(), soft.contacts.begin() + soft.count,
    [](const SoftContact& c) { return c.gives && c.force_N.squaredNorm() > 0.0; });
}

EnergyBalancePlan balancePlan(const TickContext& tick) noexcept
{
  EnergyBalancePlan plan;
  plan.leastStep_u *= tick.p.map.scale_u_per_m; // it is in metres of the hand
  const bool late = tick.s.softAge_s > latePeriods * tick.input.body->period_s;
  plan.share = late && tick.input.body->period_s > 0.0 ? lateShare : plan.share;
  return plan;
}

/// Corrects the force so that the hand gets back no more than it gave.
void balance(TickContext& tick, SoftReport& report) noexcept
{
  RendererState& s = tick.s;
  const double scale = tick.p.map.scale_u_per_m;
  const double stiffness_N_per_m = tick.out.state.stiffness_N_per_m;
  const double pull_m = tick.pull_D.norm();
  if (!(pull_m > 0.0) || !(stiffness_N_per_m > 0.0))
  {
    s.softBalance = {};
    return;
  }
  const double stored_Nu = std::max(storedEnergy(touchOf(tick), s.soft, stiffness_N_per_m / scale), 0.0);
  report.stored_J = stored_Nu / scale;
  tick.stretch_m = std::sqrt(2.0 * report.stored_J / stiffness_N_per_m);
  if (!tick.p.softBalances)
  {
    return;
  }
  const Vec3 along_D = tick.pull_D / pull_m;
  const double step_u = tick.way_D ? -scale * along_D.dot(*tick.way_D) : 0.0;
  const double felt_N = along_D.dot(s.lastForce_D - s.besideContact_D);
  report.added_N =
    balanceEnergy(balancePlan(tick), stored_Nu, step_u, felt_N, stiffness_N_per_m * pull_m, s.softBalance);
  tick.pull_D += report.added_N / stiffness_N_per_m * along_D;
}

} // namespace

void SoftLead::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  if (tick.input.body == nullptr)
  {
    if (s.softRevision != 0)
    {
      static_cast<State&>(s) = State{};
    }
    return;
  }
  if (tick.scene.replaced || tick.input.body->revision != s.softRevision)
  {
    takeSnapshot(tick);
  }
  else
  {
    s.softAge_s += tick.input.dt_s;
  }
  s.softTick = tick.input.tick;
  const double fade_s = tick.input.body->period_s > 0.0 ? tick.input.dt_s : std::numeric_limits<double>::infinity();
  fadeChange(fade_s, s.soft); // a body at rest in every tick changes by its own solution, not by a snapshot
}

void Soft::step(TickContext& tick) noexcept
{
  if (tick.input.body == nullptr)
  {
    return;
  }
  SoftReport& report = tick.out.state.soft;
  report.felt = true;
  report.age_s = tick.s.softAge_s;
  report.pressed = presses(tick.s.soft);
  if (!report.pressed)
  {
    tick.s.softBalance = {};
    return;
  }
  report.yielded_W = tick.s.soft.yielded_W;
  balance(tick, report);
  tick.judgeAge(report.age_s);
}

} // namespace palpate::stage
