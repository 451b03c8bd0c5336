// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/PassivityController.h"

#include <algorithm>

namespace palpate
{

void measureEnergy(const SpringTick& tick, EnergyMeter& meter) noexcept
{
  meter.delivered_J += tick.work_J;
  const bool continues = meter.touching && !tick.restart && meter.stiffness_N_per_m == tick.stiffness_N_per_m;
  const double held_J = 0.5 * tick.stiffness_N_per_m * tick.stretch_m * tick.stretch_m;
  const bool begins = !meter.touching && !tick.restart;
  meter.absorbed_J = begins ? 0.0 : continues ? meter.absorbed_J - tick.work_J : held_J;
  meter.touching = tick.stretch_m > 0.0;
  meter.stiffness_N_per_m = tick.stiffness_N_per_m;
  if (!meter.touching)
  {
    meter.absorbed_J = meter.excess_J = 0.0;
    return;
  }
  meter.absorbed_J = std::min(meter.absorbed_J, held_J);
  meter.excess_J = held_J - meter.absorbed_J;
  meter.peakExcess_J = std::max(meter.peakExcess_J, meter.excess_J);
}

double stabilisingDamping(const PassivityPlan& plan, const SpringTick& tick, const EnergyMeter& meter) noexcept
{
  if (!plan.enabled || !meter.touching)
  {
    return 0.0;
  }
  const double unit = tick.stiffness_N_per_m * tick.dt_s;
  const double ahead = (0.5 + plan.delay_ticks + plan.reserve) * unit;
  const double speed2 = tick.inward_m_per_s * tick.inward_m_per_s;
  const double most = plan.repay * unit;
  // Compared by a product: near v = 0 the quotient has no bound.
  const bool bounded = meter.excess_J < most * speed2 * tick.dt_s;
  return ahead + (bounded ? meter.excess_J / (speed2 * tick.dt_s) : most);
}

} // namespace palpate
