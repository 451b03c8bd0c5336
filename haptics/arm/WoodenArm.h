// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// In its own frame, with z upwards from the foot of the column. Links: 1 upper, 2 fore.

[[nodiscard]] Posture postureOf(const WoodenGeometry& arm, const JointVector& q) noexcept;
[[nodiscard]] LinkPoint linkPointOf(const WoodenGeometry& arm, const JointVector& q, int link, const Vec3& at) noexcept;
/// The solution with the elbow above the line from shoulder to tip.
[[nodiscard]] std::optional<JointVector> inverseOf(const WoodenGeometry& arm, const Vec3& p) noexcept;

} // namespace palpate
