// SPDX-License-Identifier: GPL-3.0-or-later
// Row 3: energy from a held spring to a hand that presses and lets go at constant speed.
#include <algorithm>
#include <cmath>
#include <string>

#include "devices/FedDevice.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{
namespace energy_leak_experiment
{

struct Press
{
  double speed_m_per_s, depth_m, period_s;
};

struct Energies
{
  double meter_J = 0.0;    ///< the product's: force of the last period times the displacement in it
  double textbook_J = 0.0; ///< force of now times speed of now times the period
};

/// From the surface to the depth and back to the surface, sampled at a phase in 0..1 of the period.
Energies press(const Press& how, const HapticParameters& parameters, double phase)
{
  FedDevice device;
  WallRig rig(device, { how.period_s, parameters });
  Energies energies;
  double before = 0.0;
  for (double t = (phase - 1.0) * how.period_s; t < 2 * how.depth_m / how.speed_m_per_s + 2 * how.period_s;
       t += how.period_s)
  {
    DeviceSample sample;
    sample.pose_D.p.z() = std::min(0.0, std::abs(how.depth_m - how.speed_m_per_s * t) - how.depth_m);
    device.feed(sample);
    const HapticState& state = rig.tick();
    energies.meter_J = state.energy.delivered_J;
    energies.textbook_J += state.force_D.z() * (sample.pose_D.p.z() - before);
    before = sample.pose_D.p.z();
  }
  return energies;
}

struct Leak
{
  double mean_J = 0.0, largest_J = -1e9, textbook_J = 0.0;
};

Leak overPhases(const Press& how, const HapticParameters& parameters, int phases)
{
  Leak leak;
  for (int i = 0; i < phases; ++i)
  {
    const Energies one = press(how, parameters, static_cast<double>(i) / phases);
    leak.mean_J += one.meter_J / phases;
    leak.textbook_J += one.textbook_J / phases;
    leak.largest_J = std::max(leak.largest_J, one.meter_J);
  }
  return leak;
}

} // namespace energy_leak_experiment

void runEnergyLeak(const Conditions& conditions, Table& table)
{
  using namespace energy_leak_experiment;
  constexpr double K = 1000.0;
  const int phases = conditions.pick(50, 100, 400);
  for (const Press& how : { Press{ 0.1, 5e-3, 1e-3 }, Press{ 0.1, 5e-3, 1e-2 }, Press{ 0.2, 2e-3, 1e-3 } })
  {
    const std::string name =
      caseName({ { "speed", how.speed_m_per_s }, { "depth", how.depth_m }, { "period", how.period_s } });
    const double perDepth = K * how.speed_m_per_s * how.period_s;
    const double mean = perDepth * (how.depth_m - how.speed_m_per_s * how.period_s / 2), most = perDepth * how.depth_m;
    const Leak held = overPhases(how, plainSpring(K), phases);
    // The mean over n phases of a quadratic is off by (1 / n)^2.
    table.within({ name, "spring", "energy given, mean over phases", "J" }, held.mean_J, mean, 1e-3 * mean);
    table.within({ name, "spring", "energy given, most", "J" }, held.largest_J, most, 1e-3 * most);
    table.within(
      { name, "textbook meter", "energy given, mean over phases", "J" }, held.textbook_J, -mean, 1e-3 * mean);
    const Leak passive = overPhases(how, passiveSpring(K), phases);
    table.atMost({ name, "spring+passivity", "energy given, most", "J" }, passive.largest_J, 0.0);
  }
}

} // namespace palpate::lab
