// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/arm/Arm.h"

namespace palpate
{

/// Inertia and gravity of an arm in joint coordinates. Real-time safe; zero where there is no posture.

/// Inertia of links and rotors [kg m2]. A rod is replaced by a sixth of its mass at each end and the rest in its
/// middle, which is exact (Simpson's rule for a polynomial of degree 2).
[[nodiscard]] JointMatrix inertiaOf(const Arm& arm, const JointVector& q) noexcept;

/// Torque of gravity on the joints: the negative gradient of the potential energy, so that its work on a closed path is
/// zero.
[[nodiscard]] JointVector gravityTorqueOf(const Arm& arm, const JointVector& q) noexcept;

/// Coriolis and centrifugal torque at these speeds of the joints [rad/s], as the inertia depends on the posture:
/// grad(q' M q') / 2 - M' q'. Derivatives of M by differences.
[[nodiscard]] JointVector velocityTorqueOf(const Arm& arm, const JointVector& q, const JointVector& rate) noexcept;

/// Torque of the motors for a command, with the arm where its encoders show it: gravity is compensated, the force on
/// the hand faded (Arm::forceFade), and the sum limited by the torque of every motor and rounded to whole steps.
[[nodiscard]] JointVector motorCommandOf(const Arm& arm, const JointVector& shown, const Wrench& wrench_D) noexcept;

} // namespace palpate
