// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Stiffness of the coupling in this tick: the setting, limited by the device and the rate, and reduced
/// where the loop runs late, shared where a field holds the hand too.
struct Stiffness
{
  static constexpr std::string_view name = "stiffness";

  struct Plan
  {
    double stiffness_N_per_m = 1000.0;
    bool limitStiffness = true; ///< to the stable stiffness of device and rate (StabilityLimits)
    double stiffnessLimit_N_per_m = std::numeric_limits<double>::infinity(); ///< set by the session from the device
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("stiffness_N_per_m", p.stiffness_N_per_m...);
    visit("limitStiffness", p.limitStiffness...);
    visit("stiffnessLimit_N_per_m", p.stiffnessLimit_N_per_m...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return !nonNegative(p.stiffness_N_per_m)    ? "stiffness [N/m] must be a number that is not negative"
           : !(p.stiffnessLimit_N_per_m >= 0.0) ? "largest stiffness [N/m] must be a number that is not negative"
                                                : "";
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
