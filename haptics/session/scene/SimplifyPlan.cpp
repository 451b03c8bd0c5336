// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/SimplifyPlan.h"

namespace palpate
{

bool SimplifyPlan::operator==(const SimplifyPlan& other) const noexcept
{
  const TouchConditions &mine = this->rules.touch, &others = other.rules.touch;
  return mine.scale_u_per_m == others.scale_u_per_m && mine.resolution_m == others.resolution_m &&
         this->rules.leastTriangles == other.rules.leastTriangles && this->rules.leastFine == other.rules.leastFine &&
         this->off == other.off;
}

SimplifyPlan simplifyPlan(AutoChoice choice, double scale_u_per_m, const DeviceInfo& device)
{
  SimplifyPlan plan;
  plan.rules.touch.scale_u_per_m = scale_u_per_m;
  plan.rules.touch.resolution_m = device.resolution_m.value;
  plan.off = choice == AutoChoice::Off;
  if (choice == AutoChoice::On)
  {
    plan.rules.leastTriangles = plan.rules.leastFine = 0;
  }
  return plan;
}

} // namespace palpate
