// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/force/VelocityEstimator.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"
#include "haptics/tool/servo/ToolBlend.h"
#include "haptics/tool/servo/ToolLead.h"

namespace palpate::stage
{

/// A tool in the hand in place of the ball: the pull of its newest contacts on the hand, as displacement and rotation.
/// Both go through the same spring, damper, meter and limits as the pull of the ball does.
struct Tool
{
  static constexpr std::string_view name = "tool";

  struct Plan
  {
    ToolCoupling toolCoupling = ToolCoupling::Constraints;
    double turnResolution_rad = 0.0; ///< step of the device's turns; set by the session from the device
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("coupling", p.toolCoupling...);
    visit("turnResolution_rad", p.turnResolution_rad...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return p.toolCoupling <= ToolCoupling::Virtual && nonNegative(p.turnResolution_rad)
             ? ""
             : "tool: the coupling must be constraints or virtual, and the resolution of rotations [rad] must not be "
               "negative";
  }

  struct State
  {
    ToolLead toolLead;
    ToolBlend toolBlend;
    ToolContacts toolSet;             ///< of the last tick: its stored energy is needed when another set arrives
    Pose toolHand_W;                  ///< where the hand had it last
    bool toolLoose = false;           ///< the clutch was held: the hand takes the tool anew
    Vec3 toolTurned_m = Vec3::Zero(); ///< sum of all turns of the hand times the lever
    VelocityHistory toolTurning;      ///< of that
    Vec3 toolTorque_D = Vec3::Zero(); ///< that the coupling asked for in the last tick [N m]
  };
  /// Like the features of the ball, the contacts of before are no part of a recording: the first tick has its own.
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("turn_W", s.toolLead.turn_W...);
    visit("grip", s.toolLead.grip...);
    visit("taken", s.toolLead.taken...);
    visit("blend.way_u", s.toolBlend.way_u...);
    visit("blend.turn_u", s.toolBlend.turn_u...);
    visit("hand_W", s.toolHand_W...);
    visit("loose", s.toolLoose...);
    visit("turned_m", s.toolTurned_m...);
    visit("torque_D", s.toolTorque_D...);
  }

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
  /// Rotational speed of the hand at the lever arm of the held body [m/s]. Once per tick.
  [[nodiscard]] static Vec3 turning_D(TickContext& tick, double lever_m) noexcept;
};

} // namespace palpate::stage
