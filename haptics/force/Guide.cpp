// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/Guide.h"

#include <algorithm>
#include <cmath>

namespace palpate
{

double rampedShare(double share, bool on, double ramp_s, double dt_s) noexcept
{
  const double step = ramp_s > 0.0 ? dt_s / ramp_s : 1.0;
  return on ? std::min(1.0, share + step) : std::max(0.0, share - step);
}

double guideForce(const GuidePlan& plan, double share, double height_m, double speed_m_per_s, double dt_s) noexcept
{
  const double way = height_m < 0.0 ? -1.0 : 1.0;
  const double stiffness_N_per_m = share * plan.stiffness_N_per_m;
  const double damping_Ns_per_m = stiffness_N_per_m * dt_s;
  const double back_N = stiffness_N_per_m * std::fabs(height_m) + way * damping_Ns_per_m * speed_m_per_s;
  return -way * std::clamp(back_N, 0.0, share * plan.largest_N);
}

} // namespace palpate
