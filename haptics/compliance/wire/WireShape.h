// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// How the end of a wire is bent at rest.
enum class WireTip
{
  Straight,
  Angled, ///< by 45 degrees where the tip begins
  Hook,   ///< evenly, by half a turn in all
  Helix,
};

/// A wire at rest.
struct WireShape
{
  double length_u = 0.0; ///< along the wire, its tip included
  int beams = 0;         ///< all of the same length along the wire
  WireTip tip = WireTip::Straight;
  double tip_u = 0.0;    ///< length of the bent end along the wire
  double radius_u = 0.0; ///< of a helix' centre line
  double pitch_u = 0.0;  ///< of a helix, for each turn

  friend bool operator==(const WireShape&, const WireShape&) = default;
};

/// Where the nodes of a wire at rest are: from the origin along x, its tip bent towards y.
[[nodiscard]] Outcome<std::vector<Vec3>> pointsOf(const WireShape& shape);

} // namespace palpate
