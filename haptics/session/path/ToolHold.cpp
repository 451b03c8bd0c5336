// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/ToolHold.h"

#include <cmath>

#include "haptics/tool/servo/FrictionTarget.h"

namespace palpate
{

ToolHold toolHoldOf(const SettingStore& settings)
{
  const double stiffness_N_per_m = settings.number("Stiffness"), scale_u_per_m = settings.number("Scale");
  const double characteristic_u = settings.number("ToolLever"),
               turning_N_m_per_rad = settings.number("MechanismTurning");
  // K_r = K_t (L / scale)^2.
  const auto lever = turning_N_m_per_rad > 0.0
                       ? std::optional(scale_u_per_m * std::sqrt(turning_N_m_per_rad / stiffness_N_per_m))
                     : characteristic_u > 0.0 ? std::optional(characteristic_u)
                                              : std::nullopt;
  return { stiffness_N_per_m, scale_u_per_m, lever, static_cast<ToolCoupling>(settings.whole("ToolCoupling")),
    settings.number("FrictionKinetic") };
}

std::string refuseHold(const ToolHold& hold)
{
  const bool stiff = hold.stiffness_N_per_m > 0.0;
  const bool lever = hold.characteristic_u.value_or(1.0) > 0.0 && std::isfinite(hold.characteristic_u.value_or(1.0));
  return !stiff                                ? "{Stiffness}: that of a tool is above 0"
         : hold.friction > largestToolFriction ? "the friction of a tool must be a number from 0 to 1: where contacts "
                                                 "wedge, more has no one answer"
         : !lever                              ? "{ToolLever}: the lever of a tool must be a finite number above 0"
                                               : "";
}

} // namespace palpate
