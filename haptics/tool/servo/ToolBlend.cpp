// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolBlend.h"

#include "haptics/core/Fade.h"

namespace palpate
{

Vec6 ToolBlend::blended(const Vec6& pull_u, const Vec6& step_u, double stiffness_N_per_u, double dt_s) noexcept
{
  const double step_N = stiffness_N_per_u * step_u.norm();
  const double later = step_N > largestStep_N ? 1.0 - largestStep_N / step_N : 0.0;
  const double left = Fade{ fade_s }.implicitShare(dt_s);
  this->way_u = left * this->way_u - later * step_u.head<3>();
  this->turn_u = left * this->turn_u - later * step_u.tail<3>();
  Vec6 rest_u;
  rest_u << this->way_u, this->turn_u;
  return pull_u + rest_u;
}

} // namespace palpate
