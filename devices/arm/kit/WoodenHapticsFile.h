// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "devices/arm/ArmSetup.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// The arm that an owner's ~/woodenhaptics.json describes, flat JSON with numbers in m, N m/A, counts and kg.
struct WoodenHapticsArm
{
  ArmSetup setup;
  std::array<double, 3> constants_Nm_per_A{}; ///< of the motors
};
/// The problem is a phrase without the file's name.
[[nodiscard]] Outcome<WoodenHapticsArm> readWoodenHapticsFile(const std::string& text);

} // namespace palpate
