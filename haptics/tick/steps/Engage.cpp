// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Engage.h"

#include <algorithm>

#include "haptics/tick/TickContext.h"

namespace palpate
{

const char* name(EngageState state) noexcept
{
  switch (state)
  {
    case EngageState::Safe:
      return "safe";
    case EngageState::Armed:
      return "armed";
    case EngageState::Engaged:
      return "engaged";
    case EngageState::Fault:
      return "fault";
  }
  return "unknown";
}

namespace stage
{

void Requests::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  if (!tick.p.safety.needsEngage && s.engage == EngageState::Safe)
  {
    s.engage = EngageState::Engaged;
    s.gain = 1.0;
  }
  for (const HapticEvent& event : tick.input.events)
  {
    if (event.kind == EventKind::Engage && s.engage != EngageState::Engaged)
    {
      s.engage = EngageState::Armed;
      s.fault = Fault::None;
      s.gain = 0.0;
      Samples::forget(s);
    }
    else if (event.kind == EventKind::Release)
    {
      s.engage = EngageState::Safe;
      s.fault = Fault::None;
    }
  }
}

void Engage::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const SafetyLimits& limits = tick.p.safety;
  // Force that a blend hides for a moment comes when the blend has ended.
  const double twist_N =
    tick.turn.lever_m > 0.0 ? tick.out.state.renderedTorque_D.norm() / tick.turn.lever_m : 0.0; // at its lever's end
  const double asked_N =
    std::max({ tick.out.state.rendered_D.norm(), twist_N, tick.p.keepsHand ? s.lastRendered_D.norm() : 0.0 });
  if (s.engage == EngageState::Armed && !tick.out.state.letGo && !tick.homeless() && tick.feelable() &&
      asked_N <= limits.engageBelow_N)
  {
    s.engage = EngageState::Engaged;
  }
  const auto step = [&tick](double ramp_s) { return ramp_s > 0.0 ? tick.input.dt_s / ramp_s : 1.0; };
  if (s.engage == EngageState::Engaged && !tick.p.clutch && (tick.feelable() || !limits.needsEngage))
  {
    s.gain = std::min(1.0, s.gain + step(limits.engageRamp_s));
  }
  else
  {
    const double ramp_s = s.engage == EngageState::Fault ? limits.faultRamp_s : limits.releaseRamp_s;
    s.gain = std::max(0.0, s.gain - step(ramp_s));
  }
}

} // namespace stage
} // namespace palpate
