// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "haptics/safety/SafetyLimits.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// The last word on the force and the torque that the hand gets.
struct Protect
{
  static constexpr std::string_view name = "safety";

  struct Plan
  {
    SafetyLimits safety;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("maxForce_N", p.safety.maxForce_N...);
    visit("maxRise_N_per_s", p.safety.maxRise_N_per_s...);
    visit("maxTorque_Nm", p.safety.maxTorque_Nm...);
    visit("maxTorqueRise_Nm_per_s", p.safety.maxTorqueRise_Nm_per_s...);
    visit("engageRamp_s", p.safety.engageRamp_s...);
    visit("engageBelow_N", p.safety.engageBelow_N...);
    visit("releaseRamp_s", p.safety.releaseRamp_s...);
    visit("faultRamp_s", p.safety.faultRamp_s...);
    visit("needsEngage", p.safety.needsEngage...);
    visit("deadMan.buttons", p.safety.deadMan.buttons...);
    visit("deadMan.grip", p.safety.deadMan.grip...);
    visit("hand.speed_m_per_s", p.safety.hand.speed_m_per_s...);
    visit("hand.excess_J", p.safety.hand.excess_J...);
    visit("frozenAbove_N", p.safety.frozenAbove_N...);
  }
  /// A limit may be infinite, never a number that lets everything pass unseen.
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    const SafetyLimits& s = p.safety;
    const auto limits = { s.maxForce_N, s.maxRise_N_per_s, s.maxTorque_Nm, s.maxTorqueRise_Nm_per_s, s.engageRamp_s,
      s.engageBelow_N, s.releaseRamp_s, s.faultRamp_s, s.hand.speed_m_per_s, s.hand.excess_J, s.frozenAbove_N };
    return std::all_of(limits.begin(), limits.end(), [](double limit) { return limit >= 0.0; })
             ? ""
             : "safety limits [N, N/s, N m, N m/s, s] must be numbers that are not negative";
  }

  struct State
  {
    Vec3 lastForce_D = Vec3::Zero();  ///< force on the hand in the last tick [N]
    bool ownForce = false;            ///< and that was the coupling's own force, unlimited
    Vec3 lastTorque_D = Vec3::Zero(); ///< [N m]
    double turned_J = 0.0;            ///< work of all torques so far
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("lastForce_D", s.lastForce_D...);
    visit("ownForce", s.ownForce...);
    visit("lastTorque_D", s.lastTorque_D...);
    visit("turned_J", s.turned_J...);
  }

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
