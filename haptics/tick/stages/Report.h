// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Report of a tick with or without hand position.
struct Report
{
  static constexpr std::string_view name = "report";

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
