// SPDX-License-Identifier: GPL-3.0-or-later
// Row 47: a handle of 50 g thrown at 0.1 m/s between two walls that its device holds once a millisecond with 5 N at
// most.
#include <algorithm>
#include <cmath>
#include <string>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/Viscosity.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace corridor_experiment
{

constexpr double decayed = 0.1, within_s = 2.0;

DeviceCommand wallsOf(const Corridor& corridor, double viscosity_Ns_per_m)
{
  DeviceCommand command;
  command.walls[0] = { { 1, 0, 0 }, -corridor.halfWidth_m, corridor.stiffness_N_per_m };
  command.walls[1] = { { -1, 0, 0 }, -corridor.halfWidth_m, corridor.stiffness_N_per_m };
  command.wallCount = 2;
  command.viscosity_Ns_per_m = viscosity_Ns_per_m;
  return command;
}

/// A joystick without friction or encoder, so that nothing but the walls and the viscosity decides.
DeviceModel joystick(const Corridor& corridor)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.mass_kg = corridor.mass_kg;
  model.damping_Ns_per_m = corridor.damping_Ns_per_m;
  model.friction_N = 0.0;
  model.encoderStep_m = 0.0;
  model.maxForce_N = corridor.maxForce_N;
  model.maxStiffness_N_per_m = corridor.stiffness_N_per_m;
  model.travel_m = DeviceModel::unlimited;
  return model;
}

struct Ending
{
  double speed_m_per_s = 0.0, reach_m = 0.0;
};

/// The throw on the device itself, its host silent: the largest speed and reach in a fifth of a second from then on.
Ending thrown(const Corridor& corridor, double viscosity_Ns_per_m, double until_s)
{
  SimulationOptions options;
  options.period_s = corridor.period_s;
  options.velocity_D = { corridor.speed_m_per_s, 0, 0 };
  SimulatedDevice device(joystick(corridor), *handModel("none"), { { Vec3::Zero() } }, options);
  (void)device.open();
  device.write(wallsOf(corridor, viscosity_Ns_per_m));
  DeviceSample sample;
  Ending ending;
  for (double time_s = corridor.period_s; time_s < until_s + 0.2; time_s += corridor.period_s)
  {
    (void)device.read(time_s, sample);
    if (time_s >= until_s)
    {
      ending.speed_m_per_s = std::max(ending.speed_m_per_s, std::abs(device.speed_D().x()));
      ending.reach_m = std::max(ending.reach_m, std::abs(device.position_D().x()));
    }
  }
  return ending;
}

bool ends(const Corridor& corridor, double viscosity_Ns_per_m)
{
  return thrown(corridor, viscosity_Ns_per_m, within_s).speed_m_per_s < decayed * corridor.speed_m_per_s;
}

/// The least of a fine scale on which the throw ends, asked of the device.
double leastOnScale(const Corridor& corridor, double step_Ns_per_m)
{
  double viscosity_Ns_per_m = 0.0;
  while (!ends(corridor, viscosity_Ns_per_m) && viscosity_Ns_per_m < 10.0)
  {
    viscosity_Ns_per_m += step_Ns_per_m;
  }
  return viscosity_Ns_per_m;
}

void judgeTable(const Corridor& corridor, Table& table)
{
  constexpr double later_s = 5.0, cure_Ns_per_m = 0.5;
  const std::string name = "width=0.004 stiffness=2000";
  const Ending without = thrown(corridor, 0.0, later_s), with = thrown(corridor, cure_Ns_per_m, later_s);
  table.atLeast(
    { name, "no viscosity", "reach after 5 s over half width" }, without.reach_m / corridor.halfWidth_m, 20);
  table.atLeast({ name, "no viscosity", "speed after 5 s over that of the throw" },
    without.speed_m_per_s / corridor.speed_m_per_s, 20);
  table.atMost({ name, "viscosity 0.5", "reach after 5 s over half width" }, with.reach_m / corridor.halfWidth_m, 1.0);
  table.atMost({ name, "viscosity 0.5", "speed after 5 s over that of the throw" },
    with.speed_m_per_s / corridor.speed_m_per_s, 1e-6);
  Corridor damped = corridor;
  damped.damping_Ns_per_m = 0.2;
  table.atMost({ name, "damping 0.2", "speed after 5 s over that of the throw" },
    thrown(damped, 0.0, later_s).speed_m_per_s / corridor.speed_m_per_s, 1e-6);
}

void judgeFound(const Corridor& corridor, double scale_Ns_per_m, Table& table)
{
  const std::string name =
    caseName({ { "width", 2 * corridor.halfWidth_m }, { "stiffness", corridor.stiffness_N_per_m } });
  const double found_Ns_per_m = smallestViscosity(corridor, within_s).value_or(-1.0);
  const double least_Ns_per_m = leastOnScale(corridor, scale_Ns_per_m);
  table.atMost({ name, "found viscosity", "speed after 2 s over that of the throw" },
    thrown(corridor, std::max(0.0, found_Ns_per_m), within_s).speed_m_per_s / corridor.speed_m_per_s, decayed);
  // The scale is read from above, by at most one of its steps.
  table.atLeast({ name, "found viscosity", "viscosity", "N s/m" }, found_Ns_per_m, least_Ns_per_m - scale_Ns_per_m);
  table.atMost({ name, "found viscosity", "viscosity", "N s/m" }, found_Ns_per_m, 2 * least_Ns_per_m);
}

} // namespace corridor_experiment

void runCorridor(const Conditions& conditions, Table& table)
{
  using namespace corridor_experiment;
  Corridor corridor{ 2e-3, 2000.0, 5.0, 0.05, 0.05, 1e-3, 0.1 };
  judgeTable(corridor, table);
  const double scale_Ns_per_m = conditions.pick(0.02, 0.005, 0.001);
  for (const double halfWidth_m : { 0.5e-3, 1e-3, 2e-3, 4e-3 })
  {
    for (const double stiffness_N_per_m : { 500.0, 1000.0, 2000.0 })
    {
      corridor.halfWidth_m = halfWidth_m;
      corridor.stiffness_N_per_m = stiffness_N_per_m;
      judgeFound(corridor, scale_Ns_per_m, table);
    }
    conditions.progress(halfWidth_m / 4e-3);
  }
}

} // namespace palpate::lab
