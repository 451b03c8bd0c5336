// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/PrincipalPlant.h"

#include <cstddef>

namespace palpate
{

PrincipalPlant::PrincipalPlant(const PrincipalPart& part, const HandModel& hand, double period_s) : part_(part)
{
  for (int i = 0; i < part.count; ++i)
  {
    this->axes_[static_cast<std::size_t>(i)] = FrictionPlant(part.mass_kg[i] + hand.mass_kg,
      part.damping_Ns_per_m[i] + hand.damping_Ns_per_m, hand.stiffness_N_per_m, part.friction_N[i], period_s);
  }
}

void PrincipalPlant::step(Vec3& p_D, Vec3& v_D, const Vec3& force_N) const noexcept
{
  const Mat3& U = this->part_.directions_D;
  Vec3 y = U.transpose() * p_D, w = U.transpose() * v_D;
  const Vec3 beside_D = p_D - U * y; // rounding, which a part along the axes does not have
  const Vec3 u_N = U.transpose() * force_N - this->part_.dampingAcross * w;
  for (int i = 0; i < 3; ++i)
  {
    FrictionPlant::State state{ y[i], i < this->part_.count ? w[i] : 0.0 };
    if (i < this->part_.count)
    {
      this->axes_[static_cast<std::size_t>(i)].step(state, u_N[i]);
    }
    y[i] = state.x_m;
    w[i] = state.v_m_per_s;
  }
  p_D = beside_D + U * y;
  v_D = U * w;
}

} // namespace palpate
