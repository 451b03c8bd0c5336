// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Guide.h"

#include <algorithm>

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

void Guide::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  GuidePlan plan = tick.p.guide;
  const bool on = plan.on && s.engage == EngageState::Engaged;
  s.guideShare = rampedShare(s.guideShare, on, plan.ramp_s, tick.input.dt_s);
  state.guideShare = s.guideShare;
  if (state.guideShare > 0.0)
  {
    plan.stiffness_N_per_m = std::min(plan.stiffness_N_per_m, tick.p.stiffnessLimit_N_per_m) * state.stiffnessFactor;
    const double height_m = plan.normal_W.dot(state.device_W.p - plan.point_W) / tick.p.map.scale_u_per_m;
    const Vec3 normal_D = tick.p.map.directionToDevice(plan.normal_W);
    tick.addBesideContact(
      guideForce(plan, state.guideShare, height_m, normal_D.dot(state.velocity_D), tick.input.dt_s) * normal_D);
  }
}

} // namespace palpate::stage
