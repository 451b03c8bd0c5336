// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"
#include "haptics/arm/PostureSearch.h"

namespace palpate
{

/// A chain of hinges, in its own frame. Link k (1 .. count) is behind hinge k, in the frame that turns with the hinge.

[[nodiscard]] Posture postureOf(const SerialGeometry& chain, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(
  const SerialGeometry& chain, const JointVector& q, int link, const Vec3& at) noexcept;

/// The length of the chain if it were stretched [m].
[[nodiscard]] double reachOf(const SerialGeometry& chain) noexcept;

/// Joints for a goal, from `near`: see PostureSearch.h.
[[nodiscard]] std::optional<JointVector> stepTo(
  const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) noexcept;

} // namespace palpate
