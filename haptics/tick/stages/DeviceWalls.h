// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "haptics/force/DeviceWalls.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"
#include "haptics/tick/base/WallKeeper.h"

namespace palpate::stage
{

/// Rendered by the device at its own rate: the walls round the virtual location, or the spring that leads the hand to
/// the start of a labyrinth. The force on the hand is the device's business then.
struct DeviceWalls
{
  static constexpr std::string_view name = "walls";

  struct Plan
  {
    DeviceWallPlan walls; ///< for a plane world that lies across the device's z
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

  struct State
  {
    DeviceWallState walls;
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    constexpr std::array<const char*, AxisWalls::count> offsets{ "offset_m 0", "offset_m 1", "offset_m 2",
      "offset_m 3" };
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
      visit(offsets[i], s.walls.walls.offset_m[i]...);
    }
    visit("since_s", s.walls.since_s...);
    visit("stiffness_N_per_m", s.walls.stiffness_N_per_m...);
    visit("each_N", s.walls.each_N...);
  }

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
