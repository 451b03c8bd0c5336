// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// A chain of hinges, in its own frame. Links are 1 .. count: behind each hinge, in the frame that turns with it.

[[nodiscard]] Posture postureOf(const SerialGeometry& chain, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(
  const SerialGeometry& chain, const JointVector& q, int link, const Vec3& at) noexcept;

/// A goal for the tip; without a turn any will do.
struct ChainGoal
{
  Vec3 p = Vec3::Zero();
  std::optional<Quat> turn;
};

/// By damped least squares from `near` (Levenberg 1944), a bounded number of steps; nothing if it does not get there.
[[nodiscard]] std::optional<JointVector> stepTo(
  const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) noexcept;

} // namespace palpate
