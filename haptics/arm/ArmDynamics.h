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

/// Potential energy [J]; 0 at the origin of D.
[[nodiscard]] double heightEnergyOf(const Arm& arm, const JointVector& q) noexcept;

} // namespace palpate
