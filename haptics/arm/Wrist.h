// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

/// A chain of hinges that the last link of another kind carries: the first hinge stands in the frame of that link,
/// whose origin is the tip of that kind. The axes of the frame are, on
///   delta          the platform, those of the base, as a platform keeps its orientation;
///   woodenhaptics  the forearm, those of the base while the column is at 0 and the forearm hangs;
///   five-bar       the forearm of joint 1, x along it away from its elbow, z across the plane.

/// Gives the posture of a kind's tip the orientation of the link that carries the wrist.
void turnCarrier(const WoodenGeometry& arm, const JointVector& q, Posture& posture) noexcept;
void turnCarrier(const FiveBarGeometry& arm, const JointVector& q, Posture& posture) noexcept;

/// A point of the wrist, given in the frame of its carrier; the joints of the carrier come first.
[[nodiscard]] LinkPoint carried(const Posture& carrier, const LinkPoint& point) noexcept;
/// The tip of a wrist whose last joints are q's.
[[nodiscard]] Posture carried(const Posture& carrier, const SerialGeometry& wrist, const JointVector& q) noexcept;

/// The same hinges with all their axes through one point, for the rotation alone.
[[nodiscard]] SerialGeometry throughOnePoint(const SerialGeometry& wrist) noexcept;

} // namespace palpate
