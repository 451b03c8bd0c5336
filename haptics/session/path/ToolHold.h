// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "haptics/session/settings/SettingStore.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate
{

/// How a hand holds a tool along a path.
struct ToolHold
{
  double stiffness_N_per_m; ///< of the spring from the hand to where the tool can be
  double scale_u_per_m;
  std::optional<double>
    characteristic_u; ///< lever arm [u] of the tool's turns; none: that of the tool about its handle
  ToolCoupling coupling;
  double friction; ///< of each contact (settledTarget())
};

[[nodiscard]] ToolHold toolHoldOf(const SettingStore& settings);

/// "", or why no tool can be held so, with settings by their names in braces.
[[nodiscard]] std::string refuseHold(const ToolHold& hold);

} // namespace palpate
