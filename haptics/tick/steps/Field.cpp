// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Field.h"

#include <algorithm>
#include <cmath>

#include "haptics/core/Fade.h"
#include "haptics/force/VirtualCoupling.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

constexpr Fade fade{ 0.03 }; ///< as long as a change of scene takes

bool isFelt(const TickContext& tick) noexcept
{
  return tick.input.brick != nullptr && tick.out.state.stiffness_N_per_m > 0.0;
}

/// One tick in the field that there is. A hand that another map has put elsewhere passed nothing on the way.
FieldResult move(const TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const WorkspaceMap& map = tick.p.map;
  FieldResult felt;
  if (!isFelt(tick) || !isSame(s.fieldMap, map))
  {
    felt.letGo = s.field.placed;
    s.field = FieldState{};
  }
  s.fieldMap = map;
  if (isFelt(tick))
  {
    const double stiffness_N_per_u = tick.out.state.stiffness_N_per_m / map.scale_u_per_m;
    const bool letGo = felt.letGo;
    FieldPlan plan = tick.p.field;
    plan.friction = tick.p.contact.friction;
    felt = moveFieldProxy(*tick.input.brick, plan, stiffness_N_per_u, tick.out.state.device_W.p, s.field);
    felt.letGo = felt.letGo || letGo;
  }
  return felt;
}

SpringTick springTick(const TickContext& tick, const Vec3& pull_D, const FieldResult& felt) noexcept
{
  const HapticState& state = tick.out.state;
  SpringTick spring;
  const double pull_m = pull_D.norm();
  spring.stretch_m = std::sqrt(felt.stretch2_u2) / tick.p.map.scale_u_per_m;
  spring.inward_m_per_s = pull_m > 0.0 ? -pull_D.dot(state.velocity_D) / pull_m : 0.0;
  spring.stiffness_N_per_m = state.stiffness_N_per_m;
  spring.work_J = tick.way_D ? tick.s.fieldSpring_D.dot(*tick.way_D) : 0.0;
  spring.dt_s = tick.input.dt_s;
  spring.restart = !tick.s.ownForce || felt.letGo;
  return spring;
}

/// Spring and damper like the contact's, kept passive by a meter of its own.
Vec3 springForce_D(TickContext& tick, const FieldResult& felt) noexcept
{
  const HapticState& state = tick.out.state;
  const Vec3 pull_D = tick.p.map.directionToDevice(felt.pull_W / tick.p.map.scale_u_per_m);
  const SpringTick spring = springTick(tick, pull_D, felt);
  measureEnergy(spring, tick.s.fieldEnergy);
  const double damping_Ns_per_m =
    tick.p.damping_Ns_per_m + stabilisingDamping(tick.p.passivity, spring, tick.s.fieldEnergy);
  return coupleDevice(pull_D, state.velocity_D, state.stiffness_N_per_m, damping_Ns_per_m);
}

/// The rest of a force that ended, shorter from tick to tick.
Vec3 fading_D(TickContext& tick, bool letGo, const Vec3& force_D) noexcept
{
  RendererState& s = tick.s;
  s.fieldFade_s = std::max(0.0, s.fieldFade_s - tick.input.dt_s);
  if (letGo)
  {
    s.fieldFade_D = s.fieldForce_D - force_D;
    s.fieldFade_s = fade.time_s;
  }
  return fade.linearShare(s.fieldFade_s) * s.fieldFade_D;
}

void tell(const FieldResult& felt, TickContext& tick) noexcept
{
  FieldReport& report = tick.out.state.field;
  const Vec3& hand_W = tick.out.state.device_W.p;
  report.proxy_W = tick.p.field.isosurface && tick.s.field.surface.placed ? felt.surface_W : Vec3(hand_W + felt.pull_W);
  report.force_D = tick.s.fieldForce_D;
  report.energy = tick.s.fieldEnergy;
  report.error_u = felt.error_u;
  report.contacts = felt.contacts;
  report.outside = felt.outside;
  report.beyondTicks = tick.s.fieldBeyond;
  report.capped = felt.capped;
}

} // namespace

bool Field::feels(const TickContext& tick) noexcept
{
  return tick.input.brick != nullptr && isOn(tick.p.field);
}

void Field::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const FieldResult felt = move(tick);
  s.fieldBeyond += felt.beyond ? 1 : 0;
  s.fieldSpring_D = springForce_D(tick, felt);
  // A source begins once force is engaged, and never among those who ask for it.
  const Vec3 push_D = s.gain > 0.0 ? tick.p.map.directionToDevice(felt.push_W) : Vec3(Vec3::Zero());
  tick.out.state.field.pushPower_W = push_D.dot(tick.out.state.velocity_D);
  const Vec3 force_D = s.fieldSpring_D + push_D;
  s.fieldForce_D = force_D + fading_D(tick, felt.letGo, force_D);
  tell(felt, tick);
  tick.addBesideContact(s.fieldForce_D);
}

void Field::rest(TickContext& tick) noexcept
{
  tick.s.fieldSpring_D = tick.s.fieldForce_D = Vec3::Zero();
}

} // namespace palpate::stage
