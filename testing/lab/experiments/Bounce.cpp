// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 4 and 5: a free mass thrown at a wall comes back with more energy than it brought, or less.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/FreeDevice.h"
#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{
namespace bounce_experiment
{

constexpr double T = 1e-3, mass_kg = 0.1, speed = 0.2;

struct Throw
{
  double energyRatio = 0.0;
  double peakForce_N = 0.0;
};

/// One throw, first sampled a share `phase` of a period before it reaches the wall; the energy is read at the first
/// sample outside at which no delayed force is still to come.
Throw bounce(const FreeDevice& thrown, const HapticParameters& parameters, double phase)
{
  FreeDevice start = thrown;
  start.z_m = speed * T * phase;
  start.speed_m_per_s = -speed;
  const auto device = makeFree(start, T);
  WallRig rig(*device, { T, parameters });
  Throw result;
  int freeTicks = 0;
  bool touched = false;
  constexpr int most = 100000;
  for (int tick = 0; tick < most && !(touched && freeTicks > thrown.delay_ticks); ++tick)
  {
    const HapticState& state = rig.tick();
    result.peakForce_N = std::max(result.peakForce_N, state.force_D.norm());
    touched = touched || state.contacts > 0;
    freeTicks = state.contacts > 0 ? 0 : freeTicks + 1;
    const double v = device->speed_D().z();
    result.energyRatio = v * v / (speed * speed);
  }
  return result;
}

struct Throws
{
  double mean = 0.0, largest = 0.0, peakForce_N = 0.0;
};

Throws overPhases(const FreeDevice& thrown, const HapticParameters& parameters, int phases)
{
  Throws all;
  for (int i = 0; i < phases; ++i)
  {
    const Throw one = bounce(thrown, parameters, (i + 1.0) / phases);
    all.mean += one.energyRatio / phases;
    all.largest = std::max(all.largest, one.energyRatio);
    all.peakForce_N = std::max(all.peakForce_N, one.peakForce_N);
  }
  return all;
}

/// Without controller: exp(pi w T (1/2 + d)) as long as w T is small.
void judgeFormula(double K, int delay, int phases, Table& table)
{
  FreeDevice thrown;
  thrown.model.mass_kg = mass_kg;
  thrown.model.damping_Ns_per_m = 0.0;
  thrown.delay_ticks = delay;
  const double wT = std::sqrt(K / mass_kg) * T;
  const double formula = std::exp(std::numbers::pi * wT * (0.5 + delay));
  const double mean = overPhases(thrown, plainSpring(K), phases).mean;
  const std::string name = caseName({ { "stiffness", K }, { "damping", 0 }, { "delay", delay } });
  // The formula is the limit of small w T: half a per cent up to 0.23, one per cent with delay up to 0.15.
  const double tolerance = delay == 0 ? 0.005 : 0.01;
  table.within({ name, "spring", "energy out over energy in" }, mean, formula, tolerance * formula);
}

void judgeController(double K, double damping, int phases, Table& table)
{
  FreeDevice thrown;
  thrown.model.mass_kg = mass_kg;
  thrown.model.damping_Ns_per_m = damping;
  const std::string name = caseName({ { "stiffness", K }, { "damping", damping }, { "delay", 0 } });
  const Throws held = overPhases(thrown, plainSpring(K), phases);
  const Throws passive = overPhases(thrown, passiveSpring(K), phases);
  const double limit = damping == 0.0 ? 1.03 : 0.95;
  table.atMost({ name, "spring+passivity", "energy out over energy in, mean" }, passive.mean, limit);
  table.atMost({ name, "spring+passivity", "energy out over energy in, most" }, passive.largest, limit);
  table.atMost(
    { name, "spring+passivity", "peak force over the spring's" }, passive.peakForce_N / held.peakForce_N, 1.05);
  if (damping == 0.0)
  {
    table.atLeast({ name, "spring", "energy out over energy in, mean" }, held.mean, 1.0);
  }
}

} // namespace bounce_experiment

void runBounce(const Conditions& conditions, Table& table)
{
  using namespace bounce_experiment;
  const int phases = conditions.pick(40, 40, 200);
  for (const double K : { 100.0, 500.0, 1000.0, 2000.0, 5000.0 })
  {
    judgeFormula(K, 0, phases, table);
  }
  for (const double K : { 100.0, 500.0, 1000.0, 2000.0 })
  {
    judgeFormula(K, 1, phases, table);
  }
  for (const double K : { 1000.0, 2000.0, 5000.0, 10000.0 })
  {
    judgeController(K, 0.0, phases, table);
    judgeController(K, 1.0, phases, table);
  }
}

} // namespace palpate::lab
