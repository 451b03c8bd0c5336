// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/mechanism/wire/WireTick.h"
#include "haptics/mechanism/wire/WireVessel.h"

namespace palpate
{

/// A wire between walls, as contacts were looked for.
struct WireAmongWalls
{
  const WirePlan& plan;
  const WirePlaces& places_M;
  const WireContacts& near;
  const WireReach& reach;
};

/// From a beam's first node to its second.
[[nodiscard]] inline Vec3 chordOf(const WirePlaces& places_M, int beam) noexcept
{
  return places_M[beam + 1].p - places_M[beam].p;
}

/// The share of a step with which no axis of a beam reaches the wall and no skin goes through a wall that was not
/// looked at. Real-time safe.
[[nodiscard]] double provenShare(const WireAmongWalls& wire, const WireVector& motion) noexcept;

/// Each force before goes on at the contact of its beam that is the nearest to it now: that of this contact, or none
/// [N], along the axes that it had. Real-time safe.
[[nodiscard]] Vec3 goesOn_N(
  std::span<const WireContact* const> contacts, int contact, std::span<const WirePress> before) noexcept;

} // namespace palpate
