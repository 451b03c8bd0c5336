// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/ForceRenderer.h"

#include "haptics/tick/TickContext.h"

namespace palpate
{
namespace
{

template<class S>
void take(TickContext& tick) noexcept
{
  if (!tick.out.state.held)
  {
    S::step(tick);
  }
  else if constexpr (Rests<S>)
  {
    S::rest(tick);
  }
}

} // namespace

TickOutput renderTick(
  const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink) noexcept
{
  TickContext tick{ input, parameters, state, sink };
  tick.out.state.tick = input.tick;
  tick.out.state.hand = tick.out.command.hand = input.hand;
  tick.out.state.time_s = input.sample.time_s;
  tick.out.state.sceneRevision = input.scene != nullptr ? input.scene->revision() : 0;
  TickStages::forEach([&tick]<class S>(std::type_identity<S>) { take<S>(tick); });
  return tick.out;
}

} // namespace palpate
