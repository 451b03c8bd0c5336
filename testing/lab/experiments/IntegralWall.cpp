// SPDX-License-Identifier: GPL-3.0-or-later
// Row 89: a wall with an integral of the depth, which walks a pressing hand back to its surface. Device D1: m = 0.1 kg,
// b = 1 N s/m, T = 1 ms.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/ExactLoops.h"
#include "testing/lab/simulation/InfiniteWalls.h"

namespace palpate::lab
{
namespace integral_wall_experiment
{

constexpr double T = 1e-3, m = 0.1, b = 1.0;
constexpr double relative = 0.01;

/// Place, speed and integral from tick to tick under u = -K x - K_i T (x + sum).
Eigen::Matrix3d integralLoop(double K, double Ki)
{
  const ExactStep step = ExactStep::of(m, b, T);
  const Eigen::RowVector3d u(-K - Ki * T, 0.0, -Ki);
  Eigen::Matrix3d loop = Eigen::Matrix3d::Zero();
  loop.topLeftCorner<2, 2>() = step.free;
  loop.topRows<2>() += step.held * u;
  loop.row(2) << T, 0.0, 1.0;
  return loop;
}

double exactIntegral(double K)
{
  return threshold([K](double Ki) { return spectralRadius(integralLoop(K, Ki)) > 1.0 + 1e-12; }, 1e-9);
}

AtWall pushed(double push_N)
{
  AtWall start;
  start.model = *deviceModel("simulated-generic");
  start.push_N = push_N;
  return start;
}

/// Does a small motion about a wall that holds both sides grow? Judged by the speeds of the first second and the
/// fourth.
bool grows(double K, double Ki)
{
  AtWall start = pushed(0.0);
  start.x_m = 1e-3;
  WallTicks ticks(start, IntegralWall{ .stiffness_N_per_m = K, .integral_N_per_ms = Ki, .bothSides = true });
  double early = 0.0, late = 0.0;
  for (int tick = 0; tick < 4000; ++tick)
  {
    ticks.tick();
    const double square = ticks.speed_m_per_s() * ticks.speed_m_per_s();
    early += tick < 1000 ? square : 0.0;
    late += tick >= 3000 ? square : 0.0;
    if (!(square < 1e12))
    {
      return true;
    }
  }
  return late > early * 1.001;
}

void judgeLimit(double K, Table& table)
{
  const std::string name = caseName({ { "stiffness", K } });
  const double exact = exactIntegral(K), formula = (b - K * T / 2) * K / m;
  const double found = threshold([K](double Ki) { return grows(K, Ki); }, 1e-3);
  table.within({ name, "integral wall", "largest K_i", "N/(m s)" }, found, exact, relative * exact);
  table.within({ name, "formula (b - K T / 2) K / m", "largest K_i", "N/(m s)" }, formula, exact, relative * exact);
  table.within({ name, "integral wall", "time to walk a hand back at the limit", "s" }, K / found, K / exact,
    relative * K / exact);
}

/// A hand that pushes with 1 N: its depth falls by e in K / K_i.
void judgeWalk(double K, Table& table)
{
  const double Ki = 0.1 * exactIntegral(K);
  const std::string name = caseName({ { "stiffness", K }, { "integral", std::round(Ki) } });
  AtWall start = pushed(1.0);
  start.x_m = start.push_N / K; // where the spring alone would hold it
  WallTicks ticks(start, IntegralWall{ .stiffness_N_per_m = K, .integral_N_per_ms = std::round(Ki) });
  const int first = static_cast<int>(K / Ki / T), last = 3 * first;
  double early_m = 0.0;
  for (int tick = 1; tick <= 12 * first; ++tick)
  {
    ticks.tick();
    early_m = tick == first ? ticks.x_m() : early_m;
    if (tick == last)
    {
      const double time_s = (last - first) * T / std::log(early_m / ticks.x_m());
      const double slowest = spectralRadius(integralLoop(K, std::round(Ki)));
      table.within(
        { name, "integral wall", "time to walk a hand back", "s" }, time_s, -T / std::log(slowest), relative * time_s);
      table.within(
        { name, "formula K / K_i", "time to walk a hand back", "s" }, K / std::round(Ki), time_s, relative * time_s);
    }
  }
  table.atMost(
    { name, "integral wall", "depth after 12 of these times over that of the spring" }, ticks.x_m() * K, 1e-3);
}

/// Work on a hand that swings within the wall, a whole turn at 3 mm + 2 mm sin(w t). The held spring leaks
/// pi A^2 K w T / 2 a turn; the integral, a quarter of a turn late, gives pi A^2 K_i / w besides.
double workOfATurn(double K, double Ki, int ticksATurn)
{
  constexpr double middle_m = 3e-3, swing_m = 2e-3;
  IntegralWall wall{ .stiffness_N_per_m = K, .integral_N_per_ms = Ki, .most_N = 1e9 };
  const auto depth_m = [=](int i) { return middle_m + swing_m * std::sin(2 * std::numbers::pi * i / ticksATurn); };
  double work_J = 0.0;
  for (int i = 0; i < ticksATurn; ++i)
  {
    work_J -= wall(depth_m(i)) * (depth_m(i + 1) - depth_m(i));
  }
  return work_J;
}

void judgeSwing(double Ki, int ticksATurn, Table& table)
{
  constexpr double K = 1000.0, swing_m = 2e-3;
  const double w = 2 * std::numbers::pi / (ticksATurn * T);
  const std::string name = caseName({ { "frequency", 1.0 / (ticksATurn * T) }, { "integral", Ki } });
  const std::string method = Ki > 0.0 ? "integral wall" : "spring";
  const double work_J = workOfATurn(K, Ki, ticksATurn);
  const double truth_J = std::numbers::pi * swing_m * swing_m * (Ki / w + K * w * T / 2);
  table.within({ name, method, "work on the hand a turn", "J" }, work_J, truth_J, relative * truth_J);
  // A damper takes pi A^2 w B a turn.
  const double damping = work_J / (std::numbers::pi * swing_m * swing_m * w), damping_truth = Ki / (w * w) + K * T / 2;
  table.within(
    { name, method, "damping the hand has to bring", "N s/m" }, damping, damping_truth, relative * damping_truth);
}

/// It does nothing to a hand that touches nothing, nor once it has leaked.
void judgeFreeAir(Table& table)
{
  AtWall start = pushed(0.0);
  start.x_m = -0.1;
  start.speed_m_per_s = 0.1;
  WallTicks ticks(start, IntegralWall{ .integral_N_per_ms = 2500.0, .integral_N = 1.0 });
  double most_N = 0.0;
  for (int tick = 0; tick < 500; ++tick)
  {
    most_N = std::max(most_N, std::fabs(ticks.tick()));
  }
  table.atMost({ "speed=0.1", "integral wall", "force in free air", "N" }, most_N, 0.0);
}

} // namespace integral_wall_experiment

void runIntegralWall(const Conditions& conditions, Table& table)
{
  using namespace integral_wall_experiment;
  for (const double K : { 500.0, 750.0, 1000.0, 1250.0, 1500.0 })
  {
    judgeLimit(K, table);
    judgeWalk(K, table);
    conditions.progress(K / 2000.0);
  }
  for (const int ticksATurn : { 2000, 1000, 500, 250, 100 })
  {
    for (const double Ki : { 0.0, 500.0, 2500.0 })
    {
      judgeSwing(Ki, ticksATurn, table);
    }
  }
  judgeFreeAir(table);
}

} // namespace palpate::lab
