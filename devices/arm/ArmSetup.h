// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "haptics/arm/ArmPlan.h"
#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// Properties of one kind of arm, beside its wire.
struct ArmSetup
{
  std::string what;                       ///< for a person: "Novint Falcon"
  std::string problem;                    ///< reason why such an arm cannot be used here, and the remedy; empty: it can
  std::optional<ArmPlan> plan;            ///< none: the wire knows the hand
  bool tellsAngles = false;               ///< the wire has degrees, not counts
  bool grips = false;                     ///< it can tell whether it is gripped
  bool turns = false;                     ///< it senses how the hand is turned
  DeviceQuantity radius_m{ 0.1, false };  ///< of the work space of a wire that knows the hand
  DeviceQuantity force_N{ 1.0, false };   ///< likewise: the largest
  std::string homing;                     ///< the sentence while it is not homed
  std::string pose;                       ///< in which its counters are set, as a sentence; empty: they are absolute
  std::array<std::int16_t, 6> counters{}; ///< in that pose, or degrees
  double poseTolerance = 300.0;           ///< a hand that holds the pose moves them by less
  int counterBits = 0;                    ///< of counters that wrap; 0: they do not
  double period_s = 1e-3;                 ///< from request to request, at least
  Pacing pacing = Pacing::Device;
};

} // namespace palpate
