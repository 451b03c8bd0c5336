// SPDX-License-Identifier: GPL-3.0-or-later
// Row 90: a wall of a spring that pulls as well as it pushes, switched by the host once a period T while the handle is
// behind it. Entering at speed v at a share s of the period before the host looks, the hand is spared K (v T s)^2 / 2
// of the work against a true wall; leaving, it is pulled back for as long.
#include <algorithm>
#include <cmath>
#include <string>

#include "devices/common/BareSprings.h"
#include "devices/simulated/SimulatedDevice.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/PlaneGame.h"
#include "testing/support/PlainJoystick.h"

namespace palpate::lab
{
namespace switched_springs_experiment
{

constexpr double K = 200.0, speed_m_per_s = 0.1;
constexpr double heavy_kg = 1e4; // a hand whose speed no spring changes
constexpr double fine = 1e-4;    // of the host's period: the device's loop; it leaks 18 times that share of the energy
constexpr int behind = 3;        // updates of the host with the handle behind the wall

/// The wall x >= 0.
DeviceCommand wall()
{
  DeviceCommand command;
  command.walls[0] = { { 1, 0, 0 }, 0.0, K };
  command.wallCount = 1;
  return command;
}

SimulatedDevice heavyDevice(double host_s, double x_m, double way)
{
  DeviceModel model = test::plainJoystick(0.0);
  model.mass_kg = heavy_kg;
  model.maxForce_N = model.travel_m = DeviceModel::unlimited;
  model.loop_s = fine * host_s;
  model.bareSprings = true;
  SimulationOptions options;
  options.period_s = host_s;
  options.velocity_D = { way * speed_m_per_s, 0, 0 };
  return { model, *handModel("none"), { { Vec3(x_m, 0, 0) } }, options };
}

/// Work that the hand got while the host looked that often [J].
double work_J(SimulatedDevice& device, double host_s, int updates)
{
  static_cast<void>(device.open());
  device.write(wall());
  DeviceSample sample;
  for (int i = 1; i <= updates; ++i)
  {
    static_cast<void>(device.read(i * host_s, sample));
    device.write(wall());
  }
  const double after_m_per_s = device.speed_D().x();
  return 0.5 * heavy_kg * (std::fabs(after_m_per_s) - speed_m_per_s) * (std::fabs(after_m_per_s) + speed_m_per_s);
}

/// More than a true wall allows on the inward path, where the host looks a share of its period after the hand is in.
double given_J(double host_s, double share)
{
  const double step_m = speed_m_per_s * host_s;
  SimulatedDevice device = heavyDevice(host_s, (1.0 - share) * step_m, -1.0);
  const double got_J = work_J(device, host_s, behind);
  const double deep_m = device.position_D().x();
  return got_J + 0.5 * K * deep_m * deep_m;
}

/// Less than a true wall gives it on the outward path.
double taken_J(double host_s, double share)
{
  const double from_m = -(behind - share) * speed_m_per_s * host_s;
  SimulatedDevice device = heavyDevice(host_s, from_m, 1.0);
  return 0.5 * K * from_m * from_m - work_J(device, host_s, behind + 1);
}

/// Mean over the moments at which a hand can come in, and the most.
struct Given
{
  double mean_J = 0.0, most_J = 0.0;
};

void judgeEnergy(double host_Hz, int moments, Table& table)
{
  const double host_s = 1.0 / host_Hz, step_m = speed_m_per_s * host_s;
  const std::string name = caseName({ { "host", host_Hz } });
  Given in, out;
  for (int k = 0; k < moments; ++k)
  {
    const double share = (k + 0.5) / moments, truth_J = 0.5 * K * step_m * step_m * share * share;
    const double given = given_J(host_s, share), taken = taken_J(host_s, share);
    const std::string at = caseName({ { "host", host_Hz }, { "share", share } });
    const double tolerance_J = 0.01 * truth_J + 2 * fine * behind * K * step_m * step_m;
    table.within({ at, "switched spring", "energy given on the way in", "J" }, given, truth_J, tolerance_J);
    table.within({ at, "switched spring", "energy taken on the way out", "J" }, taken, truth_J, tolerance_J);
    in = { in.mean_J + given / moments, std::max(in.most_J, given) };
    out = { out.mean_J + taken / moments, std::max(out.most_J, taken) };
  }
  const double mean_J = K * step_m * step_m / 6.0, most_J = 0.5 * K * step_m * step_m;
  table.within({ name, "switched spring", "mean energy given", "J" }, in.mean_J, mean_J, 0.01 * mean_J);
  table.within({ name, "switched spring", "mean energy taken", "J" }, out.mean_J, mean_J, 0.01 * mean_J);
  table.within({ name, "switched spring", "mean of a whole visit over what is given" },
    (in.mean_J - out.mean_J) / mean_J, 0.0, 0.01);
  const double last = 1.0 - 1e-3; // the host looks just before a whole period has gone
  table.within({ name, "switched spring", "most energy given", "J" }, std::max(in.most_J, given_J(host_s, last)),
    most_J, 0.01 * most_J);
  table.within({ name, "switched spring", "most energy taken", "J" }, std::max(out.most_J, taken_J(host_s, last)),
    most_J, 0.01 * most_J);
}

/// The step of the force when the host first sees the handle behind the wall.
void judgeStep(double host_Hz, Table& table)
{
  const double truth_N = K * speed_m_per_s / host_Hz;
  DeviceCommand command = wall();
  switchSprings({ -speed_m_per_s / host_Hz, 0, 0 }, command);
  const DeviceWall& spring = command.walls[0];
  const double step_N = command.wallCount > 0 ? conditionForce(bareSpring(spring.offset_m, spring.stiffness_N_per_m),
                                                  -speed_m_per_s / host_Hz)
                                              : 0.0;
  table.within(
    { caseName({ { "host", host_Hz } }), "switched spring", "largest step of the force", "N" }, step_N, truth_N, 1e-12);
}

/// A handle pushed with f squarely against a line at 45 degrees rests f / K behind it, as against true walls.
void judgeRest(double host_Hz, Table& table)
{
  constexpr double push_N = 0.5;
  const double half = std::sqrt(0.5);
  PlaneGameSetup game;
  game.model = test::plainJoystick(2 * std::sqrt(K));
  game.model.mass_kg = 1.0;
  game.model.bareSprings = true;
  game.curves = { { { -0.04, 0.038 }, { 0.04, -0.042 } }, { { 0, 1 } } }; // x + y = -2 mm
  game.stiffness_N_per_m = K;
  game.rate_Hz = host_Hz;
  game.push_D = -push_N * Vec3(half, half, 0);
  PlaneGame play(game);
  for (int i = 0; i < static_cast<int>(4 * host_Hz); ++i)
  {
    play.step();
  }
  table.within({ caseName({ { "host", host_Hz } }), "switched springs, played", "rest below the start", "m" },
    -play.device().position_D().dot(Vec3(half, half, 0)), 0.002 * half + push_N / K, 1e-5);
}

/// A handle thrown to and fro in a corridor of the viscosity that the session finds: its largest speed after 4.5 s.
void judgeCorridor(double host_Hz, Table& table)
{
  constexpr double halfWidth_m = 0.002, thrown_m_per_s = 0.1;
  PlaneGameSetup game;
  game.model = test::plainJoystick(0.05);
  game.model.bareSprings = true;
  game.curves = { { { -0.04, halfWidth_m }, { 0.04, halfWidth_m }, { -0.04, -halfWidth_m }, { 0.04, -halfWidth_m } },
    { { 0, 1 }, { 2, 3 } } };
  game.stiffness_N_per_m = K;
  game.rate_Hz = host_Hz;
  game.velocity_D = { 0, thrown_m_per_s, 0 };
  PlaneGame play(game);
  double late_m_per_s = 0.0;
  for (int i = 0; i < static_cast<int>(5 * host_Hz); ++i)
  {
    play.step();
    late_m_per_s = i >= static_cast<int>(4.5 * host_Hz) ? std::max(late_m_per_s, play.device().speed_D().norm()) : 0.0;
  }
  table.atMost({ caseName({ { "host", host_Hz } }), "switched springs, viscosity found",
                 "speed after 4.5 s over that of the throw" },
    late_m_per_s / thrown_m_per_s, 0.1);
}

} // namespace switched_springs_experiment

void runSwitchedSprings(const Conditions& conditions, Table& table)
{
  using namespace switched_springs_experiment;
  const int moments = conditions.pick(16, 32, 128);
  const double rates_Hz[] = { 60.0, 125.0, 250.0, 1000.0 };
  for (const double host_Hz : rates_Hz)
  {
    judgeEnergy(host_Hz, moments, table);
    judgeStep(host_Hz, table);
    judgeRest(host_Hz, table);
    judgeCorridor(host_Hz, table);
    conditions.progress(host_Hz / 1000.0);
  }
}

} // namespace palpate::lab
