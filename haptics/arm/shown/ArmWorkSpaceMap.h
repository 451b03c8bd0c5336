// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/arm/ArmMeasures.h"

namespace palpate
{

/// Figures of an arm at one position of its tip.
struct ArmPlace
{
  Vec3 p_D = Vec3::Zero();
  bool reached = false;
  ArmMeasures measures; ///< if it is reached
};

/// Positions on a grid of `steps` steps along the diameter of the work space, within it; without a work space none. Not
/// real-time safe.
[[nodiscard]] std::vector<ArmPlace> mapWorkSpace(const Arm& arm, int steps);

/// Least and most over the positions that are reached with a condition number that the plan allows.
struct ArmRange
{
  std::size_t places = 0, reached = 0, usable = 0; ///< usable: with force on the hand
  double leastCondition = 0.0, mostCondition = 0.0;
  double leastManipulability = 0.0, mostManipulability = 0.0;
  double leastForce_N = 0.0, mostForce_N = 0.0; ///< in the worst direction at each position
  double leastMass_kg = 0.0, mostMass_kg = 0.0; ///< over all directions
  Vec3 best_D = Vec3::Zero();                   ///< position of the least condition number
};

[[nodiscard]] ArmRange rangeOf(const Arm& arm, const std::vector<ArmPlace>& places);

/// Empty, or one sentence for the user about positions of the work space that the arm does not reach, and those beyond
/// its largest condition number, where there is no force.
[[nodiscard]] std::string noteOn(const Arm& arm, const ArmRange& range);

} // namespace palpate
