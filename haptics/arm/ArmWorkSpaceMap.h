// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/arm/ArmMeasures.h"

namespace palpate
{

/// What an arm can do at one place.
struct ArmPlace
{
  Vec3 p_D = Vec3::Zero();
  bool reached = false;
  ArmMeasures measures; ///< if it is reached
};

/// Places on a grid of so many steps along the diameter of the work space, within it; without a work space none. Not
/// real-time safe.
[[nodiscard]] std::vector<ArmPlace> mapWorkSpace(const Arm& arm, int steps);

/// Least and most over the places that are reached with a condition that the plan allows.
struct ArmRange
{
  std::size_t places = 0, reached = 0, usable = 0; ///< usable: with force on the hand
  double leastCondition = 0.0, mostCondition = 0.0;
  double leastForce_N = 0.0, mostForce_N = 0.0; ///< in the worst direction of each place
  double leastMass_kg = 0.0, mostMass_kg = 0.0; ///< over all directions
  Vec3 best_D = Vec3::Zero();                   ///< where the condition is least
};

[[nodiscard]] ArmRange rangeOf(const Arm& arm, const std::vector<ArmPlace>& places);

/// Empty, or one sentence for a person about places of the work space that the arm does not reach, and those beyond its
/// largest condition, where there is no force.
[[nodiscard]] std::string noteOn(const Arm& arm, const ArmRange& range);

} // namespace palpate
