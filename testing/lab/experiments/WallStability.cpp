// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 1 and 2, chart C3: the stiffness at which a sampled wall begins to shake, against exact eigenvalues.
#include <algorithm>
#include <string>
#include <vector>

#include "haptics/force/SampledWall.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/CriticalStiffness.h"

namespace palpate::lab
{
namespace wall_stability_experiment
{

/// A wall and its limit by an independent eigenvalue computation (numpy), to four digits.
struct Listed
{
  double mass_kg, damping, virtualDamping;
  int delay_ticks;
  double rate_Hz;
  double listed_N_per_m;
};

const std::vector<Listed>& byRate()
{
  static const std::vector<Listed> walls = { { 0.1, 1, 0, 0, 20, 43.6 }, { 0.1, 1, 0, 0, 50, 103.4 },
    { 0.1, 1, 0, 0, 60, 123.4 }, { 0.1, 1, 0, 0, 100, 203 }, { 0.1, 1, 0, 0, 250, 503 }, { 0.1, 1, 0, 0, 500, 1003 },
    { 0.1, 1, 0, 0, 1000, 2003.3 }, { 0.1, 1, 0, 0, 2000, 4003 }, { 0.1, 1, 0, 0, 4000, 8003 } };
  return walls;
}

const std::vector<Listed>& byDevice()
{
  static const std::vector<Listed> walls = { { 0.1, 1, 0, 1, 1000, 668.5 }, { 0.1, 1, 0, 2, 1000, 401.7 },
    { 0.1, 1, 2, 0, 1000, 5891.6 }, { 0.1, 1, 5, 0, 1000, 11436.6 }, { 0.1, 1, 5, 2, 1000, 2240.8 },
    { 0.072, 0.005, 0, 0, 1000, 10.0 }, { 0.072, 0.005, 2, 0, 1000, 3900.2 }, { 0.045, 0.1, 0, 0, 1000, 200.1 },
    { 0.045, 0.1, 5, 2, 1000, 1710.9 }, { 0.25, 3, 0, 0, 1000, 6012.0 } };
  return walls;
}

double measured(const Listed& wall)
{
  FreeDevice device;
  device.model.mass_kg = wall.mass_kg;
  device.model.damping_Ns_per_m = wall.damping;
  device.delay_ticks = wall.delay_ticks;
  device.push_N = 1.0;
  return measuredCriticalStiffness(device,
    [&wall](double K) {
      return WallSetup{ 1.0 / wall.rate_Hz, springDamper(K, wall.virtualDamping) };
    });
}

double eigenvalues(const Listed& wall)
{
  SampledWall sampled;
  sampled.mass_kg = wall.mass_kg;
  sampled.damping_Ns_per_m = wall.damping;
  sampled.virtualDamping_Ns_per_m = wall.virtualDamping;
  sampled.delay_ticks = wall.delay_ticks;
  sampled.period_s = 1.0 / wall.rate_Hz;
  return criticalStiffness(sampled);
}

void judge(const Listed& wall, const std::string& name, Table& table)
{
  const std::string method = wall.virtualDamping > 0 ? "spring+damper" : "spring";
  const double exact = eigenvalues(wall), found = measured(wall);
  table.within({ name, method, "K_crit", "N/m" }, found, exact, 0.01 * exact);
  table.within({ name, method, "K_crit, listed", "N/m" }, found, wall.listed_N_per_m, 0.01 * wall.listed_N_per_m);
  // Passive and stable are different questions: b > K (T/2 + delay) + |B| holds for any hand.
  const double lag_s = (0.5 + wall.delay_ticks) / wall.rate_Hz;
  const double passive = std::max(0.0, (wall.damping - wall.virtualDamping) / lag_s);
  table.info({ name, method, "K_passive", "N/m" }, passive);
  if (passive > 0.0)
  {
    table.atLeast({ name, method, "K_crit / K_passive" }, found / passive, 1.0);
  }
}

} // namespace wall_stability_experiment

void runWallStability(const Conditions& conditions, Table& table)
{
  using namespace wall_stability_experiment;
  std::size_t done = 0;
  const double all = static_cast<double>(byRate().size() + byDevice().size());
  for (const Listed& wall : byRate())
  {
    judge(wall, caseName({ { "rate", wall.rate_Hz } }), table);
    conditions.progress(static_cast<double>(++done) / all);
  }
  for (const Listed& wall : byDevice())
  {
    judge(wall,
      caseName({ { "rate", wall.rate_Hz }, { "mass", wall.mass_kg }, { "damping", wall.damping },
        { "virtual", wall.virtualDamping }, { "delay", wall.delay_ticks } }),
      table);
    conditions.progress(static_cast<double>(++done) / all);
  }
}

} // namespace palpate::lab
