// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/arm/Arm.h"

namespace palpate
{

/// Masses of an arm at its joints. Real-time safe; zero where there is no posture.

/// Inertia of links and rotors [kg m2]. A rod counts as a sixth of its mass at each end and the rest in its middle,
/// which is exact (Simpson's rule for a polynomial of degree 2).
[[nodiscard]] JointMatrix inertiaOf(const Arm& arm, const JointVector& q) noexcept;

/// Torque of gravity on the joints: less the gradient of the potential energy, so that it takes no work on a closed
/// way.
[[nodiscard]] JointVector gravityTorqueOf(const Arm& arm, const JointVector& q) noexcept;

/// Torque that the speeds of the joints [rad/s] make by themselves, for the inertia is another in every posture:
/// grad(q' M q') / 2 - M' q'. Slopes of M by differences.
[[nodiscard]] JointVector velocityTorqueOf(const Arm& arm, const JointVector& q, const JointVector& rate) noexcept;

/// Torque of the motors that a command becomes, with the arm where its encoders show it: gravity is held, and the force
/// on the hand faded (Arm::forceFade), the whole cut to what every motor can give, in whole steps.
[[nodiscard]] JointVector motorCommandOf(const Arm& arm, const JointVector& shown, const Wrench& wrench_D) noexcept;

/// Potential energy [J]; 0 at the origin of D.
[[nodiscard]] double heightEnergyOf(const Arm& arm, const JointVector& q) noexcept;

} // namespace palpate
