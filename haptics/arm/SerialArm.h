// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// A chain of hinges, in its own frame. Link k (1 .. count) is behind hinge k, in the frame that turns with the hinge.

[[nodiscard]] Posture postureOf(const SerialGeometry& chain, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(
  const SerialGeometry& chain, const JointVector& q, int link, const Vec3& at) noexcept;

/// A goal for the tip; without `turn` the orientation is free.
struct ChainGoal
{
  Vec3 p = Vec3::Zero();
  std::optional<Quat> turn;
};

/// Damped least squares from `near` (Levenberg 1944) in a bounded number of steps; nothing if the goal is not reached.
[[nodiscard]] std::optional<JointVector> stepTo(
  const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) noexcept;

} // namespace palpate
