// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/HeldMechanism.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/wire/WirePlan.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// The hand's target pose of the body in it: turned as the hand is when it takes the body. After a clutch, and in
/// another map, the target starts at the body's turn then.
Pose lead_W(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const Pose& device_W = tick.out.state.device_W;
  const bool anew = tick.otherMap || s.mechanismLoose;
  s.mechanismLoose = tick.p.clutch;
  if (!s.mechanismLead.taken && device_W.q.squaredNorm() > 0.0)
  {
    s.mechanismLead.turn_W = device_W.q.normalized();
  }
  return leadTool(device_W, anew, s.mechanismLead);
}

/// Another plan begins anew, before anything is told or broken of it: constraints and bodies are numbered by it.
void takePlan(TickContext& tick) noexcept
{
  const MechanismPlan& plan = tick.input.mechanism->plan();
  if (tick.s.mechanism.revision != plan.revision)
  {
    beginAnew(plan, tick.s.mechanism);
    tick.s.mechanismChanges = {};
    tick.s.mechanismChanges.plan = plan.revision;
    tick.s.wireTurned_rad = 0.0;
  }
}

/// Turn of a wire that the person asks for in addition to the hand's.
double turnWireBy_rad(TickContext& tick) noexcept
{
  constexpr double most_rad_per_s = 2.0 * std::numbers::pi, radPerDegree = std::numbers::pi / 180.0;
  const double most_rad = most_rad_per_s * tick.input.dt_s;
  const double by_rad = std::clamp(radPerDegree * tick.p.wireTurn_deg - tick.s.wireTurned_rad, -most_rad, most_rad);
  tick.s.wireTurned_rad += by_rad;
  return by_rad;
}

/// A constraint that the person breaks holds nothing from this tick on, whether the tick knows the place of the hand or
/// not.
void breakConstraints(TickContext& tick) noexcept
{
  for (const HapticEvent& event : tick.input.events)
  {
    if (event.kind == EventKind::BreakConstraint && event.value < tick.s.mechanism.laws.size())
    {
      tick.s.mechanism.laws[event.value].phase = ConstraintPhase::Gone;
    }
  }
}

/// The state of the tick before may be of a recording, or in another workspace: the tick's own counts.
const MechanismResult& compute(TickContext& tick, double lever_m) noexcept
{
  const double scale_u_per_m = tick.p.map.scale_u_per_m;
  const double stiffness_N_per_m = tick.out.state.stiffness_N_per_m;
  MechanismInput input;
  input.tick = tick.input.tick;
  input.dt_s = tick.input.dt_s;
  input.plan = &tick.input.mechanism->plan();
  input.hand_W = heldBy(lead_W(tick), *input.plan);
  input.grip = { stiffness_N_per_m / scale_u_per_m, stiffness_N_per_m * lever_m * lever_m * scale_u_per_m };
  input.turnBy_rad = turnWireBy_rad(tick);
  input.wireBudget = tick.p.contact.workBudget;
  input.soft = tick.input.mechanism->soft();
  input.found = tick.input.mechanism->found();
  input.meshes = tick.input.mechanism->meshes().get();
  MechanismTick& room = *tick.input.mechanismTick;
  room.restore(tick.s.mechanism);
  const MechanismResult& result = room.step(input);
  tick.s.mechanism = room.state();
  const Quat& turn_W = lever_m > 0.0 ? input.hand_W.q : result.pose_W[input.plan->held].q; // else it turns freely
  tick.out.state.mechanism.hand_W = { input.hand_W.p, turn_W };
  return result;
}

/// The lever by which the hand feels the turn of a mesh: a spring that keeps a mesh upright may have a longer one than
/// the mesh has, by which the damper and the limit of the torque would be those of a larger mesh.
double feltLever_m(const TickContext& tick, double lever_m) noexcept
{
  const MechanismPlan& plan = tick.input.mechanism->plan();
  const PlannedBody& held = plan.bodies[static_cast<std::size_t>(plan.held)];
  const double farthest_u = held.low_u.cwiseAbs().cwiseMax(held.high_u.cwiseAbs()).norm();
  return farthest_u > 0.0 ? std::min(lever_m, farthest_u / tick.p.map.scale_u_per_m) : lever_m;
}

