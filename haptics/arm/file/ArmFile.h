// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/arm/ArmPlan.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// An arm as JSON text, "palpate arm", version 1: docs/arms.md has its keys. The text is not trusted: one sentence with
/// the place and the reason, and no arm, where something is missing, unknown or impossible.
[[nodiscard]] Outcome<ArmPlan> parseArm(const std::string& text);

/// The same for a file, with whose name the sentence begins.
[[nodiscard]] Outcome<ArmPlan> readArmFile(const std::string& file);

/// Arms whose files are built in (data/arms), by the names of these files: falcon, woodenhaptics-2015, polhem-v1,
/// aluhaptics-v2, pantograph, delta-wrist.
[[nodiscard]] const std::vector<std::string>& knownArms();
[[nodiscard]] Outcome<ArmPlan> knownArm(const std::string& name);

/// The arm that is built in under that name, else the arm of that file.
[[nodiscard]] Outcome<ArmPlan> armNamed(const std::string& nameOrFile);

} // namespace palpate
