// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "haptics/field/FieldProxy.h"
#include "haptics/force/PassivityController.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/tick/PlanRules.h"
#include "haptics/tick/StageList.h"

namespace palpate::stage
{

/// What the numbers around the hand do to it, beside whatever surfaces are touched. Its springs and that of the contact
/// share the stiffness that device and rate can hold: their sum has a potential where each has, and is no stiffer than
/// one. Where a field ends its force fades.
struct Field
{
  static constexpr std::string_view name = "field";

  struct Plan
  {
    FieldPlan field;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("isosurface", p.field.isosurface...);
    visit("isovalue", p.field.isovalue...);
    visit("yield_N", p.field.yield_N...);
    visit("follow_N", p.field.follow_N...);
    visit("drag_N", p.field.drag_N...);
    visit("detent_N", p.field.detent.strength_N...);
    visit("detent.origin", p.field.detent.origin...);
    visit("detent.spacing", p.field.detent.spacing...);
    visit("detent.slope_per_u", p.field.detent.slope_per_u...);
    visit("detent.click", p.field.detent.click...);
    visit("detent.levelCount", p.field.detent.levelCount...);
    visit("detent.levels", p.field.detent.levels...);
    visit("snap_N", p.field.snap_N...);
    visit("snapReach_u", p.field.snapReach_u...);
    visit("compare_N", p.field.compare_N...);
    visit("compareFull", p.field.compareFull...);
    visit("push_N", p.field.push_N...);
    visit("fullSpeed", p.field.fullSpeed...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    const FieldPlan& f = p.field;
    if (!std::isfinite(f.isovalue) || !std::isfinite(f.detent.origin))
    {
      return "field: the value of the surface and of a level must be finite";
    }
    if (!(f.detent.spacing > 0.0 && std::isfinite(f.detent.spacing)) ||
        !(f.detent.slope_per_u > 0.0 && std::isfinite(f.detent.slope_per_u)) ||
        !(f.snapReach_u > 0.0 && std::isfinite(f.snapReach_u)))
    {
      return "field: distance of levels, usual gradient and reach of a snap must be larger than 0";
    }
    if (std::string problem = refuseLevels(f.detent); !problem.empty())
    {
      return "field: " + problem;
    }
    return nonNegative(f.yield_N) && nonNegative(f.follow_N) && nonNegative(f.drag_N) &&
               nonNegative(f.detent.strength_N) && nonNegative(f.snap_N) && nonNegative(f.compare_N) &&
               nonNegative(f.compareFull) && nonNegative(f.push_N) && f.push_N <= FieldPlan::mostPush_N &&
               nonNegative(f.fullSpeed)
             ? ""
             : "field: strengths [N] must be numbers that are not negative, and a push at most 0.5";
  }

  struct State
  {
    FieldState field;
    WorkspaceMap fieldMap; ///< of the last tick: with another one the hand is elsewhere
    EnergyMeter fieldEnergy;
    Vec3 fieldSpring_D = Vec3::Zero(); ///< force of the field's springs in the last tick [N]
    Vec3 fieldForce_D = Vec3::Zero();  ///< and of all of the field
    Vec3 fieldFade_D = Vec3::Zero();   ///< of the force that ended when the field did
    double fieldFade_s = 0.0;          ///< left until it is gone
    std::uint64_t fieldBeyond = 0;     ///< ticks in which the hand was beyond the brick
  };

  static void step(TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;
};

} // namespace palpate::stage
