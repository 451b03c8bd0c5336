// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/tick/Stages.h"

namespace palpate
{

/// Everything a person or program sets: the plans of all stages of the tick, whose members are its own. Written by one
/// thread, read by the tick as a whole.
struct HapticParameters : TickStages::Plans
{
  /// Empty, or one sentence that names the value that cannot be used.
  [[nodiscard]] std::string validate() const;
};

} // namespace palpate
