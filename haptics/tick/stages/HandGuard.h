// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "haptics/tick/StageList.h"

namespace palpate::stage
{

/// Ends the force where the hand does what no hand does, or a contact gives what no wall gives.
struct HandGuard
{
  static constexpr std::string_view name = "hand guard";

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
