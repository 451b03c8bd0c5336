// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/MassPart.h"

#include <cmath>

namespace palpate
{
namespace
{

PrincipalPart partOf(const DeviceModel& model)
{
  PrincipalPart part;
  part.count = model.planar ? 2 : 3;
  part.mass_kg.setConstant(model.mass_kg);
  part.damping_Ns_per_m.setConstant(model.damping_Ns_per_m);
  part.friction_N.setConstant(model.friction_N);
  return part;
}

} // namespace

MassPart::MassPart(const DeviceModel& model, const HandModel& hand, double period_s)
  : plant_(partOf(model), hand, period_s), travel_m_(model.travel_m), step_m_(model.encoderStep_m)
{
}

bool MassPart::begin(const Vec3& p_D, const Vec3& v_D) noexcept
{
  this->p_D_ = p_D;
  this->v_D_ = v_D;
  return true;
}

void MassPart::step(const Vec3& hand_N, const Wrench& motors_D) noexcept
{
  this->plant_.step(this->p_D_, this->v_D_, hand_N + motors_D.force);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::fabs(this->p_D_[axis]) > this->travel_m_)
    {
      this->p_D_[axis] = std::copysign(this->travel_m_, this->p_D_[axis]);
      this->v_D_[axis] = 0.0;
    }
  }
}

Vec3 MassPart::shown_D() const noexcept
{
  return this->step_m_ > 0.0 ? Vec3((this->p_D_ / this->step_m_).array().floor() * this->step_m_) : this->p_D_;
}

} // namespace palpate
