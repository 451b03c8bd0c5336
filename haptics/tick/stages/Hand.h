// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "haptics/force/VelocityEstimator.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/safety/PositionWatch.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Where the hand is and how fast, and whether the dead-man switch is held. After a release there is no force, and the
/// force starts again from a small force.
struct Hand
{
  static constexpr std::string_view name = "hand";

  struct Plan
  {
    VelocityFilter velocity;
    WorkspaceMap map;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("velocity.method", p.velocity.method...);
    visit("velocity.resolution_m", p.velocity.resolution_m...);
    visit("velocity.lowPass_s", p.velocity.lowPass_s...);
    visit("velocity.window", p.velocity.window...);
    visit("map.scale_u_per_m", p.map.scale_u_per_m...);
    visit("map.q_WD", p.map.q_WD...);
    visit("map.offset_W", p.map.offset_W...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    const VelocityFilter& filter = p.velocity;
    if (!nonNegative(filter.resolution_m) || !nonNegative(filter.lowPass_s) || filter.window < 1 ||
        filter.window >= VelocityHistory::capacity || filter.method > VelocityMethod::AdaptiveWindow)
    {
      const std::string window = "1 to " + std::to_string(VelocityHistory::capacity - 1);
      return "velocity: resolution [m] and time constant [s] must not be negative, the window " + window + " ticks";
    }
    if (!nonNegative(p.map.scale_u_per_m) || p.map.scale_u_per_m == 0.0)
    {
      return "scale [scene units per metre] must be a number above zero";
    }
    return p.map.offset_W.allFinite() && std::fabs(p.map.q_WD.norm() - 1.0) < unitRounding
             ? ""
             : "the device's position in the scene must be finite and its rotation a unit quaternion";
  }

  struct State
  {
    PositionWatch watch;
    VelocityHistory velocity;
    Vec3 lastP_D = Vec3::Zero();     ///< where the hand was last tick [m]
    Quat lastQ_D = Quat::Identity(); ///< and how it was turned
    bool tracked = false;            ///< both are of the tick before
  };
  /// Positions of before are no part of a recording: it begins with a hand that comes from nowhere.
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("watch.same_s", s.watch.same_s...);
  }

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

/// Ends the force after an impossible motion of the hand, or an impossible energy of a contact.
struct HandGuard
{
  static constexpr std::string_view name = "hand guard";

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
