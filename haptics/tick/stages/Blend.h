// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/core/Types.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// F = F_new + (F_old - F_new) decaying, and so the torque: a replaced scene, another map, a tool or a mechanism that
/// is taken, replaced or laid down, a constraint that is broken by hand, a body that becomes or ceases to be soft, a
/// hand that leaves or re-enters its known surroundings never steps (Mark et al. 1996). Not for the first scene, not
/// for surfaces that only move or bend, and not a safety limit.
struct Blend
{
  static constexpr std::string_view name = "blend";

  struct Plan
  {
    double sceneBlend_s = 0.03; ///< time constant in which a change of scene or map reaches the hand
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("sceneBlend_s", p.sceneBlend_s...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return nonNegative(p.sceneBlend_s) ? "" : "scene blend time [s] must be a number that is not negative";
  }

  struct State
  {
    Vec3 lastRendered_D = Vec3::Zero();       ///< the scene's force in the last tick [N]
    Vec3 blend_D = Vec3::Zero();              ///< the rest of the force of the previous scene [N]
    Vec3 lastRenderedTorque_D = Vec3::Zero(); ///< likewise the torque [N m]
    Vec3 blendTorque_D = Vec3::Zero();
    bool blendTool = false;           ///< a tool was in the hand that touches by its mesh
    double blendBall_u = 0.0;         ///< one was there that is felt as a ball of that radius; 0: none
    bool blendBody = false;           ///< a soft body was felt
    std::uint64_t blendMechanism = 0; ///< the one in the hand; 0: none
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("lastRendered_D", s.lastRendered_D...);
    visit("blend_D", s.blend_D...);
    visit("lastRenderedTorque_D", s.lastRenderedTorque_D...);
    visit("blendTorque_D", s.blendTorque_D...);
    visit("tool", s.blendTool...);
    visit("toolBall_u", s.blendBall_u...);
    visit("body", s.blendBody...);
    visit("mechanism", s.blendMechanism...);
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
