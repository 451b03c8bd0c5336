// SPDX-License-Identifier: GPL-3.0-or-later
// A needle as a lever in a wall and an organ, swayed across by a hand: the cost of a tick and the error of the felt
// force by each method.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/support/LeverRig.h"

namespace palpate::lab
{
namespace mechanism_methods_experiment
{

using Lever = test::NeedleLever;
using Two = Lever::Two;

/// The force on a hand that has gone so far across [N], one call a tick.
using Method = std::function<double(double hand_m)>;

Method whole(const Lever& lever)
{
  return [rig = std::make_shared<test::LeverRig>(lever)](double hand_m) { return rig->force_N(hand_m).sum(); };
}

Method spotBySpot(const Lever& lever)
{
  return [lever](double hand_m) { return lever.forceBySpot_N(hand_m).sum(); };
}

/// The stiffness of the needle at rest, for all times.
Method linearOnce(const Lever& lever)
{
  constexpr double step_m = 1e-3;
  return [stiffness = lever.forceByEnergy_N(step_m).sum() / step_m](double hand_m) { return stiffness * hand_m; };
}

/// Each spot solved in turn under the force that the other had before, one sweep a tick.
Method inTurn(const Lever& lever)
{
  const auto shared_m_per_N = [lever](int i, int j)
  { return 1.0 / test::kc + lever.place_m[i] * lever.place_m[j] / lever.turning_Nm_per_rad; };
  return [=, force_N = Two(Two::Zero())](double hand_m) mutable
  {
    for (int i = 0; i < 2; ++i)
    {
      const double own = shared_m_per_N(i, i) + 1.0 / lever.stiffness_N_per_m[i];
      force_N[i] = -(hand_m + shared_m_per_N(i, 1 - i) * force_N[1 - i]) / own;
    }
    return force_N.sum();
  };
}

/// The whole at the rate of a screen: each force is held for 16 ticks.
Method held(const Lever& lever)
{
  return [now = whole(lever), tick = 0, force_N = 0.0](double hand_m) mutable
  {
    constexpr int period = 16;
    force_N = tick++ % period == 0 ? now(hand_m) : force_N;
    return force_N;
  };
}

/// A sway of the hand from side to side, and the forces that are true.
struct Sway
{
  std::vector<double> hand_m, truth_N;
  double most_N = 0.0;
};

Sway swayOf(const Lever& lever, double reach_m, int ticks)
{
  constexpr double rate_Hz = 2.0, period_s = 1e-3;
  Sway sway;
  for (int i = 0; i < ticks; ++i)
  {
    sway.hand_m.push_back(reach_m * std::sin(2.0 * std::numbers::pi * rate_Hz * period_s * i));
    sway.truth_N.push_back(lever.forceOfTurn_N(sway.hand_m.back()).sum());
    sway.most_N = std::max(sway.most_N, std::abs(sway.truth_N.back()));
  }
  return sway;
}

void judge(
  const std::string& name, const char* method, const std::function<Method()>& make, const Sway& sway, Table& table)
{
  double worst_N = 0.0;
  const test::LeastCosts cost(costRuns,
    [&](auto call)
    {
      const Method tick = make();
      for (std::size_t i = 0; i < sway.hand_m.size(); ++i)
      {
        double force_N = 0.0;
        call([&] { force_N = tick(sway.hand_m[i]); });
        worst_N = std::max(worst_N, std::abs(force_N - sway.truth_N[i]));
      }
    });
  const double error_JND = worst_N / (forceJnd * sway.most_N);
  const Subject error{ name, method, "error", "JND" }, outcome{ name, method, "outcome", outcomeUnit };
  const bool ours = std::string(method).starts_with("ours");
  (ours ? table.atMost(error, error_JND, 1e-4) : table.info(error, error_JND)).cost = Cost::of(cost);
  table.info(outcome, static_cast<double>(error_JND > 1.0 ? Outcome::Wrong : Outcome::Held));
}

void judgeAll(const Lever& lever, double reach_m, int ticks, Table& table)
{
  const std::string name = caseName({ { "turning", lever.turning_Nm_per_rad }, { "sway_mm", 1e3 * reach_m } });
  const Sway sway = swayOf(lever, reach_m, ticks);
  judge(
    name, "ours: one problem in the constraints' rows", [&] { return whole(lever); }, sway, table);
  judge(
    name, "each spot by itself", [&] { return spotBySpot(lever); }, sway, table);
  judge(
    name, "one spot after the other", [&] { return inTurn(lever); }, sway, table);
  judge(
    name, "linear about the start", [&] { return linearOnce(lever); }, sway, table);
  judge(
    name, "held-60Hz", [&] { return held(lever); }, sway, table);
}

} // namespace mechanism_methods_experiment

void runMechanismMethods(const Conditions& conditions, Table& table)
{
  using namespace mechanism_methods_experiment;
  const int ticks = conditions.pick(125, 500, 5000);
  for (const double turning_Nm : { 0.5, 2.0, 8.0 })
  {
    for (const double reach_m : { 5e-3, 20e-3 })
    {
      judgeAll(Lever{ turning_Nm }, reach_m, ticks, table);
    }
  }
}

} // namespace palpate::lab
