// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "haptics/force/Guide.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Leads the hand to a plane, only once force is given, so that who is far from the plane can ask for it.
struct Guide
{
  static constexpr std::string_view name = "guide";

  struct Plan
  {
    GuidePlan guide; ///< contact is computed in its plane while it is on
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("on", p.guide.on...);
    visit("point_W", p.guide.point_W...);
    visit("normal_W", p.guide.normal_W...);
    visit("stiffness_N_per_m", p.guide.stiffness_N_per_m...);
    visit("largest_N", p.guide.largest_N...);
    visit("ramp_s", p.guide.ramp_s...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    const GuidePlan& guide = p.guide;
    return guide.point_W.allFinite() && std::fabs(guide.normal_W.norm() - 1.0) < unitRounding &&
               nonNegative(guide.stiffness_N_per_m) && nonNegative(guide.largest_N) && nonNegative(guide.ramp_s)
             ? ""
             : "guide: the point must be finite, the normal a unit vector, stiffness [N/m], limit [N] and ramp [s] not "
               "negative";
  }

  struct State
  {
    double guideShare = 0.0; ///< of the guide that acts, 0..1
  };
  /// The guide was the first force beside contact: recordings know the sum of all such forces by its name.
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("guideShare", s.guideShare...);
    visit("lastGuide_D", s.besideContact_D...);
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
