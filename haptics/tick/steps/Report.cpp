// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Report.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// The reason why there is no force: a latched fault, or a passing one.
Fault faultOf(const TickContext& tick) noexcept
{
  if (tick.s.fault != Fault::None)
  {
    return tick.s.fault;
  }
  if (tick.input.status == DeviceStatus::Waiting)
  {
    return Fault::NoHand;
  }
  if (tick.seatFailed)
  {
    return Fault::PlacementFailed;
  }
  if (tick.toolWaits)
  {
    return Fault::ToolWaits;
  }
  return tick.feelable() ? Fault::None : Fault::SceneRefused;
}

} // namespace

void Report::step(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  state.sceneAge_s = tick.s.shownAge_s;
  state.sceneShare = tick.s.shownShare;
  const bool underWay = tick.touchable() && tick.input.scene->shareAt(tick.s.sceneAge_s) < 1.0;
  state.motionLag_s = underWay ? tick.input.scene->motion_s() : 0.0;
  state.engage = tick.s.engage;
  state.gain = tick.s.gain;
  state.fault = faultOf(tick);
}

void Report::rest(TickContext& tick) noexcept
{
  step(tick);
}

} // namespace palpate::stage
