// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/FrictionPlant.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

constexpr double longestPart_s = 1e-3;
constexpr int levels = 20; // halvings of a part
/// Reversals in one part: an exact motion has at most two, and each ends at rest or in motion.
constexpr int mostReversals = 8;

} // namespace

FrictionPlant::FrictionPlant(
  double mass_kg, double damping_Ns_per_m, double stiffness_N_per_m, double friction_N, double period_s)
  : stiffness_N_per_m_(stiffness_N_per_m), friction_N_(friction_N),
    parts_(std::max(1, static_cast<int>(std::ceil(period_s / longestPart_s * (1.0 - 1e-9))))),
    whole_(mass_kg, damping_Ns_per_m, stiffness_N_per_m, period_s)
{
  for (int level = 0; level <= levels && friction_N > 0.0; ++level)
  {
    this->halvings_[static_cast<std::size_t>(level)] = LinearPlant(
      mass_kg, damping_Ns_per_m, stiffness_N_per_m, period_s / this->parts_ / static_cast<double>(1 << level));
  }
}

FrictionPlant::State FrictionPlant::after(const LinearPlant& plant, const State& s, double u_N) noexcept
{
  return { plant.free()(0, 0) * s.x_m + plant.free()(0, 1) * s.v_m_per_s + plant.held()(0) * u_N,
    plant.free()(1, 0) * s.x_m + plant.free()(1, 1) * s.v_m_per_s + plant.held()(1) * u_N };
}

void FrictionPlant::step(State& s, double u_N) const noexcept
{
  if (this->friction_N_ == 0.0)
  {
    s = after(this->whole_, s, u_N);
    return;
  }
  for (int part = 0; part < this->parts_; ++part)
  {
    this->stepPart(s, u_N);
  }
}

bool FrictionPlant::slide(State& s, double u_N, double way, long& left) const noexcept
{
  for (int level = 0; level <= levels && left > 0; ++level)
  {
    const long units = 1L << (levels - level);
    if (units > left)
    {
      continue;
    }
    const State next = after(this->halvings_[static_cast<std::size_t>(level)], s, u_N - way * this->friction_N_);
    if (next.v_m_per_s * way > 0.0)
    {
      s = next;
      left -= units;
    }
  }
  return left == 0;
}

void FrictionPlant::stepPart(State& s, double u_N) const noexcept
{
  long left = 1L << levels; // in units of the shortest step
  for (int reversal = 0; reversal < mostReversals && left > 0; ++reversal)
  {
    if (s.v_m_per_s == 0.0)
    {
      const double pull = u_N - this->stiffness_N_per_m_ * s.x_m;
      if (std::fabs(pull) <= this->friction_N_)
      {
        return; // sticks: nothing changes any more
      }
      // The first shortest step out of rest goes in the direction of the pull.
      s = after(this->halvings_.back(), s, u_N - std::copysign(this->friction_N_, pull));
      --left;
    }
    if (s.v_m_per_s != 0.0 && !this->slide(s, u_N, std::copysign(1.0, s.v_m_per_s), left))
    {
      s.v_m_per_s = 0.0;
    }
  }
}

} // namespace palpate
