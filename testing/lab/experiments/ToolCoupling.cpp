// SPDX-License-Identifier: GPL-3.0-or-later
// Row 34: a tool with a mass on a virtual coupling in free air. The product's method, a tool without mass that goes to
// where it is least stretched, is the column that has no limit.
#include <cmath>
#include <limits>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/ExactLoops.h"

namespace palpate::lab
{
namespace tool_coupling_experiment
{

constexpr double device_kg = 0.1, device_Ns_per_m = 1.0, period_s = 1e-3;
constexpr double most_N_per_m = 1e6;
constexpr int states = 5; // device: place, speed; tool: place, speed; the device's place a period before
using State = Eigen::Matrix<double, states, 1>;
using Loop = Eigen::Matrix<double, states, states>;

struct Coupling
{
  double tool_kg, damping_Ns_per_m;
  bool implicit;
};

/// The coupling's pull on the tool, as a row: the device's speed is the difference of its last two places.
State pullOnTool(const Coupling& c, double K)
{
  State pull = State::Zero();
  pull << K + c.damping_Ns_per_m / period_s, 0.0, -K, -c.damping_Ns_per_m, -c.damping_Ns_per_m / period_s;
  return pull;
}

/// One period: the device exactly under the held force, the tool by half-implicit or implicit Euler.
Loop loopOf(const Coupling& c, double K)
{
  Loop loop = Loop::Zero();
  State pull = pullOnTool(c, K);
  const double T = period_s;
  const State speed = State::Unit(3) + T / c.tool_kg * pull;
  // Implicit: the same with the tool's place and speed at the end of the period.
  const double heavier = c.implicit ? 1.0 + T / c.tool_kg * (c.damping_Ns_per_m + T * K) : 1.0;
  const State toolSpeed =
    c.implicit ? State((speed + T / c.tool_kg * c.damping_Ns_per_m * State::Unit(3)) / heavier) : speed;
  const State toolPlace = State::Unit(2) + T * toolSpeed;
  if (c.implicit)
  {
    pull += K * (State::Unit(2) - toolPlace) + c.damping_Ns_per_m * (State::Unit(3) - toolSpeed);
  }
  const ExactStep device = ExactStep::of(device_kg, device_Ns_per_m, T);
  loop.topLeftCorner<2, 2>() = device.free;
  loop.topRows<2>() -= device.held * pull.transpose();
  loop.row(2) = toolPlace.transpose();
  loop.row(3) = toolSpeed.transpose();
  loop(4, 0) = 1.0;
  return loop;
}

/// The upper end of the first stable interval from 1 N/m on; 0: there is none, the most that is asked for: no end.
double largestStable_N_per_m(const Coupling& c)
{
  const auto shakes = [&](double K) { return spectralRadius(loopOf(c, K)) >= 1.0 + 1e-9; };
  double low = 0.0, high = 1.0;
  while (!shakes(high))
  {
    low = high;
    high *= 1.03;
    if (high > most_N_per_m)
    {
      return most_N_per_m;
    }
  }
  for (int i = 0; i < 60 && low > 0.0; ++i)
  {
    const double middle = 0.5 * (low + high);
    (shakes(middle) ? high : low) = middle;
  }
  return low;
}

} // namespace tool_coupling_experiment

void runToolCoupling(const Conditions& conditions, Table& table)
{
  using namespace tool_coupling_experiment;
  // After Otaduy & Lin (2006); the device D1 at 1 kHz. Largest coupling in N/m by damping and mass of the tool.
  constexpr double masses_kg[] = { 1e-3, 5e-3, 2e-2, 0.1 };
  constexpr double dampings[] = { 0.0, 1.0, 2.0, 5.0 };
  constexpr double truth[4][4] = { { 19.7, 94.9, 332.0, 999.0 }, { 2000.0, 17998.0, 11612.0, 4903.0 },
    { 0.0, 15998.0, 21665.0, 8654.0 }, { 0.0, 9998.0, 46056.0, 19057.0 } };
  for (int d = 0; d < 4; ++d)
  {
    for (int m = 0; m < 4; ++m)
    {
      const std::string name = caseName({ { "tool", masses_kg[m] }, { "damping", dampings[d] } });
      const double explicitly = largestStable_N_per_m({ masses_kg[m], dampings[d], false });
      table.within({ name, "explicit", "K_max", "N/m" }, explicitly, truth[d][m], 0.01 * truth[d][m]);
      const double implicitly = largestStable_N_per_m({ masses_kg[m], dampings[d], true });
      table.atLeast({ name, "implicit", "K_max", "N/m" }, implicitly, 1e5);
    }
  }
  conditions.progress(1.0);
}

} // namespace palpate::lab