/// Force and torque as the stretch of a plain spring of the coupling's stiffness. Of a spring that keeps a mesh
/// upright, whose lever is far longer than the mesh, the hand feels the turn by the spring of the lever that is felt:
/// damper and limits hold for no stiffer one.
void pull(TickContext& tick, const MechanismResult& result, double ofSpring_m) noexcept
{
  const double lever_m = feltLever_m(tick, ofSpring_m);
  const double scale_u_per_m = tick.p.map.scale_u_per_m;
  const double stiffness_N_per_m = tick.out.state.stiffness_N_per_m;
  const bool pulls = stiffness_N_per_m > 0.0;
  const double perNewton_m = pulls ? 1.0 / stiffness_N_per_m : 0.0;
  tick.pull_D = tick.p.map.directionToDevice(perNewton_m * result.wrench_W.force);
  tick.stretch_m = std::sqrt(2.0 * std::max(result.stored_Nu, 0.0) / scale_u_per_m * perNewton_m);
  if (lever_m > 0.0)
  {
    constexpr double farLonger = 2.0;
    const double times = ofSpring_m / lever_m, share = times > farLonger ? 1.0 / (times * times) : 1.0;
    const Vec3 turned_W = share * perNewton_m / (scale_u_per_m * lever_m) * result.wrench_W.torque;
    tick.turn = { tick.p.map.directionToDevice(turned_W), Tool::turning_D(tick, lever_m), lever_m };
  }
}

/// Of the oldest snapshot among those of bodies that are pressed. A tick that comes late is as long as those that were
/// missed: ticks are counted with them.
double age_s(const TickContext& tick, const MechanismResult& result) noexcept
{
  const std::uint64_t since = tick.input.tick - tick.s.mechanismTick;
  const bool counts = tick.s.mechanismTick > 0 && since > 0;
  const double period_s = counts ? tick.input.dt_s / static_cast<double>(since) : tick.input.dt_s;
  std::uint64_t oldest = tick.input.tick;
  for (int i = 0; i < result.pressCount; ++i)
  {
    const PressedBody& body = *tick.input.mechanism->soft()[static_cast<std::size_t>(result.presses[i].soft)];
    oldest = std::min(oldest, body.snapshot->builtFromTick);
  }
  return period_s * static_cast<double>(tick.input.tick - oldest);
}

void tellConstraints(const MechanismPlan& plan, const MechanismState& state, MechanismNow& now) noexcept
{
  now.held = state.placed;
  now.revision = plan.revision;
  now.bodyCount = plan.bodyCount;
  now.lawCount = plan.lawCount;
  now.pose_W = state.pose_W;
  for (int l = 0; l < plan.lawCount; ++l)
  {
    now.laws[l].phase = state.laws[l].phase;
  }
}

/// Contacts that were found stand behind the plan's constraints, in their own order.
void tellFound(
  const MechanismPlan& plan, const FoundContacts& found, const MechanismResult& result, MechanismNow& now) noexcept
{
  for (int l = 0; l < result.found; ++l)
  {
    const ConstraintNow& law = result.laws[plan.lawCount + l];
    if (law.force_W != Vec3::Zero())
    {
      now.found[now.touching++] = { found.contacts[l].mesh, found.contacts[l].body, law.at_W, law.force_W };
    }
  }
}

/// The forces of the wall on a wire, as many as there is room for.
void tellWall(const MechanismPlan& plan, const WireState& wire, MechanismNow& now) noexcept
{
  const auto room = static_cast<int>(now.found.size());
  for (int i = 0; plan.wire && i < std::min(wire.pressCount, room); ++i)
  {
    const WirePress& press = wire.presses[i];
    now.found[now.touching++] = { plan.held, plan.held, plan.wire->mouth_W * press.at_M,
      plan.wire->mouth_W.q * press.force_M };
  }
}

