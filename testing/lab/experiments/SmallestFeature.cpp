// SPDX-License-Identifier: GPL-3.0-or-later
// Row 59: a comb of corridors and walls of the same width w. A hand that presses with F stands F / K behind a wall;
// half a wall deep it is nearer to the next corridor. So w = 2 F / K is the least that can be told apart.
#include <cmath>
#include <string>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/FeatureSize.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace smallest_feature_experiment
{

struct Press
{
  double force_N, stiffness_N_per_m;
};

/// Where the hand comes to rest that presses to the right from the middle of the corridor at 0, the wall in front of it
/// from w / 2 to 3 w / 2, the next corridor behind that.
struct Rest
{
  double place_m = 0.0;
  int corridor = 0; ///< the one whose middle is nearest
};

/// The device's wall at the edge that `edge` chooses from the place of the handle; its normal points back or on.
template<class Edge>
Rest press(const Press& how, double width_m, Edge edge)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.friction_N = 0.0;
  model.encoderStep_m = 0.0;
  model.travel_m = DeviceModel::unlimited;
  model.maxForce_N = model.maxStiffness_N_per_m = DeviceModel::unlimited;
  // No overshoot: a hand that lets itself down gently, damped four times as much as it needs not to swing.
  model.damping_Ns_per_m = 8.0 * std::sqrt(model.mass_kg * how.stiffness_N_per_m);
  SimulationOptions options;
  options.push_D = { how.force_N, 0, 0 };
  SimulatedDevice device(model, *handModel("none"), { { Vec3::Zero() } }, options);
  (void)device.open();
  DeviceSample sample;
  constexpr int ticks = 3000;
  for (int tick = 1; tick <= ticks; ++tick)
  {
    DeviceCommand command;
    command.walls[0] = edge(device.position_D().x(), width_m);
    command.walls[0].stiffness_N_per_m = how.stiffness_N_per_m;
    command.wallCount = 1;
    device.write(command);
    (void)device.read(tick * 1e-3, sample);
  }
  const double place_m = device.position_D().x();
  return { place_m, static_cast<int>(std::lround(place_m / (2 * width_m))) };
}

/// A rule that looks at the handle alone pushes it out of the nearest side of the wall it is in.
DeviceWall nearestSide(double x_m, double width_m)
{
  const double period_m = 2 * width_m, wall_m = (std::floor(x_m / period_m) + 0.5) * period_m;
  return x_m < wall_m ? DeviceWall{ { -1, 0, 0 }, -(wall_m - width_m / 2), 0.0 }
                      : DeviceWall{ { 1, 0, 0 }, wall_m + width_m / 2, 0.0 };
}

/// A rule that remembers the virtual location holds the side it came from.
DeviceWall sideItCameFrom(double, double width_m)
{
  return { { -1, 0, 0 }, -width_m / 2, 0.0 };
}

/// The least width at which the hand stays in its corridor, by bisection.
double leastWidth(const Press& how)
{
  double lost_m = 1e-4, kept_m = 1.0;
  while (kept_m - lost_m > 1e-4 * kept_m)
  {
    const double middle_m = 0.5 * (lost_m + kept_m);
    (press(how, middle_m, nearestSide).corridor == 0 ? kept_m : lost_m) = middle_m;
  }
  return kept_m;
}

void judge(const Press& how, Table& table)
{
  const std::string name = caseName({ { "force", how.force_N }, { "stiffness", how.stiffness_N_per_m } });
  const double truth_m = 2 * how.force_N / how.stiffness_N_per_m;
  table.within({ name, "nearest side", "least width told apart", "m" }, leastWidth(how), truth_m, 0.01 * truth_m);
  table.within({ name, "what is said of it", "least width told apart", "m" },
    smallestFeature_m(how.force_N, how.stiffness_N_per_m), truth_m, 1e-12);
}

/// A scene whose corridors are a share of the least felt width, as it is and enlarged by the offered zoom.
void judgeZoom(const Press& how, double share, Table& table)
{
  const double width_m = share * 2 * how.force_N / how.stiffness_N_per_m;
  const std::string name =
    caseName({ { "force", how.force_N }, { "stiffness", how.stiffness_N_per_m }, { "width", width_m } });
  const double zoom = zoomToFeel(width_m, how.force_N, how.stiffness_N_per_m);
  table.within({ name, "zoom offered", "zoom" }, zoom, 1 / share, 1e-9);
  table.atLeast({ name, "nearest side", "corridors lost" }, press(how, width_m, nearestSide).corridor, 1);
  // Just above the limit: at the limit itself both sides are as near.
  constexpr double above = 1.001;
  table.within({ name, "nearest side, enlarged", "corridors lost" },
    press(how, above * zoom * width_m, nearestSide).corridor, 0, 0);
  // With the virtual location the wall stands, but the hand is as deep as before: the feature blurs.
  const Rest held = press(how, width_m, sideItCameFrom);
  const double deep_m = how.force_N / how.stiffness_N_per_m;
  table.within({ name, "virtual location", "depth of the hand", "m" }, held.place_m - width_m / 2, deep_m, 1e-6);
}

} // namespace smallest_feature_experiment

void runSmallestFeature(const Conditions& conditions, Table& table)
{
  using namespace smallest_feature_experiment;
  for (const double force_N : { 0.5, 1.0, 2.0, 5.0 })
  {
    for (const double stiffness_N_per_m : { 100.0, 200.0, 500.0, 1000.0 })
    {
      judge({ force_N, stiffness_N_per_m }, table);
    }
    judgeZoom({ force_N, 200.0 }, 0.5, table);
    judgeZoom({ force_N, 200.0 }, 0.2, table);
    conditions.progress(force_N / 5.0);
  }
}

} // namespace palpate::lab
