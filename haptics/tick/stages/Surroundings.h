// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/contact/view/LoadedRegion.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Whether contact knows the surroundings of hand and proxy, where the scene is a part of a whole that is elsewhere.
/// Beyond that part, or while another has been asked for and does not come, nothing can be touched: the proxy waits
/// where all was known, and goes on from there in a part that has both places. Where it cannot it begins anew at the
/// hand.
struct Surroundings
{
  static constexpr std::string_view name = "surroundings";

  struct Plan
  {
    LoadedRegion known;
    double knownLate_s = 1.0; ///< a request without an answer for longer ends the force
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("geometry", p.known.geometry...);
    visit("continues", p.known.continues...);
    visit("centre_W", p.known.centre_W...);
    visit("reach_u", p.known.reach_u...);
    visit("asked", p.known.asked...);
    visit("late_s", p.knownLate_s...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    const bool usable = p.known.centre_W.allFinite() && nonNegative(p.known.reach_u) && nonNegative(p.knownLate_s);
    return usable ? ""
                  : "loaded region around the hand: centre, reach [scene units] and time limit of a request [s] must "
                    "be finite and not negative";
  }

  struct State
  {
    bool beyondKnown = false;
    std::uint64_t beyondKnownTicks = 0;
    std::uint64_t knownAsked = 0; ///< the request that is waited for
    double knownAskedFor_s = 0.0;
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("beyond", s.beyondKnown...);
    visit("beyondTicks", s.beyondKnownTicks...);
    visit("asked", s.knownAsked...);
    visit("askedFor_s", s.knownAskedFor_s...);
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