void tell(const TickContext& tick, const MechanismResult& result, HapticState& state) noexcept
{
  const MechanismPlan& plan = tick.input.mechanism->plan();
  MechanismNow& now = state.mechanism;
  tellConstraints(plan, tick.s.mechanism, now);
  for (int l = 0; l < plan.lawCount; ++l)
  {
    const ConstraintNow& law = result.laws[l];
    now.laws[l] = { law.phase, law.force_W.norm(), law.at_W, law.inside_u };
    state.contacts += law.force_W != Vec3::Zero();
  }
  tellFound(plan, tick.s.mechanism.found, result, now);
  state.contacts += now.touching + result.wire.pressCount;
  tellWall(plan, tick.s.mechanism.wire, now);
  now.wire = result.wire;
  now.ahead = result.ahead;
  now.leftOut = tick.s.mechanism.found.leftOut;
  now.residual_u = result.residual_u;
  now.capped = state.capped = result.capped;
  state.proxy_W = now.pose_W[plan.held];
}

void tellChanges(TickContext& tick, const MechanismResult& result, MechanismNow& now) noexcept
{
  ConstraintChanges& changes = tick.s.mechanismChanges;
  std::for_each_n(
    result.events.begin(), result.eventCount, [&changes](const MechanismEvent& event) { changes.add(event); });
  now.changes = changes;
}

/// Input of the worker's next snapshots.
void tellWorker(TickContext& tick, const MechanismResult& result) noexcept
{
  const MechanismPlan& plan = tick.input.mechanism->plan();
  const Pose& held_W = tick.s.mechanism.pose_W[plan.held];
  MechanismHand& hand = tick.s.mechanismHand;
  hand.tick = tick.input.tick;
  hand.plan = plan.revision;
  hand.hand_W = tick.out.state.device_W.p;
  hand.tip_W = held_W * (plan.bodies[plan.held].length_u * Vec3::UnitZ());
  hand.press(result);
}

void letGo(TickContext& tick) noexcept
{
  if (tick.s.mechanismTick > 0)
  {
    static_cast<HeldMechanism::State&>(tick.s) = HeldMechanism::State{};
  }
  tick.s.mechanismHand.tick = tick.input.tick;
  tick.s.mechanismHand.hand_W = tick.s.mechanismHand.tip_W = tick.out.state.device_W.p;
}

} // namespace

bool HeldMechanism::feels(const TickContext& tick) noexcept
{
  return tick.input.mechanism != nullptr;
}

void HeldMechanism::step(TickContext& tick) noexcept
{
  if (tick.input.mechanism == nullptr)
  {
    letGo(tick);
    return;
  }
  const double lever_m = mechanismLever_m(tick.p.mechanismTurning_N_m_per_rad, tick.p.stiffness_N_per_m);
  takePlan(tick);
  breakConstraints(tick);
  const MechanismResult& result = compute(tick, lever_m);
  pull(tick, result, lever_m);
  tell(tick, result, tick.out.state);
  tellChanges(tick, result, tick.out.state.mechanism);
  tick.out.state.mechanism.age_s = age_s(tick, result);
  tick.judgeAge(tick.out.state.mechanism.age_s);
  tick.s.mechanismTick = tick.input.tick;
  tellWorker(tick, result);
}

void HeldMechanism::rest(TickContext& tick) noexcept
{
  if (tick.input.mechanism == nullptr)
  {
    return;
  }
  takePlan(tick);
  breakConstraints(tick);
  tick.s.mechanismHand.tick = tick.s.mechanismTick = tick.input.tick; // bodies are computed while the hand rests
  const MechanismPlan& plan = tick.input.mechanism->plan();
  MechanismNow& now = tick.out.state.mechanism;
  tellConstraints(plan, tick.s.mechanism, now);
  now.changes = tick.s.mechanismChanges;
  now.hand_W = now.pose_W[plan.held];
  if (now.held)
  {
    tick.out.state.proxy_W = now.hand_W;
  }
}

} // namespace palpate::stage
