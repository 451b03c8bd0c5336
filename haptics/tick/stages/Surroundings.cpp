// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Surroundings.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// The proxy goes nowhere that is further from the hand than it is now, so nothing outside of this ball is met.
bool isBeyond(const TickContext& tick) noexcept
{
  const KnownPart& known = tick.p.known;
  const Vec3& hand_W = tick.out.state.device_W.p;
  const GodObjectState& contact = tick.s.contact;
  const double pulled_u = contact.placed ? (hand_W - contact.x_W).norm() : 0.0;
  return !((hand_W - known.centre_W).norm() + pulled_u + tick.contact.radius_u <= known.reach_u);
}

bool isLate(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const std::uint64_t asked = tick.p.known.asked;
  s.knownAskedFor_s = asked != 0 && asked == s.knownAsked ? s.knownAskedFor_s + tick.input.dt_s : 0.0;
  s.knownAsked = asked;
  return s.knownAskedFor_s > tick.p.knownLate_s;
}

} // namespace

void Surroundings::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const Scene* const scene = tick.input.scene;
  const std::uint64_t of = tick.p.known.geometry;
  const bool late = isLate(tick);
  bool beyond = false;
  if (of != 0 && scene != nullptr)
  {
    // What is said of another scene is of one that is on its way.
    beyond = late || (of == scene->geometryHash() ? isBeyond(tick) : s.beyondKnown);
  }
  tick.knownChanged = beyond != s.beyondKnown;
  s.beyondKnown = beyond;
  s.beyondKnownTicks += beyond ? 1 : 0;
  tick.out.state.known = { beyond, beyond && late, s.beyondKnownTicks };
}

} // namespace palpate::stage
