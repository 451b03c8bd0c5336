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

bool TickContext::feelable() const noexcept
{
  bool feels = false;
  const auto ask = [this, &feels]<class S>(std::type_identity<S>)
  {
    if constexpr (Feels<S>)
    {
      feels = feels || S::feels(*this);
    }
  };
  TickStages::forEach(ask);
  return feels;
}

TickOutput renderTick(
  const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink) noexcept
{
  TickOutput out;
  out.state.tick = input.tick;
  out.state.hand = out.command.hand = input.hand;
  out.state.time_s = input.sample.time_s;
  out.state.sceneRevision = input.scene != nullptr ? input.scene->revision() : 0;
  TickContext tick{ input, parameters, state, out, sink };
  TickStages::forEach([&tick]<class S>(std::type_identity<S>) { take<S>(tick); });
  return out;
}

} // namespace palpate
