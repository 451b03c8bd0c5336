// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceInfo.h"
#include "haptics/geometry/scene/SceneSimplifier.h"
#include "haptics/session/settings/AutoChoice.h"

namespace palpate
{

/// Whether simpler surfaces are searched, and the rules.
struct SimplifyPlan
{
  SimplifyRules rules;
  bool off = false;

  [[nodiscard]] bool operator==(const SimplifyPlan& other) const noexcept;
};

/// For a hand that moves so many scene units a metre with that device.
[[nodiscard]] SimplifyPlan simplifyPlan(AutoChoice choice, double scale_u_per_m, const DeviceInfo& device);

} // namespace palpate
