// SPDX-License-Identifier: GPL-3.0-or-later
// The stability atlas: how stiff a wall may be against rate, delay, damping, encoder step and friction.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "devices/simulated/SerialLink.h"
#include "haptics/force/SampledWall.h"
#include "haptics/force/StabilityLimits.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/CriticalStiffness.h"

namespace palpate::lab
{
namespace stability_atlas_experiment
{

constexpr double period_s = 1e-3, damper_Ns_per_m = 2.0, stiffest_N_per_m = 1e5;

/// A chain of the product, and the linear loop it is while contact lasts.
struct Chain
{
  const char* name;
  HapticParameters (*parameters)(double K, double delay_ticks);
  double virtualDamping = 0.0;
  bool leads = false;
};

const std::vector<Chain>& chains()
{
  static const std::vector<Chain> all = { { "spring", [](double K, double) { return plainSpring(K); } },
    { "spring+damper", [](double K, double) { return springDamper(K, damper_Ns_per_m); }, damper_Ns_per_m },
    { "spring+passivity", [](double K, double d) { return passiveSpring(K, d); }, 0.0, true } };
  return all;
}

SampledWall theoryOf(const Chain& chain, const FreeDevice& device, double T)
{
  SampledWall wall;
  wall.mass_kg = device.model.mass_kg;
  wall.damping_Ns_per_m = device.model.damping_Ns_per_m;
  wall.period_s = T;
  wall.delay_ticks = device.delay_ticks;
  wall.virtualDamping_Ns_per_m = chain.virtualDamping;
  return wall;
}

/// Eigenvalues; of the controller's loop with the least and the most damping it gives, whichever holds less.
double theoreticalLimit(const Chain& chain, const FreeDevice& device, double T)
{
  SampledWall wall = theoryOf(chain, device, T);
  if (!chain.leads)
  {
    return std::min(criticalStiffness(wall), stiffest_N_per_m);
  }
  const PassivityPlan plan;
  wall.leadPeriods = 0.5 + device.delay_ticks + plan.reserve;
  const double least = criticalStiffness(wall);
  wall.leadPeriods += plan.repay;
  return std::min({ least, criticalStiffness(wall), stiffest_N_per_m });
}

/// Where linear theory holds: exact positions, no friction. The controller's repayment is not linear: it may hold more.
void judgeLinear(const std::string& name, const Chain& chain, FreeDevice device, double T, Table& table)
{
  device.push_N = 1.0;
  const double found = measuredCriticalStiffness(
    device,
    [&](double K) {
      return WallSetup{ T, chain.parameters(K, device.delay_ticks), {} };
    },
    stiffest_N_per_m);
  const double theory = theoreticalLimit(chain, device, T);
  const Subject subject{ name, chain.name, "K_max", "N/m" };
  if (chain.leads)
  {
    table.atLeast(subject, found, 0.99 * theory).truth = theory;
  }
  else
  {
    table.within(subject, found, theory, std::max(0.01 * theory, 2.0));
  }
  const double passive =
    std::max(0.0, device.model.damping_Ns_per_m - chain.virtualDamping) / ((0.5 + device.delay_ticks) * T);
  table.info({ name, chain.name, "K_passive", "N/m" }, std::min(passive, stiffest_N_per_m));
}

/// Released 2 mm above the wall and pushed on with 1 N for 4 s: does it come to rest within three encoder steps?
bool rests(const Chain& chain, FreeDevice released, double K)
{
  released.push_N = 1.0 + released.model.friction_N; // the net push is 1 N whatever its friction
  released.z_m = 2e-3;
  released.speed_m_per_s = -0.05;
  const auto device = makeFree(released, period_s);
  WallRig rig(*device, { period_s, chain.parameters(K, released.delay_ticks), {} });
  constexpr int ticks = 4000, tail = 2800;
  const std::optional<double> left_m = swing_m(rig, *device, ticks, tail);
  const double exactPositions_m = 1e-6;
  return left_m && *left_m <= std::max(3.0 * released.model.encoderStep_m, exactPositions_m);
}

/// Upper end of the stiffnesses from 20 N/m on that come to rest, to 2 %.
double stiffestAtRest(const Chain& chain, const FreeDevice& device)
{
  constexpr double softest = 20.0; // softer ones are slower than the watch
  double low = softest, high = low;
  while (rests(chain, device, high))
  {
    low = high;
    high *= 1.3;
    if (high > stiffest_N_per_m)
    {
      return stiffest_N_per_m;
    }
  }
  if (high == softest)
  {
    return 0.0;
  }
  while (high / low > 1.02)
  {
    const double middle = std::sqrt(low * high);
    (rests(chain, device, middle) ? low : high) = middle;
  }
  return low;
}

/// How late a force is in the mean: half a period; behind a link that is slower it waits for a tick, is under way, and
/// is then held for as long.
double lag_s(const DeviceModel& model)
{
  const double link_s = SerialLink::force_B / model.link_B_per_s;
  return link_s > period_s ? period_s + 1.5 * link_s : 0.5 * period_s;
}

/// With friction and encoder: passivity by min(b / lag, 2 c / D) is enough, and the plain spring must show it.
void judgeRest(const std::string& name, const Chain& chain, const FreeDevice& device, Table& table)
{
  const double found = stiffestAtRest(chain, device);
  const double byDamping = std::max(0.0, device.model.damping_Ns_per_m - chain.virtualDamping) / lag_s(device.model);
  const double passive = device.model.encoderStep_m > 0.0
                           ? std::min(byDamping, 2 * device.model.friction_N / device.model.encoderStep_m)
                           : byDamping;
  const double bound = std::min(passive, stiffest_N_per_m);
  const Subject subject{ name, chain.name, "K_max", "N/m" };
  bound > 0.0 ? table.atLeast(subject, found, 0.98 * bound) : table.info(subject, found); // else nothing is promised
  table.info({ name, chain.name, "K_passive", "N/m" }, bound);
}

std::string varied(const char* what, double x)
{
  return std::string("device=D1 vary=") + what + " " + caseName({ { "x", x } });
}

/// The ends and the middle of an axis in a quick run.
std::vector<double> along(const Conditions& conditions, const std::vector<double>& all)
{
  return conditions.size == Size::Quick ? std::vector<double>{ all.front(), all[all.size() / 2], all.back() } : all;
}

void varyLinear(const Conditions& conditions, Table& table)
{
  for (const Chain& chain : chains())
  {
    for (const double rate : along(conditions, { 20.0, 60.0, 125.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0 }))
    {
      judgeLinear(varied("rate", rate), chain, FreeDevice{}, 1.0 / rate, table);
    }
    for (const double delay : along(conditions, { 0.0, 1.0, 2.0, 3.0 }))
    {
      FreeDevice device;
      device.delay_ticks = static_cast<int>(delay);
      judgeLinear(varied("delay", delay), chain, device, period_s, table);
    }
    for (const double damping : along(conditions, { 0.05, 0.2, 0.5, 1.0, 2.0, 5.0 }))
    {
      FreeDevice device;
      device.model.damping_Ns_per_m = damping;
      judgeLinear(varied("damping", damping), chain, device, period_s, table);
    }
  }
}

void varyEncoderAndFriction(const Conditions& conditions, Table& table)
{
  for (const Chain& chain : chains())
  {
    for (const double step_um : along(conditions, { 5.0, 10.0, 20.0, 50.0, 100.0, 200.0 }))
    {
      FreeDevice device;
      device.model.friction_N = 0.05;
      device.model.encoderStep_m = 1e-6 * step_um;
      judgeRest(varied("quantisation", step_um), chain, device, table);
    }
    for (const double friction : along(conditions, { 0.0, 0.02, 0.05, 0.1, 0.2, 0.4 }))
    {
      FreeDevice device;
      device.model.friction_N = friction;
      device.model.encoderStep_m = 50e-6;
      judgeRest(varied("friction", friction), chain, device, table);
    }
  }
}

/// The stiffness the session limits itself to on a device must hold there, in nobody's hand.
void judgeLimit(const std::string& name, const DeviceModel& model, Table& table)
{
  LoopSettings loop;
  loop.period_s = period_s;
  loop.passivity.enabled = true;
  const double K = stabilityLimits(infoOf(model), loop).largest_N_per_m;
  const Chain& chain = chains().back(); // with the controller
  FreeDevice device{ model };
  bool holds = rests(chain, device, K);
  if (model.encoderStep_m == 0.0)
  {
    device.push_N = 1.0;
    holds = !grows(device, { period_s, chain.parameters(K, 0.0), {} });
  }
  table.atMost({ name, "the session's limit", "outcome", outcomeUnit },
    static_cast<double>(holds ? Outcome::Held : Outcome::Unstable), 0.0);
  table.info({ name, "the session's limit", "largest stiffness", "N/m" }, K);
}

/// The devices as they are, and the limit the product gives them.
void everyDevice(Table& table)
{
  for (const DeviceModel& device : deviceModels())
  {
    const std::string name = "device=" + device.id + " vary=device x=0";
    for (const Chain& chain : chains())
    {
      const bool exact = device.encoderStep_m == 0.0 && device.friction_N == 0.0;
      exact ? judgeLinear(name, chain, FreeDevice{ device }, period_s, table)
            : judgeRest(name, chain, FreeDevice{ device }, table);
    }
    judgeLimit(name, device, table);
  }
}

} // namespace stability_atlas_experiment

void runStabilityAtlas(const Conditions& conditions, Table& table)
{
  using namespace stability_atlas_experiment;
  varyLinear(conditions, table);
  conditions.progress(0.4);
  varyEncoderAndFriction(conditions, table);
  conditions.progress(0.8);
  everyDevice(table);
}

} // namespace palpate::lab
