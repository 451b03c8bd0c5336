// SPDX-License-Identifier: GPL-3.0-or-later
// Row 89: a pulse that brakes in the tick of an impact, and a transient that is added to the spring. The cost of each.
// A mass of 0.1 kg without damping, T = 1 ms.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/ExactLoops.h"
#include "testing/lab/simulation/InfiniteWalls.h"

namespace palpate::lab
{
namespace impact_walls_experiment
{

constexpr double T = 1e-3, m = 0.1, K = 1000.0, damped_Ns_per_m = 1.0;
constexpr double relative = 0.01;

/// A mass without damping that meets the wall at this speed, `share` of a tick before it is seen inside.
AtWall thrown(double speed_m_per_s, double share, double mass_kg)
{
  AtWall start;
  start.model = *deviceModel("simulated-ideal");
  start.model.mass_kg = mass_kg;
  start.speed_m_per_s = speed_m_per_s;
  start.x_m = -(2.0 - share) * speed_m_per_s * T; // seen before the wall twice, for there is a speed by then
  return start;
}

/// Runs to the first tick inside, and through it.
double firstTick_N(WallTicks& ticks)
{
  double force_N = 0.0;
  for (int tick = 0; tick < 10 && force_N == 0.0; ++tick)
  {
    force_N = ticks.tick();
  }
  return force_N;
}

/// A mass on a held spring from (x, v) on: its deepest place and the speed with which it leaves, by eigenvalues.
struct Visit
{
  double deepest_m = 0.0, leaves_m_per_s = 0.0;
};

Visit visitOf(const Eigen::Vector2d& start)
{
  // A matrix solves its own characteristic equation, so place and speed are sums of two powers of its eigenvalues.
  const Eigen::Matrix2d step = ExactStep::of(m, 0.0, T).onSpring(K);
  const Eigen::Vector2d next = step * start;
  const double middle = 0.5 * step.trace();
  const std::complex<double> apart = std::sqrt(std::complex<double>(middle * middle - step.determinant()));
  const std::complex<double> first = middle + apart, second = middle - apart;
  const auto after = [&](int component, double k)
  {
    const std::complex<double> from = start[component], to = next[component];
    return (((to - second * from) * std::pow(first, k) - (to - first * from) * std::pow(second, k)) / (2.0 * apart))
      .real();
  };
  Visit visit;
  for (int k = 0; k < 100000; ++k)
  {
    const Eigen::Vector2d now(after(0, k), after(1, k));
    visit.deepest_m = std::max(visit.deepest_m, now.x());
    if (now.x() <= 0.0)
    {
      visit.leaves_m_per_s = -now.y();
      break;
    }
  }
  return visit;
}

void judgePulse(double speed_m_per_s, double share, Table& table)
{
  const std::string name = caseName({ { "speed", speed_m_per_s }, { "share", share } });
  const double depth_m = share * speed_m_per_s * T;
  const double pulse_N = m * speed_m_per_s / T, spring_N = K * depth_m;
  WallTicks ticks(thrown(speed_m_per_s, share, m), BrakingWall{});
  const double felt_N = firstTick_N(ticks);
  table.within({ name, "braking pulse", "force of the first tick", "N" }, felt_N, spring_N + pulse_N, 1e-6);
  table.within({ name, "braking pulse", "speed after the pulse over that before" },
    ticks.speed_m_per_s() / speed_m_per_s, -spring_N * T / m / speed_m_per_s, 1e-6);
  const double ends_m = depth_m + speed_m_per_s * T - (spring_N + pulse_N) * T * T / (2 * m); // where the tick ends
  const Visit with = visitOf({ ends_m, -spring_N * T / m }), without = visitOf({ depth_m, speed_m_per_s });
  WallTicks plain(thrown(speed_m_per_s, share, m), IntegralWall{});
  double deepest_m = 0.0, plain_m = 0.0;
  for (int tick = 0; tick < 60; ++tick)
  {
    deepest_m = std::max(deepest_m, ticks.x_m());
    plain_m = std::max(plain_m, plain.x_m());
    ticks.tick();
    plain.tick();
  }
  table.within({ name, "braking pulse", "deepest place", "m" }, deepest_m, with.deepest_m, relative * with.deepest_m);
  table.within({ name, "spring", "deepest place", "m" }, plain_m, without.deepest_m, relative * without.deepest_m);
  table.within({ name, "spring", "speed of leaving over that of coming" }, -plain.speed_m_per_s() / speed_m_per_s,
    without.leaves_m_per_s / speed_m_per_s, relative);
  table.within({ name, "braking pulse", "speed of leaving over that of coming" },
    -ticks.speed_m_per_s() / speed_m_per_s, with.leaves_m_per_s / speed_m_per_s, relative);
  // Its cost: a click ten times as hard as the spring it belongs to, for a millisecond.
  const double own_N = K * without.deepest_m;
  table.within({ name, "braking pulse", "largest force over that of the spring" }, felt_N / (K * plain_m),
    (spring_N + pulse_N) / own_N, relative * (spring_N + pulse_N) / own_N);
}

/// A pulse is for the mass it knows: a hand's own goes on, and one that is less than believed is thrown back.
void judgeMass(Table& table)
{
  constexpr double speed_m_per_s = 0.1, share = 0.5;
  for (const double mass_kg : { 0.05, 0.1, 0.2, 0.4 })
  {
    WallTicks ticks(thrown(speed_m_per_s, share, mass_kg), BrakingWall{});
    firstTick_N(ticks);
    table.within({ caseName({ { "mass", mass_kg }, { "believed", m } }), "braking pulse",
                   "speed after the pulse over that before" },
      ticks.speed_m_per_s() / speed_m_per_s, 1.0 - m / mass_kg - K * share * T * T / mass_kg, 1e-6);
  }
}

/// No harder than the device can: the rest of the speed.
void judgeWeakPulse(Table& table)
{
  constexpr double share = 0.5, most_N = 5.0;
  for (const double speed_m_per_s : { 0.02, 0.1, 0.3 })
  {
    const double asked_N = m * speed_m_per_s / T + 1000.0 * share * speed_m_per_s * T;
    WallTicks ticks(thrown(speed_m_per_s, share, m), BrakingWall{ .most_N = most_N });
    firstTick_N(ticks);
    table.within({ caseName({ { "speed", speed_m_per_s }, { "force", most_N } }), "braking pulse",
                   "speed after the pulse over that before" },
      ticks.speed_m_per_s() / speed_m_per_s, 1.0 - std::min(asked_N, most_N) * T / m / speed_m_per_s, 1e-6);
  }
}

/// An encoder of D4 shows whole steps a tick, so a slow hand is braked as one of another speed: by up to D / T.
void judgeEncoder(Table& table)
{
  constexpr double step_m = 60e-6;
  double worst_m_per_s = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    AtWall start = thrown(0.02, (i + 0.5) / 64, m);
    start.model.encoderStep_m = step_m;
    WallTicks ticks(start, BrakingWall{ .stiffness_N_per_m = 0.0 });
    firstTick_N(ticks);
    worst_m_per_s = std::max(worst_m_per_s, std::fabs(ticks.speed_m_per_s()));
  }
  // 20 mm/s is no step a tick or one: 0 or 60 mm/s are taken away.
  table.within(
    { caseName({ { "step", step_m }, { "speed", 0.02 } }), "braking pulse", "largest speed after the pulse", "m/s" },
    worst_m_per_s, step_m / T - 0.02, 1e-6);
}

/// The impulse of a cosine that dies away, held from tick to tick: T A v Re 1 / (1 - q), q its step.
void judgeTransient(double frequency_Hz, Table& table)
{
  constexpr double speed_m_per_s = 0.1, share = 0.5;
  TransientWall wall{ .stiffness_N_per_m = 0.0, .frequency_Hz = frequency_Hz };
  const std::string name = caseName({ { "frequency", frequency_Hz } });
  const std::complex<double> q =
    std::exp(std::complex<double>(-1.0 / wall.decay_s, 2 * std::numbers::pi * frequency_Hz) * T);
  const double height_N = wall.height_Ns_per_m * speed_m_per_s, impulse_Ns = T * height_N * (1.0 / (1.0 - q)).real();
  WallTicks ticks(thrown(speed_m_per_s, share, m), wall);
  const double first_N = firstTick_N(ticks);
  table.within({ name, "transient", "force at first", "N" }, first_N, height_N, 1e-6);
  for (int tick = 0; tick < 300; ++tick)
  {
    ticks.tick();
  }
  table.within({ name, "transient", "impulse", "N s" }, m * (speed_m_per_s - ticks.speed_m_per_s()), impulse_Ns,
    relative * std::fabs(impulse_Ns));
  WallTicks plain(thrown(speed_m_per_s, share, m), IntegralWall{});
  double plain_m = 0.0;
  for (int tick = 0; tick < 60; ++tick)
  {
    plain.tick();
    plain_m = std::max(plain_m, plain.x_m());
  }
  const double truth = height_N / (K * visitOf({ share * speed_m_per_s * T, speed_m_per_s }).deepest_m);
  table.within({ name, "transient", "force at first over the spring's largest" }, first_N / (K * plain_m), truth,
    relative * truth);
}

/// Open loop, so it takes nothing from stability: does a small motion about where a push rests grow, or leave the wall?
bool growsBeside(double K)
{
  AtWall start;
  start.model = *deviceModel("simulated-generic");
  start.push_N = 2.0;
  const double rest_m = start.push_N / K;
  start.x_m = 0.9 * rest_m;
  WallTicks ticks(start, TransientWall{ .stiffness_N_per_m = K, .height_Ns_per_m = 0.2, .speed_m_per_s = 0.1 });
  double early = 0.0, late = 0.0;
  for (int tick = 0; tick < 4000; ++tick)
  {
    ticks.tick();
    if (!(ticks.x_m() > 0.0 && ticks.x_m() < 2 * rest_m))
    {
      return true;
    }
    const double square = ticks.speed_m_per_s() * ticks.speed_m_per_s();
    early += tick >= 200 && tick < 1000 ? square : 0.0;
    late += tick >= 3200 ? square : 0.0;
  }
  return late > early * 1.001;
}

void judgeTransientStability(Table& table)
{
  const ExactStep step = ExactStep::of(m, damped_Ns_per_m, T);
  const double exact = threshold([&step](double K) { return spectralRadius(step.onSpring(K)) > 1.0 + 1e-12; }, 1e-9);
  table.within(
    { "damping=1", "transient", "stiffest wall", "N/m" }, threshold(growsBeside, 1e-3), exact, relative * exact);
}

/// Neither acts on a hand that touches nothing.
void judgeFreeAir(Table& table)
{
  const auto drag_N = [](const WallLaw& law)
  {
    AtWall start;
    start.model = *deviceModel("simulated-ideal");
    start.x_m = -0.5;
    start.speed_m_per_s = 0.1;
    WallTicks ticks(start, law);
    double most_N = 0.0;
    for (int tick = 0; tick < 4000; ++tick)
    {
      most_N = std::max(most_N, std::fabs(ticks.tick()));
    }
    return most_N;
  };
  table.atMost(
    { "speed=0.1", "integral wall", "force in free air", "N" }, drag_N(IntegralWall{ .integral_N_per_ms = 2500 }), 0.0);
  table.atMost({ "speed=0.1", "braking pulse", "force in free air", "N" }, drag_N(BrakingWall{}), 0.0);
  table.atMost({ "speed=0.1", "transient", "force in free air", "N" }, drag_N(TransientWall{}), 0.0);
}

} // namespace impact_walls_experiment

void runImpactWalls(const Conditions& conditions, Table& table)
{
  using namespace impact_walls_experiment;
  for (const double speed_m_per_s : { 0.02, 0.1, 0.3 })
  {
    for (const double share : { 0.1, 0.5, 0.9 })
    {
      judgePulse(speed_m_per_s, share, table);
    }
    conditions.progress(speed_m_per_s);
  }
  judgeMass(table);
  judgeWeakPulse(table);
  judgeEncoder(table);
  for (const double frequency_Hz : { 50.0, 125.0, 250.0 })
  {
    judgeTransient(frequency_Hz, table);
  }
  judgeTransientStability(table);
  judgeFreeAir(table);
}

} // namespace palpate::lab
