// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "haptics/field/proxy/FieldProxy.h"
#include "haptics/force/PassivityController.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/tick/base/PlanRules.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Force of the field around the hand, besides touched surfaces. Its springs and that of the contact
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
    visit("detent.bounds.gradient_per_u", p.field.detent.bounds.gradient_per_u...);
    visit("detent.bounds.bend_per_u2", p.field.detent.bounds.bend_per_u2...);
    visit("detent.click", p.field.detent.click...);
    visit("detent.levelCount", p.field.detent.levelCount...);
    visit("detent.levels", p.field.detent.levels...);
    visit("snap_N", p.field.snap_N...);
    visit("snapReach_u", p.field.snapReach_u...);
    visit("compare_N", p.field.compare_N...);
    visit("compareFull", p.field.compareFull...);
    visit("push_N", p.field.push_N...);
    visit("fullSpeed", p.field.fullSpeed...);
    visit("noSpeed", p.field.noSpeed...);
    visit("dragNone", p.field.dragNone...);
    visit("dragFull", p.field.dragFull...);
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
    if (!(f.detent.bounds.gradient_per_u >= 0.0) || !(f.detent.bounds.bend_per_u2 >= 0.0))
    {
      return "field: largest gradient and curvature of a scalar must be numbers that are not negative";
    }
    if (!std::isfinite(f.dragNone) || !std::isfinite(f.dragFull))
    {
      return "field: the resistances of zero and full drag must be finite";
    }
    if (!nonNegative(f.noSpeed) || (f.noSpeed > 0.0 && !(f.fullSpeed > f.noSpeed)))
    {
      return "field: the vector length of full force must be larger than that of zero force";
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
    std::uint64_t fieldBeyond = 0;     ///< ticks in which the hand was beyond the block
  };

  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("placed", s.field.placed...);
    visit("soft_W", s.field.soft_W...);
    visit("detent_W", s.field.detent_W...);
    visit("brick", s.field.brick...);
    visit("grid.size", s.field.grid.size...);
    visit("grid.spacing_u", s.field.grid.spacing_u...);
    visit("grid.pose_W", s.field.grid.pose_W...);
    isoFields(surfaceNames, visit, s.field.surface...);
    isoFields(clickNames, visit, s.field.click...);
    visit("map.scale_u_per_m", s.fieldMap.scale_u_per_m...);
    visit("map.q_WD", s.fieldMap.q_WD...);
    visit("map.offset_W", s.fieldMap.offset_W...);
    visit("delivered_J", s.fieldEnergy.delivered_J...);
    visit("absorbed_J", s.fieldEnergy.absorbed_J...);
    visit("excess_J", s.fieldEnergy.excess_J...);
    visit("peakExcess_J", s.fieldEnergy.peakExcess_J...);
    visit("stiffness_N_per_m", s.fieldEnergy.stiffness_N_per_m...);
    visit("touching", s.fieldEnergy.touching...);
    visit("spring_D", s.fieldSpring_D...);
    visit("force_D", s.fieldForce_D...);
    visit("fade_D", s.fieldFade_D...);
    visit("fade_s", s.fieldFade_s...);
    visit("beyond", s.fieldBeyond...);
  }

  static void step(TickContext& tick) noexcept;
  [[nodiscard]] static bool feels(const TickContext& tick) noexcept;
  static void rest(TickContext& tick) noexcept;

private:
  using IsoNames = std::array<const char*, 12>;
  static constexpr IsoNames surfaceNames{ "surface.placed", "surface.x.cell", "surface.x.t", "surface.device.cell",
    "surface.device.t", "surface.side", "surface.level", "surface.slips", "surface.catchingUp", "surface.stuck",
    "surface.cells", "surface.count" };
  static constexpr IsoNames clickNames{ "click.placed", "click.x.cell", "click.x.t", "click.device.cell",
    "click.device.t", "click.side", "click.level", "click.slips", "click.catchingUp", "click.stuck", "click.cells",
    "click.count" };

  template<class Visit, class... I>
  static void isoFields(const IsoNames& names, const Visit& visit, I&... iso)
  {
    const char* const* name = names.data();
    visit(*name++, iso.placed...);
    visit(*name++, iso.x.cell...);
    visit(*name++, iso.x.t...);
    visit(*name++, iso.device.cell...);
    visit(*name++, iso.device.t...);
    visit(*name++, iso.side...);
    visit(*name++, iso.level...);
    visit(*name++, iso.slips...);
    visit(*name++, iso.catchingUp...);
    visit(*name++, iso.stuck...);
    visit(*name++, iso.cells...);
    visit(*name++, iso.count...);
  }
};

} // namespace palpate::stage
