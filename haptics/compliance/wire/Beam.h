// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/wire/WireBlocks.h"

namespace palpate
{

/// Energy of a beam with its derivatives by small motions of its nodes: along the world's axes [u], and about them
/// [rad].
struct BeamAnswer
{
  double energy_Nu = 0.0;
  double tension_N = 0.0;
  double twist_rad = 0.0;
  std::array<NodeVector, 2> gradient; ///< the forces and moments that hold it so
  /// Second derivatives along exp(turn) times each orientation: symmetric, also out of balance.
  NodeBlock firstFirst, firstSecond, secondSecond;
};

/// The co-rotational beam of docs/theory.md, "A wire". A rigid motion of a beam costs no energy.
/// Each end is bent by less than a right angle against the chord; both are twisted by less than a half turn.
/// Real-time safe; the bits are the same on every machine.
void bendBeam(const WireBeam& beam, const Pose& first_W, const Pose& second_W, BeamAnswer& answer) noexcept;

} // namespace palpate
