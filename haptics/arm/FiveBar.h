// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// In its own plane, between the joints of the base. Links: 1, 2 the arms, 3, 4 their forearms.

[[nodiscard]] Posture postureOf(const FiveBarGeometry& arm, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(
  const FiveBarGeometry& arm, const JointVector& q, const Posture& posture, int link, const Vec3& at) noexcept;
[[nodiscard]] std::optional<JointVector> inverseOf(const FiveBarGeometry& arm, const Vec3& p) noexcept;

} // namespace palpate
