// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// In its own frame, with the base in the plane z = 0. Links: 1 .. 3 the arms, 4 .. 6 the forearms, 7 the platform.

/// The tip is the middle of the platform: the intersection of the forearms' spheres, and with hinges apart the result
/// of Newton steps from there.
[[nodiscard]] Posture postureOf(const DeltaGeometry& arm, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(
  const DeltaGeometry& arm, const JointVector& q, const Posture& posture, int link, const Vec3& at) noexcept;
/// The solution with the arms outwards.
[[nodiscard]] std::optional<JointVector> inverseOf(const DeltaGeometry& arm, const Vec3& p) noexcept;

} // namespace palpate
