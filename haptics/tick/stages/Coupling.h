// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/core/Types.h"
#include "haptics/force/PassivityController.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Spring and damper between hand and proxy, and the damping that keeps their held force passive.
struct Coupling
{
  static constexpr std::string_view name = "coupling";

  struct Plan
  {
    double damping_Ns_per_m = 0.0; ///< along the spring; the whole never pulls
    PassivityPlan passivity;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("damping_Ns_per_m", p.damping_Ns_per_m...);
    visit("passivity.enabled", p.passivity.enabled...);
    visit("passivity.delay_ticks", p.passivity.delay_ticks...);
    visit("passivity.reserve", p.passivity.reserve...);
    visit("passivity.repay", p.passivity.repay...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    constexpr double longestDelay_ticks = 16.0;
    if (!nonNegative(p.damping_Ns_per_m))
    {
      return "damping [N s/m] must be a number that is not negative";
    }
    return nonNegative(p.passivity.delay_ticks) && p.passivity.delay_ticks <= longestDelay_ticks &&
               nonNegative(p.passivity.reserve) && nonNegative(p.passivity.repay)
             ? ""
             : "passivity: delay [ticks, at most 16], reserve and repay [K T] must be numbers that are not negative";
  }

  struct State
  {
    EnergyMeter energy;
    Vec3 besideContact_D = Vec3::Zero(); ///< the part of the last tick's force that did not come from contact [N]
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("delivered_J", s.energy.delivered_J...);
    visit("absorbed_J", s.energy.absorbed_J...);
    visit("excess_J", s.energy.excess_J...);
    visit("peakExcess_J", s.energy.peakExcess_J...);
    visit("stiffness_N_per_m", s.energy.stiffness_N_per_m...);
    visit("touching", s.energy.touching...);
  }

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
