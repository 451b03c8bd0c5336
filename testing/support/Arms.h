// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/arm/ArmMeasures.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Arms of textbooks, with 10 N m at each joint.

/// Two links of 150 mm in a plane: rotors of 1e-4 kg m2, and the second motor, of 0.1 kg, at the elbow.
[[nodiscard]] ArmPlan twoLinks();
/// A five-bar of 150 mm links, 100 mm between its motors of 1e-4 kg m2.
[[nodiscard]] ArmPlan fiveBar();
/// A delta with base .1, platform .04, arms .15 and forearms .25 m, hanging.
[[nodiscard]] ArmPlan hangingDelta();
/// The chain of a stylus arm with six joints, all with motors.
[[nodiscard]] ArmPlan sixJoints();

/// Deltas, WoodenHaptics and a five-bar that carry hinges, with masses on all of them: through one point, and apart.
[[nodiscard]] std::vector<ArmPlan> armsWithWrists();

/// A place of the half plane above an arm's base, with the condition below `largestUsable`.
struct UsablePlace
{
  int x = 0, y = 0; ///< steps from the base
  ArmMeasures at;
};
inline constexpr double largestUsable = 5.0;
/// Of all places of a grid of `step_m`.
[[nodiscard]] std::vector<UsablePlace> usablePlaces(const Arm& arm, double step_m);

/// All of these and those that are built in.
[[nodiscard]] std::vector<ArmPlan> allArms();

/// Potential energy of its masses [J]; 0 at the origin of D.
[[nodiscard]] double heightEnergyOf(const Arm& arm, const JointVector& q);

/// Joints within the limits, or within half a turn, in which the arm has a posture with a condition below the largest.
[[nodiscard]] JointVector randomJoints(const Arm& arm, Random& random);

} // namespace palpate::test
