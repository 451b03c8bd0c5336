// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/line/LineTick.h"

#include <algorithm>
#include <cmath>

#include "haptics/safety/ForceLimits.h"

namespace palpate
{
namespace
{

void latch(Fault fault, LineState& state) noexcept
{
  if (state.engage != EngageState::Fault)
  {
    state.engage = EngageState::Fault;
    state.fault = fault;
  }
}

/// No force in a tick that does not know where the hand is.
DeviceCommand holdNothing(LineState& state) noexcept
{
  state.tracked = false;
  state.force_N = state.gain = 0.0;
  return {};
}

void follow(double s_m, double dt_s, LineState& state) noexcept
{
  constexpr double smoothing = 0.2;
  if (!state.tracked)
  {
    state.s_m = state.anchor_m = s_m;
    state.speed_m_per_s = 0.0;
  }
  state.speed_m_per_s += smoothing * ((s_m - state.s_m) / dt_s - state.speed_m_per_s);
  state.s_m = s_m;
  state.tracked = true;
}

void updateGain(const SafetyLimits& limits, double dt_s, LineState& state) noexcept
{
  const bool up = state.engage == EngageState::Engaged;
  const double ramp_s = up                                   ? limits.engageRamp_s
                        : state.engage == EngageState::Fault ? limits.faultRamp_s
                                                             : limits.releaseRamp_s;
  const double step = ramp_s > 0.0 ? dt_s / ramp_s : 1.0;
  state.gain = std::clamp(state.gain + (up ? step : -step), 0.0, 1.0);
}

void arm(const SafetyLimits& limits, const LineTickInput& input, double wanted_N, LineState& state) noexcept
{
  if (input.engage && state.engage != EngageState::Engaged)
  {
    state.engage = EngageState::Armed;
    state.fault = Fault::None;
  }
  const bool held = isHeld(limits.deadMan, input.sample.buttons, input.sample.grip);
  if (!held && state.engage == EngageState::Engaged)
  {
    state.engage = EngageState::Armed;
  }
  if (held && state.engage == EngageState::Armed && std::fabs(wanted_N) <= limits.engageBelow_N)
  {
    state.engage = EngageState::Engaged;
  }
}

} // namespace

DeviceCommand stepLine(
  const LineWorld& world, const SafetyLimits& limits, const LineTickInput& input, LineState& state) noexcept
{
  if (input.status == DeviceStatus::Waiting)
  {
    return holdNothing(state);
  }
  if (input.status != DeviceStatus::Ok || !isFinite(input.sample))
  {
    latch(input.status != DeviceStatus::Ok ? Fault::DeviceLost : Fault::NonFiniteSample, state);
    return holdNothing(state);
  }
  follow(input.sample.pose_D.p.x(), input.dt_s, state);
  const double wanted_N = lineForce(world, state.s_m) + lineFriction(world, state.s_m, state.anchor_m);
  arm(limits, input, wanted_N, state);
  if (const Fault fault = judgeHand(limits.hand, std::fabs(state.speed_m_per_s), std::fabs(state.force_N), 0.0);
      fault != Fault::None)
  {
    latch(fault, state);
  }
  updateGain(limits, input.dt_s, state);
  const Vec3 before_D(state.force_N, 0.0, 0.0), asked_D(smoothstep(state.gain) * wanted_N, 0.0, 0.0);
  DeviceCommand command;
  command.wrench_D.force =
    limitRise(clampMagnitude(asked_D, limits.maxForce_N), before_D, limits.maxRise_N_per_s, input.dt_s);
  state.force_N = command.wrench_D.force.x();
  return command;
}

} // namespace palpate
