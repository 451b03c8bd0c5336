// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Samples.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

constexpr double badSampleWindow_s = 1.0; // the third bad sample within it latches

void countBadSample(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  if (s.sinceBadBefore_s < badSampleWindow_s)
  {
    tick.latch(Fault::NonFiniteSample);
    s.gain = 0.0;
  }
  s.sinceBadBefore_s = s.sinceBad_s;
  s.sinceBad_s = 0.0;
}

} // namespace

void Samples::forget(State& state) noexcept
{
  state.sinceBad_s = state.sinceBadBefore_s = State::longAgo_s;
}

void Samples::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  s.sinceBad_s += tick.input.dt_s;
  s.sinceBadBefore_s += tick.input.dt_s;
  if (tick.input.status == DeviceStatus::Lost)
  {
    tick.latch(Fault::DeviceLost);
    s.gain = 0.0;
  }
  tick.latch(tick.input.lateness.fault);
  if (tick.input.status == DeviceStatus::Waiting)
  {
    tick.out.state.held = true;
  }
  else if (!isFinite(tick.input.sample) || !tick.p.map.toScene(tick.input.sample.pose_D.p).allFinite())
  {
    countBadSample(tick);
    tick.out.state.held = true;
  }
}

} // namespace palpate::stage
