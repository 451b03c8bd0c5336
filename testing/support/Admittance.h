// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "devices/simulated/AdmittanceDevice.h"

namespace palpate::test
{

/// The command of a host without anything to touch: to go where the virtual mass is.
[[nodiscard]] inline DeviceCommand inAir(const DeviceSample& sample)
{
  DeviceCommand command;
  command.target.pose_D = sample.pose_D;
  return command;
}

/// Runs `ticks` in air, and calls look(tick) after each.
template<class Look>
void runInAir(HapticDevice& device, int ticks, double period_s, const Look& look)
{
  DeviceSample sample;
  for (int tick = 0; tick < ticks; ++tick)
  {
    static_cast<void>(device.read(tick * period_s, sample));
    device.write(inAir(sample));
    look(tick);
  }
}

/// Along x by 1 mm, then still.
[[nodiscard]] inline HandPath nudge()
{
  HandPath path;
  path.points_D = { Vec3::Zero(), Vec3(1e-3, 0.0, 0.0) };
  path.loops = false;
  return path;
}

/// Does a hand that is a spring alone make the device shake? Over 8 s, of which the second eighth and the last are
/// compared.
[[nodiscard]] inline bool shakes(const AdmittancePlan& plan, double stiffness_N_per_m)
{
  AdmittanceDevice device(plan, HandModel{ "spring", stiffness_N_per_m, 0.0, 0.0 }, nudge());
  if (!device.open().empty())
  {
    return true;
  }
  const int ticks = static_cast<int>(8.0 / plan.period_s), window = ticks / 8;
  double early = 0.0, late = 0.0;
  runInAir(device, ticks, plan.period_s,
    [&](int tick)
    {
      const double away = std::fabs(device.handle_D().x() - 1e-3);
      early = tick >= window && tick < 2 * window ? std::max(early, away) : early;
      late = tick >= ticks - window ? std::max(late, away) : late;
    });
  return late > early;
}

/// The stiffest such hand that it holds, by halving between half and twice a guess.
[[nodiscard]] inline double stiffestHoldFound(const AdmittancePlan& plan, double guess_N_per_m)
{
  double low = 0.5 * guess_N_per_m, high = 2.0 * guess_N_per_m;
  for (int halving = 0; halving < 12; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (shakes(plan, middle) ? high : low) = middle;
  }
  return low;
}

} // namespace palpate::test
