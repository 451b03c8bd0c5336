// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/session/LoopReport.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

/// A condition that needs attention without being a fault, and the remedy, for a person; empty if there is none. The
/// lateness is that of the report, the share of the stiffness that of the state.
[[nodiscard]] std::string warning(const HapticState& state, const LoopReport& report);

/// The message for a person who chose another device than the one that runs; empty if it is the same.
[[nodiscard]] std::string otherDeviceText(const std::string& running, const std::string& chosen);

} // namespace palpate
