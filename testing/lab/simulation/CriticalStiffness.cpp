// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/CriticalStiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::lab
{
namespace
{

/// How long to watch: cycles of the mass on the wall's spring, and no less than slow growth needs.
struct Watch
{
  int settle = 0; ///< ticks before the first stretch
  int stretch = 0;
  int between = 0;
};

Watch watchFor(double mass_kg, const WallSetup& setup)
{
  const double cycle_s = 2 * std::numbers::pi * std::sqrt(mass_kg / setup.parameters.stiffness_N_per_m);
  const double stretch_s = std::max(10 * cycle_s, 0.5);
  const auto ticks = [&setup](double time_s) { return static_cast<int>(std::ceil(time_s / setup.period_s)); };
  return { ticks(std::max(5 * cycle_s, 0.1)), ticks(stretch_s), ticks(stretch_s) };
}

} // namespace

bool grows(const FreeDevice& pressed, const WallSetup& setup)
{
  const double K = setup.parameters.stiffness_N_per_m;
  const double rest_m = -pressed.push_N / K;
  FreeDevice start = pressed;
  start.z_m = 0.99 * rest_m;
  start.speed_m_per_s = 0.0;
  const auto device = makeFree(start, setup.period_s);
  WallRig rig(*device, setup);
  const Watch watch = watchFor(pressed.model.mass_kg, setup);
  const int last = watch.settle + 2 * watch.stretch + watch.between;
  double early = 0.0, late = 0.0, before_m = start.z_m;
  for (int tick = 0; tick < last; ++tick)
  {
    const double z_m = rig.tick().device_W.p.z();
    const double off_m = z_m - rest_m, speed = (z_m - before_m) / setup.period_s;
    before_m = z_m;
    if (!(std::abs(off_m) < std::abs(rest_m)))
    {
      return true; // out of the wall, or as deep again
    }
    const double energy = K * off_m * off_m + pressed.model.mass_kg * speed * speed;
    if (tick >= watch.settle && tick < watch.settle + watch.stretch)
    {
      early += energy;
    }
    else if (tick >= last - watch.stretch)
    {
      late += energy;
    }
  }
  // A motion that has died to rounding does not grow.
  const double rounding = 1e-16 * watch.stretch * K * rest_m * rest_m;
  return late > early && late > rounding;
}

double measuredCriticalStiffness(
  const FreeDevice& pressed, const std::function<WallSetup(double stiffness_N_per_m)>& setup, double most_N_per_m)
{
  double low = 1.0, high = low;
  while (!grows(pressed, setup(high)))
  {
    low = high;
    high *= 2.0;
    if (high > most_N_per_m)
    {
      return most_N_per_m;
    }
  }
  if (high == 1.0)
  {
    return 0.0;
  }
  while (high / low > 1.0005)
  {
    const double middle = std::sqrt(low * high);
    (grows(pressed, setup(middle)) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

} // namespace palpate::lab
