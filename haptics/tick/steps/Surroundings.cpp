// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Surroundings.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// The proxy or the tool's mesh: its place, and how far it reaches from there.
struct Toucher
{
  bool placed = false;
  Vec3 x_W = Vec3::Zero();
  double reach_u = 0.0;
};

Toucher toucherOf(const TickContext& tick) noexcept
{
  if (tick.touchesByMesh())
  {
    const ToolContacts& set = *tick.input.tool;
    return { set.placed, set.pose_W.p, set.reach_u };
  }
  return { tick.s.contact.placed, tick.s.contact.x_W, tick.contact.radius_u };
}

/// The proxy goes nowhere that is further from the hand than it is now, so nothing outside of this ball is met.
bool isBeyond(const TickContext& tick) noexcept
{
  const Vec3& hand_W = tick.out.state.device_W.p;
  const Toucher toucher = toucherOf(tick);
  const double pulled_u = toucher.placed ? (hand_W - toucher.x_W).norm() : 0.0;
  return !tick.p.known.has(hand_W, pulled_u + toucher.reach_u);
}

/// Names the scene that a server's part may be: a soft body is felt in a scene of its own, that of the bodies beside it
/// counts.
std::uint64_t geometryOf(const TickInput& input) noexcept
{
  return input.body != nullptr ? input.body->beside : input.scene->geometryHash();
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
    // A message about another scene is about one that is on its way.
    beyond = late || (of == geometryOf(tick.input) ? isBeyond(tick) : s.beyondKnown);
  }
  tick.knownChanged = beyond != s.beyondKnown;
  s.beyondKnown = beyond;
  s.beyondKnownTicks += beyond ? 1 : 0;
  tick.out.state.known = { beyond, beyond && late, s.beyondKnownTicks };
}

} // namespace palpate::stage
