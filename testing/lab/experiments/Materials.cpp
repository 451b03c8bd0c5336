// SPDX-License-Identifier: GPL-3.0-or-later
// Row 27 for surfaces that change along the path, and the felt share of data: stiffness and texture given at the
// vertices, beside a wall in series with the coupling, a stiffness cut off at the vertices, one without a slope, a
// turned normal, a texture that stands out of the contact surface, and three other limits of a texture's speed.
//
// The truth is the energy V = k(x) max(0, d - c(x))^2 / 2 of a wall that is pressed d deep over hollows c: its force is
// -grad V, and no closed path does work. K = 1000 N/m; scenes in metres.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace materials_experiment
{

constexpr double K = 1000.0, T = 1e-3, pi = std::numbers::pi;
constexpr double soft_N_per_m = 200.0, hard_N_per_m = 1000.0, length_m = 0.04, width_m = 0.004, cell_m = 1e-4;
constexpr double bump_m = 2e-4, wave_m = 2e-3;
constexpr const char* ours = "god-object r=0";

using Field = std::function<double(double x)>;

double wall(double x)
{
  return soft_N_per_m + (hard_N_per_m - soft_N_per_m) * (x / length_m + 0.5);
}

constexpr double wallSlope = (hard_N_per_m - soft_N_per_m) / length_m;

double bump(double x)
{
  return 0.5 * bump_m * (1.0 - std::cos(2 * pi * x / wave_m));
}

/// A strip along x with values at its vertices.
std::shared_ptr<const Scene> strip(
  const Conditions& conditions, const Field& stiffness, const Field& height, double side_m = cell_m)
{
  test::Random random(conditions.seed);
  const auto cells = [side_m](double way_m) { return std::max(1, static_cast<int>(std::lround(way_m / side_m))); };
  auto mesh = std::make_shared<TriangleMesh>(
    test::makeSheet({ length_m, width_m, cells(length_m), cells(width_m), 0.0 }, random));
  auto fields = std::make_shared<MaterialFields>();
  for (const Vec3& v : mesh->vertices_W)
  {
    if (stiffness)
    {
      fields->stiffness_N_per_m.push_back(stiffness(v.x()));
    }
    if (height)
    {
      fields->height_u.push_back(height(v.x()));
    }
  }
  return SceneBuilder().build({ { "strip", mesh, Material(), fields } }).scene;
}

test::Probe above(const std::shared_ptr<const Scene>& scene, double x)
{
  test::Probe probe(scene, 0.0, { x, 0, 0.01 });
  probe.plan().coupling_N_per_m = K;
  return probe;
}

void feltStiffness(const Conditions& conditions, Table& table)
{
  test::Probe probe = above(strip(conditions, wall, nullptr), 0.0);
  test::Random random(conditions.seed);
  double wrong = 0.0, wrongInSeries = 0.0;
  for (int i = 0; i < conditions.pick(200, 2000, 20000); ++i)
  {
    const double x = random.uniform(-0.49, 0.49) * length_m, d = random.uniform(1e-4, 2e-3);
    const Vec3 force_N = K * probe.to({ x, 0, -d }).pull_W, truth_N = { -0.5 * d * d * wallSlope, 0, wall(x) * d };
    wrong = std::max(wrong, (force_N - truth_N).norm());
    wrongInSeries = std::max(wrongInSeries, 1.0 - K / (K + wall(x)));
  }
  const std::string name = "wall=200..1000 N/m";
  table.atMost({ name, ours, "error of the force", "N" }, wrong, 1e-9);
  // A wall of the data's stiffness behind the coupling is felt as K k / (K + k): at k = K as half of it.
  table.atLeast({ name, "in series with the coupling", "error of the felt stiffness" }, wrongInSeries, 0.45);
}

/// Two cells along the strip, so that the data are beyond the coupling's stiffness at two of three vertices.
void rampBeyond(const Conditions& conditions, Table& table)
{
  constexpr double least = 100.0, slope = 4900.0 / length_m;
  const auto ramp = [](double x) { return least + slope * (x + 0.5 * length_m); };
  const auto cutOff = [](double x)
  { return x < 0.0 ? least + (K - least) * (x / (0.5 * length_m) + 1.0) : K; }; // between the vertices: linear
  test::Probe probe = above(strip(conditions, ramp, nullptr, 0.5 * length_m), 0.0);
  test::Random random(conditions.seed);
  double wrong_N = 0.0, wrongCutOff = 0.0;
  for (int i = 0; i < conditions.pick(200, 2000, 20000); ++i)
  {
    const double x = random.uniform(-0.49, 0.49) * length_m, d = random.uniform(1e-4, 2e-3);
    const bool soft = ramp(x) < K;
    const Vec3 truth_N(soft ? -0.5 * d * d * slope : 0.0, 0, std::min(K, ramp(x)) * d);
    wrong_N = std::max(wrong_N, (K * probe.to({ x, 0, -d }).pull_W - truth_N).norm());
    wrongCutOff = std::max(wrongCutOff, 1.0 - cutOff(x) / std::min(K, ramp(x)));
  }
  const std::string name = "wall=100..5000 N/m";
  table.atMost({ name, ours, "error of the force", "N" }, wrong_N, 1e-9);
  table.atLeast({ name, "cut off at the vertices", "error of the felt stiffness" }, wrongCutOff, 0.45);
}

constexpr double shallow_m = 5e-4, deep_m = 2e-3;

/// Between which depths a loop goes; below 0 is air.
struct Depths
{
  double least_m = shallow_m, most_m = deep_m;
};

/// In at `from`, along to `to`, out there, and back: the force in the middle of each step times the step, which is
/// exact where the force is linear over it.
template<class ForceAt>
double loopWork_J(double from, double to, int stepsPerSide, ForceAt forceAt, const Depths& depths = {})
{
  const Vec3 corners_W[] = { { from, 0, -depths.least_m }, { from, 0, -depths.most_m }, { to, 0, -depths.most_m },
    { to, 0, -depths.least_m } };
  double work_J = 0.0;
  for (int side = 0; side < 4; ++side)
  {
    const Vec3 step_m = (corners_W[(side + 1) % 4] - corners_W[side]) / stepsPerSide;
    for (int i = 0; i < stepsPerSide; ++i)
    {
      work_J += Vec3(forceAt(Vec3(corners_W[side] + (i + 0.5) * step_m))).dot(step_m);
    }
  }
  return work_J;
}

double ourWork_J(
  const std::shared_ptr<const Scene>& scene, double from, double to, int stepsPerSide, const Depths& depths = {})
{
  test::Probe probe = above(scene, from);
  (void)probe.along({ from, 0, -depths.least_m }, 100);
  return loopWork_J(
    from, to, stepsPerSide, [&probe](const Vec3& p_W) -> Vec3 { return K * probe.to(p_W).pull_W; }, depths);
}

void closedWays(const Conditions& conditions, Table& table)
{
  const double from = -0.4 * length_m, to = -from, area2_m2 = deep_m * deep_m - shallow_m * shallow_m;
  // Both sides along x are cut where cells end, so that the field is linear over every step.
  const int steps = static_cast<int>(std::lround(2 * to / cell_m)) * conditions.pick(2, 10, 40);
  const std::string ramp = "in where it is soft, out where it is hard";
  table.within(
    { ramp, ours, "work of a loop", "J" }, ourWork_J(strip(conditions, wall, nullptr), from, to, steps), 0.0, 1e-9);
  const double gain_J = 0.5 * (wall(to) - wall(from)) * area2_m2;
  const double without_J =
    loopWork_J(from, to, steps, [](const Vec3& p_W) { return Vec3(0, 0, -wall(p_W.x()) * p_W.z()); });
  table.within({ ramp, "stiffness without its slope", "work of a loop", "J" }, without_J, gain_J, 1e-9);
  table.atLeast(
    { ramp, "stiffness without its slope", "energy a hand is given in a loop", "J" }, without_J, 0.5 * gain_J);

  const int bumpSteps = conditions.pick(200, 1000, 4000); // half a wave is ten cells
  const std::string waves = "over a bump of 0.2 mm, back deeper";
  table.within({ waves, ours, "work of a loop", "J" },
    ourWork_J(strip(conditions, nullptr, bump), 0.0, wave_m / 2, bumpSteps), 0.0, 1e-9);
  const double turned_J = loopWork_J(wave_m / 2, 0.0, bumpSteps,
    [](const Vec3& p_W)
    {
      const double slope = bump_m * pi / wave_m * std::sin(2 * pi * p_W.x() / wave_m);
      return Vec3(-K * p_W.z() * Vec3(-slope, 0, 1));
    });
  const double truth_J = K * (deep_m - shallow_m) * bump_m;
  table.within({ waves, "turned normal", "work of a loop", "J" }, turned_J, truth_J, 1e-3 * truth_J);
  table.atLeast({ waves, "turned normal", "energy a hand is given in a loop", "J" }, turned_J, 0.5 * truth_J);
}

/// From the air in on the top of a bump, out where it ends, and back through the air.
void touchAndLeave(const Conditions& conditions, Table& table)
{
  const auto scene = strip(conditions, nullptr, bump);
  const int steps = conditions.pick(200, 1000, 4000);
  for (const double most_m : { 0.5 * bump_m, 4 * bump_m })
  {
    const Depths depths{ -bump_m, most_m };
    const std::string name = caseName({ { "in on a bump, out beside it, depth over its height", most_m / bump_m } });
    // Over the step in which a hollow ends the force is not linear.
    const double step_m = std::max({ wave_m / 2, bump_m + most_m }) / steps;
    table.within({ name, ours, "work of a loop", "J" }, ourWork_J(scene, wave_m / 2, 0.0, steps, depths), 0.0,
      K * step_m * step_m);
    const auto standsOut = [](const Vec3& p_W)
    {
      const double slope = bump_m * pi / wave_m * std::sin(2 * pi * p_W.x() / wave_m);
      return p_W.z() < 0.0 ? Vec3(K * (bump(p_W.x()) - p_W.z()) * Vec3(-slope, 0, 1)) : Vec3(Vec3::Zero());
    };
    const double truth_J = 0.5 * K * bump_m * bump_m, naive_J = loopWork_J(wave_m / 2, 0.0, steps, standsOut, depths);
    table.within({ name, "texture stands out", "work of a loop", "J" }, naive_J, truth_J, 1e-2 * truth_J);
    table.atLeast({ name, "texture stands out", "energy a hand is given in a loop", "J" }, naive_J, 0.5 * truth_J);
  }
}

/// Slowly in beside a bump, along at four ticks a wave, slowly out on the top of another: the work of forceAt [J].
template<class ForceAt>
double strokeWork_J(int slowSteps, ForceAt forceAt)
{
  constexpr int fastSteps = 6;
  constexpr double to = 1.5 * wave_m;
  double work_J = 0.0;
  const auto lead = [&](const Vec3& from_W, const Vec3& to_W, int steps)
  {
    const Vec3 step_m = (to_W - from_W) / steps;
    for (int i = 0; i < steps; ++i)
    {
      work_J += Vec3(forceAt(Vec3(from_W + (i + 0.5) * step_m), steps == fastSteps)).dot(step_m);
    }
  };
  lead({ 0, 0, deep_m }, { 0, 0, -deep_m }, slowSteps);
  lead({ 0, 0, -deep_m }, { to, 0, -deep_m }, fastSteps);
  lead({ to, 0, -deep_m }, { to, 0, deep_m }, slowSteps);
  return work_J;
}

void slowInFastAlong(const Conditions& conditions, Table& table)
{
  const int slowSteps = conditions.pick(2000, 10000, 40000);
  test::Probe probe = above(strip(conditions, nullptr, bump), 0.0);
  (void)probe.to({ 0, 0, deep_m });
  const double ours_J =
    strokeWork_J(slowSteps, [&probe](const Vec3& p_W, bool) -> Vec3 { return K * probe.to(p_W).pull_W; });
  const double alone_J = strokeWork_J(slowSteps,
    [](const Vec3& p_W, bool fast)
    {
      const double hollow_m = fast ? 0.5 * bump_m : bump_m - bump(p_W.x()); // at its mean it has no slope
      return Vec3(0, 0, K * std::max(0.0, -p_W.z() - hollow_m));
    });
  const std::string name = "slowly in beside a bump, fast along, slowly out on one";
  const double step_m = 2 * deep_m / slowSteps, gain_J = 0.5 * K * (deep_m * deep_m - std::pow(deep_m - bump_m, 2));
  table.atMost({ name, ours, "work of a loop", "J" }, ours_J, K * step_m * step_m);
  table.within({ name, "share by speed alone", "work of a loop", "J" }, alone_J, gain_J, 1e-3 * gain_J);
  table.atLeast({ name, "share by speed alone", "energy a hand is given in a loop", "J" }, alone_J, 0.5 * gain_J);
}

/// The felt share of a texture, by least squares, on a slide of so many ticks a wave.
double shareFelt(const std::shared_ptr<const Scene>& scene, double ticksAWave)
{
  constexpr double d = 1e-3;
  const double step_m = wave_m / ticksAWave, mean_m = 0.5 * bump_m;
  double x = -0.45 * length_m;
  test::Probe probe = above(scene, x);
  probe.to({ x - step_m, 0, -d });
  double product = 0.0, square = 0.0;
  for (; x < 0.45 * length_m; x += step_m)
  {
    const double felt_m = probe.to({ x, 0, -d }).pull_W.z() - d + bump_m - mean_m, there_m = bump(x) - mean_m;
    product += felt_m * there_m;
    square += there_m * there_m;
  }
  return product / square;
}

/// None of a texture whose period is less than five ticks, all of it from ten on.
double shareOf(double ticks)
{
  return std::clamp(ticks / 5.0 - 1.0, 0.0, 1.0);
}

/// Of the force of the texture as it lies there, by its crossings of the mean: two a wave.
double frequency_Hz(double ticksAWave)
{
  constexpr int ticks = 1000;
  int crossings = 0;
  for (int i = 0; i < ticks; ++i)
  {
    const auto isHigh = [=](int tick) { return bump(tick * wave_m / ticksAWave) > 0.5 * bump_m; };
    crossings += isHigh(i) != isHigh(i + 1) ? 1 : 0;
  }
  return crossings / (2.0 * ticks * T);
}

void speedOfTexture(const Conditions& conditions, Table& table)
{
  const auto scene = strip(conditions, nullptr, bump);
  for (const double ticks : { 40.0, 12.3, 9.1, 7.3, 6.1, 4.9, 3.1 })
  {
    const std::string name = caseName({ { "ticks-a-wave", ticks } });
    table.within({ name, ours, "share of the texture felt" }, shareFelt(scene, ticks), shareOf(ticks), 0.02);
  }
  table.atLeast(
    { caseName({ { "ticks-a-wave", 3.1 } }), "texture at any speed", "frequency of the force over 1 / (5 T)" },
    frequency_Hz(3.1) / (1.0 / (5.0 * T)), 1.5);
  // The mesh alone does not say how long a wave is: twenty cells make this one.
  const double grainTicks = 2 * cell_m / (wave_m / 40.0);
  table.atLeast(
    { caseName({ { "ticks-a-wave", 40.0 } }), "limit from the mesh", "share of a slow texture that is lost" },
    shareOf(40.0) - shareOf(grainTicks), 0.5);
}

} // namespace materials_experiment

void runMaterials(const Conditions& conditions, Table& table)
{
  using namespace materials_experiment;
  feltStiffness(conditions, table);
  rampBeyond(conditions, table);
  conditions.progress(0.2);
  closedWays(conditions, table);
  touchAndLeave(conditions, table);
  slowInFastAlong(conditions, table);
  conditions.progress(0.8);
  speedOfTexture(conditions, table);
  conditions.progress(1.0);
}

} // namespace palpate::lab
