// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/tick/base/HapticState.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"
#include "haptics/tool/servo/ToolLead.h"

namespace palpate
{

/// Initial state of a constraint in a recording.
template<class Visit, class Constraint>
void membersOf(
  const Visit& visit, Constraint& law) requires std::is_same_v<std::remove_const_t<Constraint>, ConstraintState>
{
  visit(law.phase);
  visit(law.met);
  visit(law.seen);
  visit(law.waits);
  visit(law.placed);
  visit(law.place_A);
  visit(law.place_B);
  visit(law.normal_W);
  visit(law.stuck_u);
  visit(law.force_W);
  visit(law.offset_W);
  visit(law.apart_W);
}

template<class Visit, class Event>
void membersOf(const Visit& visit, Event& event) requires std::is_same_v<std::remove_const_t<Event>, MechanismEvent>
{
  visit(event.tick);
  visit(event.change);
  visit(event.law);
  visit(event.force_N);
}

template<class Visit, class Press>
void membersOf(const Visit& visit, Press& press) requires std::is_same_v<std::remove_const_t<Press>, WirePress>
{
  visit(press.beam);
  visit(press.at_M);
  visit(press.axes_N);
  visit(press.force_M);
}

template<class Visit, class Wire>
void membersOf(const Visit& visit, Wire& wire) requires std::is_same_v<std::remove_const_t<Wire>, WireState>
{
  visit(wire.revision);
  visit(wire.placed);
  visit(wire.places_M);
  visit(wire.grip_u);
  visit(wire.led_u);
  visit(wire.hand_W);
  visit(wire.handTurn_rad);
  visit(wire.turned_rad);
  visit(wire.pressCount);
  visit(wire.presses);
}

namespace stage
{

/// A mechanism in the hand in place of ball and tool: the pull of its constraints on the hand, as displacement and
/// rotation. Both go through the same spring, damper, meter and limits as the pull of the ball does.
struct HeldMechanism
{
  static constexpr std::string_view name = "mechanism";

  struct Plan
  {
    /// Rotational stiffness between hand and held body; 0: free rotation, as always where the device has no
    /// torque. A softer spring of the hand makes this one softer by as much.
    double mechanismTurning_N_m_per_rad = 0.0;
    /// Turn of a wire about its sheath in addition to the hand's, reached at no more than a turn in a second.
    double wireTurn_deg = 0.0;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("turning_N_m_per_rad", p.mechanismTurning_N_m_per_rad...);
    visit("wireTurn_deg", p.wireTurn_deg...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return !nonNegative(p.mechanismTurning_N_m_per_rad)
             ? "mechanism: the rotational stiffness [N m/rad] must be a number that is not negative"
           : std::isfinite(p.wireTurn_deg) ? ""
                                           : "mechanism: the turn of a wire [degrees] must be a finite number";
  }

  struct State
  {
    MechanismState mechanism;
    ToolLead mechanismLead;
    bool mechanismLoose = false;     ///< the clutch was held: the hand takes it anew
    std::uint64_t mechanismTick = 0; ///< the last one with a mechanism; 0: none
    ConstraintChanges mechanismChanges;
    double wireTurned_rad = 0.0; ///< of wireTurn_deg, so far
    MechanismHand mechanismHand; ///< for the worker
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("revision", s.mechanism.revision...);
    visit("packets", s.mechanism.snapshot...);
    visit("poses_W", s.mechanism.pose_W...);
    visit("motions", s.mechanism.loose...);
    visit("laws", s.mechanism.laws...);
    visit("found", s.mechanism.found...);
    visit("led.hand_W", s.mechanism.led.hand_W...);
    visit("led.lead_W", s.mechanism.led.lead_W...);
    visit("push_N", s.mechanism.push_N...);
    visit("turning_N", s.mechanism.turning_N...);
    visit("capped", s.mechanism.capped...);
    visit("placed", s.mechanism.placed...);
    visit("tip_W", s.mechanism.tip_W...);
    visit("soft.given_Nu", s.mechanism.soft.given_Nu...);
    visit("soft.held_Nu", s.mechanism.soft.held_Nu...);
    visit("blend.way_u", s.mechanism.blend.way_u...);
    visit("blend.turn_u", s.mechanism.blend.turn_u...);
    visit("turn_W", s.mechanismLead.turn_W...);
    visit("grip", s.mechanismLead.grip...);
    visit("taken", s.mechanismLead.taken...);
    visit("loose", s.mechanismLoose...);
    visit("tick", s.mechanismTick...);
    visit("changes.plan", s.mechanismChanges.plan...);
    visit("changes.count", s.mechanismChanges.count...);
    visit("changes.newest", s.mechanismChanges.newest...);
    visit("wire", s.mechanism.wire...);
    visit("wireTurned_rad", s.wireTurned_rad...);
  }

  static void step(TickContext& tick) noexcept;
  [[nodiscard]] static bool feels(const TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace stage

/// The lever by which a turn counts as a displacement, where the hand turns a mechanism with that stiffness and moves
/// it with this one [m]; 0: it turns freely.
[[nodiscard]] inline double mechanismLever_m(double turning_N_m_per_rad, double stiffness_N_per_m) noexcept
{
  return stiffness_N_per_m > 0.0 ? std::sqrt(turning_N_m_per_rad / stiffness_N_per_m) : 0.0;
}

} // namespace palpate
