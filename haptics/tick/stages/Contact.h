// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/view/BallLead.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Takes the proxy along with its scene and towards the hand. A hand that is led to a plane touches the surface below
/// it there.
struct Contact
{
  static constexpr std::string_view name = "contact";

  struct Plan
  {
    ContactPlan contact;
    BallLead ballLead;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("radius_u", p.contact.radius_u...);
    visit("friction.statical", p.contact.friction.statical...);
    visit("friction.kinetic", p.contact.friction.kinetic...);
    visit("shading", p.contact.shading...);
    visit("seatsBySide", p.contact.seatsBySide...);
    visit("passCap", p.contact.passCap...);
    visit("workBudget", p.contact.workBudget...);
    visit("ballLead.number", p.ballLead.number...);
    visit("ballLead.geometry", p.ballLead.geometry...);
    visit("ballLead.from_W", p.ballLead.from_W...);
  }
  /// The tick must end.
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    constexpr std::uint32_t mostPasses = 1024, mostWork = 10000000;
    constexpr double mostFriction = 10.0;
    const ContactPlan& plan = p.contact;
    if (!nonNegative(plan.radius_u))
    {
      return "radius [scene units] must be a number that is not negative";
    }
    if (plan.passCap < 1 || plan.passCap > mostPasses || plan.workBudget < 1 || plan.workBudget > mostWork)
    {
      return "the work limit of a tick must be 1 to 1024 passes and 1 to 10000000 units of work";
    }
    if (!p.ballLead.from_W.allFinite())
    {
      return "the previous position of the proxy [scene units] must be finite";
    }
    return nonNegative(plan.friction.kinetic) && plan.friction.kinetic <= plan.friction.statical &&
               plan.friction.statical <= mostFriction
             ? ""
             : "friction: the kinetic coefficient must be a number from 0 to the static one, which is at most 10";
  }

  struct State
  {
    GodObjectState contact;
    WorkspaceMap map;          ///< of the last tick: one that puts the hand elsewhere places the proxy anew
    double radius_u = 0.0;     ///< of the last tick: another ball is seated where the old one was, once it fits there
    std::uint64_t ballLed = 0; ///< number of the lead that was followed last
    std::uint64_t sceneRevision = 0;
    std::uint64_t sceneGeometry = 0; ///< its surfaces, at any pose
    double sceneAge_s = 0.0;         ///< since the scene was taken: how far its surfaces have moved
    double shownAge_s = 0.0;         ///< since one of another revision was: snapshots of a soft body bring many of one
    double shownShare = 1.0;         ///< progress of the motion of all surfaces, 0..1
  };
  /// Touched features are no part of a recording: they are numbers of surfaces and triangles, which are not known yet.
  /// The age of visible data is reported, and has no effect on the force.
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("x_W", s.contact.x_W...);
    visit("placed", s.contact.placed...);
    visit("slips", s.contact.slips...);
    visit("device_W", s.contact.device_W...);
    visit("texture", s.contact.texture...);
    visit("map.scale_u_per_m", s.map.scale_u_per_m...);
    visit("map.q_WD", s.map.q_WD...);
    visit("map.offset_W", s.map.offset_W...);
    visit("radius_u", s.radius_u...);
    visit("ballLed", s.ballLed...);
    visit("sceneRevision", s.sceneRevision...);
    visit("sceneGeometry", s.sceneGeometry...);
    visit("sceneAge_s", s.sceneAge_s...);
  }

  static void step(TickContext& tick) noexcept;
  [[nodiscard]] static bool feels(const TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
