// SPDX-License-Identifier: GPL-3.0-or-later
// Row 6: a quantised wall under a constant push, damping against friction: where it stays still and where it cycles.
#include <algorithm>
#include <array>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/FreeDevice.h"
#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{
namespace limit_cycles_experiment
{

constexpr double K = 1000.0, T = 1e-3, D = 50e-6, mass_kg = 0.1, push_N = 1.0, watch_s = 8.0;

/// b / (K T) and c / (K D) of the grid.
constexpr std::array<double, 6> dampings{ 0.0, 0.1, 0.25, 0.4, 0.6, 1.0 };
constexpr std::array<double, 7> frictions{ 0.0, 0.1, 0.25, 0.4, 0.5, 0.6, 1.0 };

/// True: the plain spring comes to rest there (simulation with 200 Euler steps a tick, another program).
constexpr bool rests[6][7] = { { false, false, false, false, false, false, false },
  { false, false, false, false, false, false, true }, { false, false, false, false, true, true, true },
  { false, false, true, true, true, true, true }, { false, true, true, true, true, true, true },
  { false, true, true, true, true, true, true } };

/// The cell whose verdict depends on the integration of friction.
bool onTheEdge(double damping, double friction)
{
  return damping == 0.25 && friction == 0.5;
}

/// Peak to peak of the true position over the last 30 % of the time, in encoder steps; a device that leaves +-1 m
/// counts as 2 m.
double tail(double damping, double friction, const HapticParameters& parameters)
{
  FreeDevice pushed;
  pushed.model.mass_kg = mass_kg;
  pushed.model.damping_Ns_per_m = damping * K * T;
  pushed.model.friction_N = friction * K * D;
  pushed.model.encoderStep_m = D;
  pushed.push_N = push_N;
  pushed.z_m = 2e-3;
  pushed.speed_m_per_s = -0.05;
  const auto device = makeFree(pushed, T);
  WallRig rig(*device, { T, parameters });
  const int ticks = static_cast<int>(watch_s / T);
  return swing_m(rig, *device, ticks, static_cast<int>(0.7 * ticks) + 1).value_or(2.0) / D;
}

} // namespace limit_cycles_experiment

void runLimitCycles(const Conditions& conditions, Table& table)
{
  using namespace limit_cycles_experiment;
  constexpr double still = 0.5;
  for (std::size_t i = 0; i < dampings.size(); ++i)
  {
    for (std::size_t j = 0; j < frictions.size(); ++j)
    {
      const std::string name = caseName({ { "damping", dampings[i] }, { "friction", frictions[j] } });
      const double plain = tail(dampings[i], frictions[j], plainSpring(K));
      const Subject subject{ name, "spring", "peak to peak at the end", "encoder steps" };
      if (onTheEdge(dampings[i], frictions[j]))
      {
        table.info(subject, plain);
      }
      else if (rests[i][j])
      {
        table.atMost(subject, plain, still);
      }
      else
      {
        table.atLeast(subject, plain, still);
      }
      table.atMost({ name, "spring+passivity", "peak to peak at the end", "encoder steps" },
        tail(dampings[i], frictions[j], passiveSpring(K)), 3.0);
    }
    conditions.progress(static_cast<double>(i + 1) / dampings.size());
  }
}

} // namespace palpate::lab
