// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 46 and 47 through the whole session: a plane world on a joystick that holds its walls, behind a host at 20 to
// 1000 Hz, and a hand in space that is led to the plane.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "haptics/force/Guide.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/PlaneGame.h"
#include "testing/support/Meshes.h"
#include "testing/support/PlainJoystick.h"

namespace palpate::lab
{
namespace played_walls_experiment
{

/// A handle pushed with f squarely against a line at 45 degrees rests f / K behind it. Heavy, so that it is still
/// before the line when a slow host looks for the first time, and critically damped.
void judgeRest(double rate_Hz, Table& table)
{
  PlaneGameSetup game;
  constexpr double push_N = 0.5;
  const double half = std::sqrt(0.5);
  game.model = test::plainJoystick(2 * std::sqrt(game.stiffness_N_per_m));
  game.model.mass_kg = 1.0;
  game.curves = { { { -0.04, 0.038 }, { 0.04, -0.042 } }, { { 0, 1 } } }; // x + y = -2 mm
  game.rate_Hz = rate_Hz;
  game.push_D = -push_N * Vec3(half, half, 0);
  PlaneGame play(game);
  for (int i = 0; i < static_cast<int>(4 * rate_Hz); ++i)
  {
    play.step();
  }
  const double truth_m = 0.002 * half + push_N / game.stiffness_N_per_m;
  table.within({ caseName({ { "host", rate_Hz } }), "walls held by the device", "rest below the start", "m" },
    -play.device().position_D().dot(Vec3(half, half, 0)), truth_m, 1e-5);
}

constexpr double halfWidth_m = 0.002;

/// How a throw ended: of the last tenth of 5 s.
struct Ending
{
  double speed_m_per_s = 0.0;
  double reach_m = 0.0; ///< from the middle
};

Ending thrown(double speed_m_per_s, double rate_Hz, Closed closed)
{
  PlaneGameSetup game;
  game.model = test::plainJoystick(0.05);
  const double w = halfWidth_m;
  game.curves = { { { -0.04, w }, { 0.04, w }, { -0.04, -w }, { 0.04, -w } }, { { 0, 1 }, { 2, 3 } } };
  game.stiffness_N_per_m = 2000.0;
  game.rate_Hz = rate_Hz;
  game.closed = closed;
  game.velocity_D = Vec3(0, speed_m_per_s, 0);
  PlaneGame play(game);
  Ending ending;
  const int ticks = static_cast<int>(5 * rate_Hz);
  for (int i = 0; i < ticks; ++i)
  {
    play.step();
    if (10 * i >= 9 * ticks)
    {
      ending.speed_m_per_s = std::max(ending.speed_m_per_s, play.device().speed_D().norm());
      ending.reach_m = std::max(ending.reach_m, std::fabs(play.device().position_D().y()));
    }
  }
  return ending;
}

void judgeCorridor(double rate_Hz, Table& table)
{
  // Still between the walls when a slow host looks for the first time.
  const double speed_m_per_s = std::min(0.1, 0.5 * halfWidth_m * rate_Hz);
  const std::string name = caseName({ { "host", rate_Hz }, { "b", 0.05 }, { "speed", speed_m_per_s } });
  table.atMost({ name, "walls held by the device, viscosity found", "speed after 4.5 s over the first" },
    thrown(speed_m_per_s, rate_Hz, Closed::ByDevice).speed_m_per_s / speed_m_per_s, 0.1);
  table.atLeast({ name, "walls closed by the host", "reach after 4.5 s over half the corridor" },
    thrown(speed_m_per_s, rate_Hz, Closed::ByHost).reach_m / halfWidth_m, 2.0);
}

/// A hand 10 mm behind a line when its wall first stands: the largest step of the force.
double largestStep(double maxRise_N_per_s, double every_s)
{
  const auto scene = test::sceneOf(raiseWalls({ { { -0.04, 0 }, { 0.04, 0 } }, { { 0, 1 } } }, 0.01));
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 200.0;
  parameters.safety = SafetyLimits::none();
  parameters.safety.maxRise_N_per_s = maxRise_N_per_s;
  parameters.walls.every_s = every_s;
  RendererState state;
  TickInput input;
  input.scene = scene.get();
  input.sample.pose_D.p = Vec3(0, 0.01, 0);
  static_cast<void>(renderTick(input, parameters, state));
  parameters.walls.hold = true;
  input.sample.pose_D.p = Vec3(0, -0.01, 0);
  double before_N = 0.0, step_N = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double now_N = renderTick(input, parameters, state).state.force_D.y();
    step_N = std::max(step_N, now_N - before_N);
    before_N = now_N;
  }
  return step_N;
}

void judgeRise(Table& table)
{
  constexpr double rise_N_per_s = 20.0, infinite = std::numeric_limits<double>::infinity();
  for (const double every_s : { 0.001, 0.008, 0.05 })
  {
    const std::string name = caseName({ { "every", every_s } });
    const double allowed_N = rise_N_per_s * every_s;
    table.atMost({ name, "led into the hand", "largest step of the force", "N" }, largestStep(rise_N_per_s, every_s),
      allowed_N * (1 + 1e-9));
    table.atLeast({ name, "set at once", "largest step of the force", "N" }, largestStep(infinite, every_s), 1.9);
  }
}

/// Work of the guide's force, held for a period, on a hand that goes up and down through the plane for 10 s.
double guideWork_J(double damped, double speed_Hz)
{
  constexpr double T = 1e-3, swing_m = 0.005;
  const GuidePlan plan;
  const auto height = [&](int i) { return swing_m * std::sin(2 * std::numbers::pi * speed_Hz * T * i); };
  double work_J = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const double speed = damped * (height(i) - height(i - 1)) / T;
    work_J += guideForce(plan, 1.0, height(i), speed, T) * (height(i + 1) - height(i));
  }
  return work_J;
}

/// Held forces of an undamped spring leak K w^2 T / 2 a step of length w: K A^2 (2 pi f)^2 T t / 4 for a swing. The
/// guide's damping K T takes that back and as much again.
void judgeGuide(Table& table)
{
  constexpr double T = 1e-3, swing_m = 0.005, time_s = 10.0;
  for (const double speed_Hz : { 0.5, 2.0 })
  {
    const std::string name = caseName({ { "swing", speed_Hz } });
    const double w = 2 * std::numbers::pi * speed_Hz;
    const double leak_J = GuidePlan().stiffness_N_per_m * swing_m * swing_m * w * w * T * time_s / 4;
    const double held = guideWork_J(0.0, speed_Hz), guide = guideWork_J(1.0, speed_Hz);
    table.within({ name, "held spring", "work on a closed way", "J" }, held, leak_J, 0.01 * leak_J);
    table.within({ name, "guide", "work on a closed way over a held spring's" }, guide / leak_J, -1.0, 0.01);
  }
}

} // namespace played_walls_experiment

void runPlayedWalls(const Conditions& conditions, Table& table)
{
  using namespace played_walls_experiment;
  for (const double rate_Hz : { 20.0, 50.0, 125.0, 1000.0 })
  {
    judgeRest(rate_Hz, table);
    judgeCorridor(rate_Hz, table);
    conditions.progress(0.9 * std::min(1.0, rate_Hz / 1000.0));
  }
  judgeRise(table);
  judgeGuide(table);
}

} // namespace palpate::lab
