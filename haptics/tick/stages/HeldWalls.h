// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/force/HeldWalls.h"
#include "haptics/tick/PlanRules.h"
#include "haptics/tick/StageList.h"
#include "haptics/tick/WallKeeper.h"

namespace palpate::stage
{

/// What a device closes at its own rate: the walls round the virtual location, or the spring that leads the hand to
/// the start of a labyrinth. The force on the hand is the device's business then.
struct HeldWalls
{
  static constexpr std::string_view name = "walls";

  struct Plan
  {
    HeldWallPlan walls; ///< for a plane world that lies across the device's z
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("hold", p.walls.hold...);
    visit("every_s", p.walls.every_s...);
    visit("step_m", p.walls.step_m...);
    visit("viscosity_Ns_per_m", p.walls.viscosity_Ns_per_m...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return nonNegative(p.walls.every_s) && nonNegative(p.walls.step_m) && nonNegative(p.walls.viscosity_Ns_per_m)
             ? ""
             : "held walls: period [s], step [m] and viscosity [N s/m] must be numbers that are not negative";
  }

  /// No part of a recording, which begins where nothing is held.
  struct State
  {
    HeldWallState walls;
  };

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
