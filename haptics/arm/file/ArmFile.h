// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/arm/ArmPlan.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// An arm as JSON text, "palpate arm", version 1: docs/arms.md has its keys. The text is not trusted: one sentence with
/// the place and the reason, and no arm, where something is missing, unknown or impossible. The object "wire", which
/// says how the arm is plugged in, is left to its reader.
[[nodiscard]] Outcome<ArmPlan> parseArm(const std::string& text);

/// The same for a file, with whose name the sentence begins.
[[nodiscard]] Outcome<ArmPlan> readArmFile(const std::string& file);

/// Arms whose files are built in (data/arms), by the names of these files: falcon, woodenhaptics-2015, polhem-v1,
/// aluhaptics-v2, pantograph, delta-wrist.
[[nodiscard]] const std::vector<std::string>& knownArms();
[[nodiscard]] Outcome<ArmPlan> knownArm(const std::string& name);

/// The text of that file. The problem is a phrase without the file's name.
[[nodiscard]] Outcome<std::string> armFileText(const std::string& file);
/// The text of the arm that is built in under that name, else of that file.
[[nodiscard]] Outcome<std::string> armText(const std::string& nameOrFile);

/// The arm that is built in under that name, else the arm of that file.
[[nodiscard]] Outcome<ArmPlan> armNamed(const std::string& nameOrFile);

} // namespace palpate
