// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "haptics/tick/StageList.h"

namespace palpate::stage
{

/// What is told of a tick whether it knows where the hand is or not.
struct Report
{
  static constexpr std::string_view name = "report";

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
