// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/compliance/wire/WireFactor.h"

namespace palpate
{

/// A place at a beam that is touched, between its nodes along the chord.
struct WireTouch
{
  static constexpr int most = 24;

  int beam = 0;
  double share = 0.0;             ///< of the second node
  Vec3 arm_W = Vec3::Zero();      ///< from the centre line to the place [u]
  Mat3 axes_W = Mat3::Identity(); ///< columns: the normal, on which a force above 0 presses the wire, and two tangents
};

/// Displacement of the place along its axes under a motion of the wire [u].
[[nodiscard]] Vec3 motionAt(const WireTouch& touch, const WireVector& motion) noexcept;

/// Adds a force at the place, along its axes [N], to the nodes: force and moment are kept.
void pressAt(const WireTouch& touch, const Vec3& force_N, WireVector& nodes) noexcept;

/// Adds the wire's compliance between touched places, in the order of their beams, at most WireTouch::most: three rows
/// each along their axes, by blocks of the inverse and transfers between them. To be called after WireFactor::invert().
/// Real-time safe.
void addWireCompliance(
  const WireFactor& factor, std::span<const WireTouch> touches, ContactProblem::Square& compliance) noexcept;

} // namespace palpate
