// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/arm/Arm.h"

namespace palpate
{

/// Figures of an arm in a posture, for forces on the tip, along the directions in which the arm moves: 2 in a plane,
/// else 3.

/// Largest singular value of the Jacobian over the smallest; infinity in a singularity and without a posture.
[[nodiscard]] double conditionOf(const Arm& arm, const Posture& posture) noexcept;

/// Figures of a posture from motors and links alone.
struct ArmMeasures
{
  Vec3 singular = Vec3::Zero(); ///< values of the Jacobian, falling [m/rad]; the last is 0 in a plane
  double condition = 0.0;
  double manipulability = 0.0;                  ///< product of the singular values (Yoshikawa 1985)
  double leastForce_N = 0.0;                    ///< force of the motors in their worst direction
  double leastMass_kg = 0.0, mostMass_kg = 0.0; ///< apparent at the tip, in the lightest and the heaviest direction
};

/// Not real-time safe. All zero but the condition where there is no posture.
[[nodiscard]] ArmMeasures measure(const Arm& arm, const JointVector& q);

/// The largest force along a direction of length 1 that every motor can give [N].
[[nodiscard]] double largestForce(const Arm& arm, const Posture& posture, const Vec3& n_D) noexcept;

/// The largest displacement of the tip for one count of any encoder [m]; 0 where encoders tell angles.
[[nodiscard]] double countStepOf(const Arm& arm, const JointVector& q) noexcept;

} // namespace palpate
