// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/labyrinth/LabyrinthGame.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// The game of a labyrinth before contact: whose hand is led to the start feels no wall on the way.
struct GameLead
{
  static constexpr std::string_view name = "game";

  struct Plan
  {
    GamePlan game; ///< leads the hand to the start of a labyrinth, and says that it is at the exit
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("on", p.game.on...);
    visit("start_W", p.game.start_W...);
    visit("exit_W", p.game.exit_W...);
    visit("exitReach_u", p.game.exitReach_u...);
    visit("lead_m_per_s", p.game.lead_m_per_s...);
    visit("stiffness_N_per_m", p.game.stiffness_N_per_m...);
    visit("damping_Ns_per_m", p.game.damping_Ns_per_m...);
    visit("largest_N", p.game.largest_N...);
    visit("near_m", p.game.near_m...);
    visit("fade_s", p.game.fade_s...);
    visit("shake_N", p.game.shake_N...);
    visit("shake_Hz", p.game.shake_Hz...);
    visit("shake_s", p.game.shake_s...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p) { return p.game.on ? palpate::refuse(p.game) : ""; }

  struct State
  {
    GameState game;
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("phase", s.game.phase...);
    visit("drawn_D", s.game.drawn_D...);
    visit("creeps", s.game.creeps...);
    visit("phase_s", s.game.phase_s...);
    visit("time_s", s.game.time_s...);
  }

  static void step(TickContext& tick) noexcept;
};

/// And after it: the lead's force in place of the walls', and the shaking at the exit. A device that holds the walls
/// shakes by itself, however slow its link is.
struct GameArrival
{
  static constexpr std::string_view name = "arrival";

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
