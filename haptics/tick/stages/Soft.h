// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/compliance/servo/SoftEnergy.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Takes the newest snapshot of a soft body before contact. The force is continuous under the new one; the offset that
/// this needs fades.
struct SoftLead
{
  static constexpr std::string_view name = "soft";

  struct Plan
  {
    double softLate_s = 1.0;  ///< a body is not computed any more when its snapshot is older: no force
    bool softBalances = true; ///< a hand gets back no more energy than it gave to the body
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("late_s", p.softLate_s...);
    visit("balances", p.softBalances...);
  }
  /// Infinite is allowed: then any age is.
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return p.softLate_s > 0.0 ? "" : "soft: the age of a solution [s] that ends the force must be a number above 0";
  }

  struct State
  {
    SoftState soft;
    EnergyBalance softBalance;
    std::uint64_t softRevision = 0; ///< of the snapshot of the last tick; 0: none
    double softAge_s = 0.0;         ///< of the state at which it was made
    std::uint64_t softTick = 0;     ///< the last one on a body; 0: none
  };
  /// Like the features of the ball, the contacts of before are no part of a recording.
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("offset_W", s.soft.offset_W...);
    visit("taken_Nu", s.softBalance.taken_Nu...);
    visit("added_N", s.softBalance.added_N...);
    visit("revision", s.softRevision...);
    visit("age_s", s.softAge_s...);
    visit("tick", s.softTick...);
  }

  static void step(TickContext& tick) noexcept;
};

/// After contact: a hand gets back no more than it gave to the body, and a body that is not computed any more ends the
/// force.
struct Soft
{
  static constexpr std::string_view name = "soft energy";

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
