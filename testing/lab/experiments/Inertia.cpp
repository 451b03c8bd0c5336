// SPDX-License-Identifier: GPL-3.0-or-later
// A loose body in the hand, on a spring and on a pin: the force of its inertia, how stiffly it may be held, and that
// half the tick is twice as near to the true motion.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/haptics/mechanism/LooseScenes.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace inertia_experiment
{

constexpr double hand_N_per_m = 1e4, own_N_per_m = 20.0, amplitude_m = 1e-3;

/// Amplitude of the hand's force on a box that it shakes: K |k - m w^2| / |K + k - m w^2| a [N].
double shaken_N(double frequency_Hz, double mass_kg)
{
  const double w = 2.0 * std::numbers::pi * frequency_Hz;
  const double own = own_N_per_m - mass_kg * w * w;
  return hand_N_per_m * std::abs(own / (hand_N_per_m + own)) * amplitude_m;
}

/// The same in the tick, once the start has died away.
double felt_N(double frequency_Hz)
{
  test::Coupled coupled(hand_N_per_m, own_N_per_m);
  constexpr double settles_s = 0.5;
  const double w = 2.0 * std::numbers::pi * frequency_Hz, until_s = settles_s + 2.0 / frequency_Hz;
  double most_N = 0.0, least_N = 0.0;
  for (double t = 0.0; t < until_s; t += test::tickOfPath_s)
  {
    const double hand_m = amplitude_m * std::sin(w * t);
    const double force_N = hand_N_per_m * (hand_m - coupled.next(hand_m));
    most_N = t < settles_s ? most_N : std::max(most_N, force_N);
    least_N = t < settles_s ? least_N : std::min(least_N, force_N);
  }
  return 0.5 * (most_N - least_N);
}

void shake(Table& table)
{
  const double mass_kg = test::Coupled(hand_N_per_m, own_N_per_m).mass_kg();
  for (const double frequency_Hz : { 1.0, 2.0, 4.0, 8.0, 16.0 })
  {
    const std::string shaken = caseName({ { "frequency_Hz", frequency_Hz } });
    const double truth_N = shaken_N(frequency_Hz, mass_kg);
    table.within({ shaken, "ours", "force of the hand", "N" }, felt_N(frequency_Hz), truth_N, 0.03 * truth_N);
    table.info({ shaken, "at rest in each tick", "force of the hand", "N" }, shaken_N(frequency_Hz, 0.0));
  }
}

/// How far a box on a spring is from its rest after 3 s, over the way of the hand.
double unsettled(double stiffness_N_per_m, double spring_N_per_m)
{
  test::Coupled coupled(stiffness_N_per_m, spring_N_per_m);
  double at_m = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    at_m = coupled.next(amplitude_m);
  }
  const double rests_m = stiffness_N_per_m / (stiffness_N_per_m + spring_N_per_m) * amplitude_m;
  return std::abs(at_m - rests_m) / amplitude_m;
}

void hold(Table& table)
{
  constexpr double spring_N_per_m = 2e4;
  const double mass_kg = test::Coupled(hand_N_per_m, spring_N_per_m).mass_kg();
  const double limit_N_per_m = 4.0 * mass_kg / (test::tickOfPath_s * test::tickOfPath_s) - spring_N_per_m;
  for (const double times : { 0.5, 0.98, 1.02, 10.0, 100.0 })
  {
    const std::string held = caseName({ { "stiffness", times } });
    const double stiffness_N_per_m = times * limit_N_per_m;
    const auto tell = [&](const char* method, bool diverges)
    {
      const Outcome outcome = diverges ? Outcome::Unstable : Outcome::Held;
      table.info({ held, method, "outcome", outcomeUnit }, static_cast<double>(outcome));
    };
    const double left = unsettled(stiffness_N_per_m, spring_N_per_m);
    table.atMost({ held, "ours", "off its rest after 3 s" }, left, 1e-6);
    tell("ours", left > 1.0);
    tell("explicit step", test::explodes(mass_kg, stiffness_N_per_m, spring_N_per_m));
  }
  // The formula of the explicit step's limit, so that the rows above are not read from one side only.
  table.within({ "limit", "explicit step", "diverges below and above" },
    (test::explodes(mass_kg, 0.98 * limit_N_per_m, spring_N_per_m) ? 1.0 : 0.0) +
      (test::explodes(mass_kg, 1.02 * limit_N_per_m, spring_N_per_m) ? 1.0 : 0.0),
    1.0, 0.0);
}

void swing(Table& table)
{
  constexpr double until_s = 0.16;
  const double truth_rad = test::pendulum_rad(until_s);
  double before_rad = 0.0;
  for (const double tick_s : { 1e-3, 5e-4, 2.5e-4, 1.25e-4 })
  {
    const std::string ticks = caseName({ { "tick_ms", 1e3 * tick_s } });
    const double off_rad = std::abs(test::swung(tick_s, until_s).angle_rad - truth_rad);
    table.atMost({ ticks, "ours", "pendulum off by", "rad" }, off_rad, 10.0 * tick_s);
    if (before_rad > 0.0)
    {
      table.within({ ticks, "ours", "nearer than with twice the tick" }, before_rad / off_rad, 2.0, 0.2);
    }
    before_rad = off_rad;
  }
}

} // namespace inertia_experiment

void runInertia(const Conditions& conditions, Table& table)
{
  inertia_experiment::shake(table);
  conditions.progress(0.4);
  inertia_experiment::hold(table);
  conditions.progress(0.8);
  inertia_experiment::swing(table);
}

} // namespace palpate::lab
