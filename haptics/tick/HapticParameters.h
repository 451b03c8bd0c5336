// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/force/Guide.h"
#include "haptics/force/HeldWalls.h"
#include "haptics/force/PassivityController.h"
#include "haptics/force/VelocityEstimator.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/labyrinth/LabyrinthGame.h"
#include "haptics/safety/SafetyLimits.h"

namespace palpate
{

/// Everything a person or program sets. Written by one thread, read by the tick as a whole.
struct HapticParameters
{
  double stiffness_N_per_m = 1000.0;
  double damping_Ns_per_m = 0.0; ///< along the spring; the whole never pulls
  bool limitStiffness = true;    ///< to what the device and the rate can hold (StabilityLimits)
  double stiffnessLimit_N_per_m = std::numeric_limits<double>::infinity(); ///< set by the session from the device
  PassivityPlan passivity;
  VelocityFilter velocity;
  double sceneBlend_s = 0.03; ///< time constant in which a scene change reaches the hand
  ContactPlan contact;
  HeldWallPlan walls; ///< for a plane world that lies across the device's z
  GuidePlan guide;    ///< contact is computed in its plane while it is on
  GamePlan game;      ///< of a labyrinth: leads the hand to its start, and says that it is at the exit
  WorkspaceMap map;
  SafetyLimits safety;

  /// Empty, or one sentence that names the value that cannot be used.
  [[nodiscard]] std::string validate() const;
};

} // namespace palpate
