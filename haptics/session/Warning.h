// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/session/ServoLoop.h"
#include "haptics/tick/HapticState.h"

namespace palpate
{

/// What needs attention without being a fault, and what to do, for a person; empty if nothing. The lateness is the
/// report's, the share of the stiffness the state's.
[[nodiscard]] std::string warning(const HapticState& state, const LoopReport& report);

} // namespace palpate
