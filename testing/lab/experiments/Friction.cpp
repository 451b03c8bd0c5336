// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 23, 24 and 26: Coulomb friction of the trailing god-object beside friction smoothed in velocity and beside a
// cone around the averaged normal.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace friction_experiment
{

constexpr double K = 1000.0, depth_m = 2e-3; // N/m; scenes in metres
constexpr double T = 1e-3;
const char* const tanhName = "tanh-Coulomb";
constexpr double creepSpeed_m_per_s = 1e-3; ///< below it the smoothed law is a damper

struct Ours
{
  const char* name;
  double radius_m;
};
constexpr Ours pointAndBall[] = { { "god-object r=0", 0.0 }, { "god-object r=1mm", 1e-3 } };

/// The law without memory that avoids the jump at rest: friction against the direction of motion, mu F_n tanh(v / v0).
double tanhForce_N(double mu, double normal_N, double speed_m_per_s)
{
  return -mu * normal_N * std::tanh(speed_m_per_s / creepSpeed_m_per_s);
}

/// Where a predicate that holds near 0 and fails near `high` changes, to the last bit.
template<class Holds>
double threshold(double high, Holds holds)
{
  double low = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

test::Probe pressed(const std::shared_ptr<const Scene>& floor, const FrictionPlan& friction, double radius_m)
{
  test::Probe probe(floor, radius_m, { 0, 0, 0.01 + radius_m });
  probe.plan().friction = friction;
  probe.to({ 0, 0, radius_m - depth_m });
  return probe;
}

void breakAway(const std::shared_ptr<const Scene>& floor, const Ours& ours, Table& table)
{
  const FrictionPlan mu = { 0.5, 0.3 };
  const std::string name = "plane mu_s=0.5 mu_k=0.3";
  const double way_m = threshold(depth_m,
    [&](double tried_m)
    {
      test::Probe probe = pressed(floor, mu, ours.radius_m);
      return probe.to({ tried_m, 0, ours.radius_m - depth_m }).friction == FrictionState::Sticks;
    });
  table.within({ name, ours.name, "force at break-away", "N" }, K * way_m, mu.statical * K * depth_m, 1e-9);
  test::Probe probe = pressed(floor, mu, ours.radius_m);
  double wrong_N = 0.0;
  for (int i = 1; i <= 400; ++i)
  {
    const double to_m = 1e-5 * (i - 0.5); // between the steps lies the break-away
    probe.to({ to_m, 0, ours.radius_m - depth_m });
    const double sideways_N = to_m <= mu.statical * depth_m ? K * to_m : mu.kinetic * K * depth_m;
    wrong_N = std::max(wrong_N, (probe.force(K) - Vec3(-sideways_N, 0, K * depth_m)).norm());
  }
  table.atMost({ name, ours.name, "error of the force, sticking and sliding", "N" }, wrong_N, 1e-9);
}

/// A triangle wave of amplitude 1 that begins at 0: the device's path there and back.
double wave(double phase)
{
  return phase <= 1 ? phase : phase <= 3 ? 2 - phase : phase - 4;
}

/// Energy that a force takes from the hand in one loop, after a first one that only leads into it [J].
template<class ForceAt>
double loopEnergy_J(double amplitude_m, int quarter, ForceAt forceAt)
{
  double energy_J = 0.0, before_m = 0.0, before_N = 0.0;
  for (int i = 1; i <= 9 * quarter; ++i)
  {
    const double way_m = amplitude_m * wave(static_cast<double>(i % (4 * quarter)) / quarter);
    const double force_N = forceAt(way_m, way_m - before_m);
    energy_J -= i > 5 * quarter ? 0.5 * (force_N + before_N) * (way_m - before_m) : 0.0;
    before_m = way_m;
    before_N = force_N;
  }
  return energy_J;
}

void hysteresis(const std::shared_ptr<const Scene>& floor, int quarter, Table& table)
{
  const double mu = 0.3, amplitude_m = 5e-3;
  const std::string name = "plane mu=0.3 amplitude=5mm";
  const double truth_J = 4 * mu * K * depth_m * (amplitude_m - mu * depth_m);
  for (const Ours& ours : pointAndBall)
  {
    test::Probe probe = pressed(floor, { mu, mu }, ours.radius_m);
    const double energy_J = loopEnergy_J(amplitude_m, quarter,
      [&](double way_m, double)
      {
        probe.to({ way_m, 0, ours.radius_m - depth_m });
        return probe.force(K).x();
      });
    table.within({ name, ours.name, "energy of a loop", "J" }, energy_J, truth_J, 1e-6 * truth_J);
  }
  // It gives no spring back: too much by mu d / (A - mu d), 14 %, where it slides; where it creeps, far too little.
  for (const double share : { 5.0, 0.1 })
  {
    const double speed = share * creepSpeed_m_per_s;
    const double energy_J = loopEnergy_J(amplitude_m, quarter,
      [&](double, double step_m) { return tanhForce_N(mu, K * depth_m, std::copysign(speed, step_m)); });
    table.atLeast(
      { name + " speed=" + std::to_string(share).substr(0, 3) + "v0", tanhName, "error of the energy of a loop" },
      std::abs(energy_J / truth_J - 1), 0.13);
  }
}

constexpr double count_m = 50e-6, pull_m = 5e-3, inclineMu = 0.5;

/// A hand that pulls straight down on an object on an incline; how far that slides, and how far it has to [m].
struct Slide
{
  double moved_m = 0.0;
  double truth_m = 0.0;
};

Slide slideDown(double angle_rad, double radius_m, int ticks, std::uint64_t seed)
{
  test::Random random(seed);
  const Vec3 normal(std::sin(angle_rad), 0, std::cos(angle_rad));
  const auto scene = test::sceneOf(test::makePlane(normal, 0.2, 8, random));
  test::Probe probe(scene, radius_m, 0.01 * normal);
  probe.plan().friction = { inclineMu, inclineMu };
  probe.to(radius_m * normal - Vec3(0, 0, pull_m));
  const Vec3 start_W = probe.x_W();
  Slide slide;
  for (int i = 0; i < ticks; ++i)
  {
    // One count along the pull: the cone is about the direction of the pull.
    const double pulled_m = pull_m + (random.uniform() < 0.5 ? 0.0 : count_m);
    probe.to(probe.x_W() - Vec3(0, 0, pulled_m));
    slide.truth_m += pulled_m * std::max(0.0, std::sin(angle_rad) - inclineMu * std::cos(angle_rad));
  }
  slide.moved_m = (probe.x_W() - start_W).norm();
  return slide;
}

/// The same under noise from all sides, which turns the pull by up to half a degree.
double driftUnderNoise_m(double angle_rad, double radius_m, int ticks, std::uint64_t seed)
{
  test::Random random(seed);
  const Vec3 normal(std::sin(angle_rad), 0, std::cos(angle_rad));
  test::Probe probe(test::sceneOf(test::makePlane(normal, 0.2, 8, random)), radius_m, 0.01 * normal);
  probe.plan().friction = { inclineMu, inclineMu };
  const Vec3 pulled_W = radius_m * normal - Vec3(0, 0, pull_m);
  probe.to(pulled_W);
  const Vec3 start_W = probe.x_W();
  for (int i = 0; i < ticks; ++i)
  {
    probe.to(pulled_W + random.inCube(0.5 * count_m));
  }
  return (probe.x_W() - start_W).norm();
}

/// A mass of 100 g under the same pull with the smoothed law [m].
double tanhDrift_m(double angle_rad, int ticks)
{
  constexpr double mass_kg = 0.1;
  constexpr int substeps = 100; // the smoothed law is stiff: m v0 / (mu F_n) = 40 us
  double moved_m = 0.0, speed = 0.0;
  for (int i = 0; i < ticks * substeps; ++i)
  {
    const double down_N = K * pull_m * std::sin(angle_rad);
    const double friction_N = tanhForce_N(inclineMu, K * pull_m * std::cos(angle_rad), speed);
    speed += T / substeps * (down_N + friction_N) / mass_kg;
    moved_m += T / substeps * speed;
  }
  return moved_m;
}

void incline(int seconds, std::uint64_t seed, Table& table)
{
  constexpr double degree = std::numbers::pi / 180;
  const double limit_rad = std::atan(inclineMu), below_rad = limit_rad - 0.01 * degree;
  const int ticks = 1000 * seconds;
  for (const Ours& ours : pointAndBall)
  {
    table.within({ "incline=atan(mu)-0.01deg noise=1count", ours.name, "drift", "m" },
      slideDown(below_rad, ours.radius_m, ticks, seed).moved_m, 0.0, 0.0);
    table.within({ "incline=atan(mu)-1deg noise=1count any direction", ours.name, "drift", "m" },
      driftUnderNoise_m(limit_rad - degree, ours.radius_m, ticks, seed), 0.0, 0.0);
    const Slide above = slideDown(limit_rad + 0.01 * degree, ours.radius_m, ticks, seed);
    table.within({ "incline=atan(mu)+0.01deg noise=1count", ours.name, "slide", "m" }, above.moved_m, above.truth_m,
      1e-6 * above.truth_m);
  }
  // It creeps where the load is mu F_n tanh(v / v0).
  const double drift_m = seconds * creepSpeed_m_per_s * std::atanh(std::tan(below_rad) / inclineMu);
  const double moved_m = tanhDrift_m(below_rad, ticks);
  table.within({ "incline=atan(mu)-0.01deg", tanhName, "drift", "m" }, moved_m, drift_m, 0.05 * drift_m);
  table.atLeast({ "incline=atan(mu)-0.01deg", tanhName, "drift in a second", "m" }, moved_m / seconds, 1e-3);
}

/// Cone of the averaged normal: its radius is mu times the length of the resultant of all reactions.
bool averagedNormalSticks(double mu, const Vec3& offset_u, const Vec3& reaction_u)
{
  return offset_u.norm() <= mu * reaction_u.norm();
}

void corner(Table& table)
{
  // Floor z >= 0 and wall x >= 0: pressed into both by a and b the reactions are a and b; free along y.
  TriangleMesh mesh = test::makeBox({ 0, -0.5, -0.1 }, { 0.5, 0.5, 0.0 });
  append(mesh, test::makeBox({ -0.1, -0.5, -0.1 }, { 0.0, 0.5, 0.5 }));
  const auto scene = test::sceneOf(mesh);
  const double mu = 0.4, a_m = 3e-3, b_m = 2e-3, truth_m = mu * (a_m + b_m);
  const std::string name = "corner=90deg mu=0.4";
  for (const Ours& ours : pointAndBall)
  {
    const Vec3 pressed_W = Vec3(ours.radius_m - b_m, 0, ours.radius_m - a_m);
    const double found_m = threshold(0.01,
      [&](double way_m)
      {
        test::Probe probe(scene, ours.radius_m, { 0.01, 0, 0.01 });
        probe.plan().friction = { mu, mu };
        probe.to(pressed_W);
        probe.to(pressed_W); // arrived, at rest
        return probe.to(pressed_W + Vec3(0, way_m, 0)).friction == FrictionState::Sticks;
      });
    table.within({ name, ours.name, "threshold along the corner", "m" }, found_m, truth_m, 1e-6 * truth_m);
  }
  const double found_m = threshold(0.01,
    [&](double way_m) {
      return averagedNormalSticks(mu, { 0, way_m, 0 }, { b_m, 0, a_m });
    });
  table.within(
    { name, "averaged-normal", "threshold along the corner", "m" }, found_m, mu * std::hypot(a_m, b_m), 1e-6 * truth_m);
  table.atLeast({ name, "averaged-normal", "error of the threshold" }, std::abs(found_m / truth_m - 1), 0.25);
}

struct CostOfFriction
{
  Cost without, with;
};

/// Ticks without and with friction in turn over the same path, so that a change of the machine's pace meets both.
CostOfFriction costOfFriction(const Scene& scene, const test::NoisySphere& sphere, double radius_mm, int ticks)
{
  ContactPlan plain, rough;
  plain.radius_u = rough.radius_u = radius_mm;
  rough.friction = { 0.5, 0.3 };
  GodObjectState plainState, roughState;
  test::CostSample plainSample(static_cast<std::size_t>(ticks)), roughSample(static_cast<std::size_t>(ticks));
  (void)moveGodObject(scene, plain, test::slideStart_W(sphere), plainState);
  (void)moveGodObject(scene, rough, test::slideStart_W(sphere), roughState);
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 p_W = test::slideOver(sphere, static_cast<std::size_t>(i)).p_W;
    plainSample.time([&] { (void)moveGodObject(scene, plain, p_W, plainState); });
    roughSample.time([&] { (void)moveGodObject(scene, rough, p_W, roughState); });
  }
  return { Cost::of(plainSample), Cost::of(roughSample) };
}

/// The least of some measurements: other work of the machine only adds.
void cost(int ticks, Table& table)
{
  constexpr int measurements = 3;
  const test::NoisySphere sphere(100000, 1.0);
  const auto scene = test::sceneOf(sphere.mesh());
  for (const double radius_mm : { 0.0, 1.0 })
  {
    CostOfFriction least = costOfFriction(*scene, sphere, radius_mm, ticks);
    for (int i = 1; i < measurements; ++i)
    {
      const CostOfFriction again = costOfFriction(*scene, sphere, radius_mm, ticks);
      least.without = again.without.p50_us < least.without.p50_us ? again.without : least.without;
      least.with = again.with.p50_us < least.with.p50_us ? again.with : least.with;
    }
    const bool within = least.with.p50_us <= 1.3 * least.without.p50_us;
    const std::string name = caseName({ { "triangles", 1e5 }, { "r", radius_mm } });
    table.within({ name, "with friction", "p50 within 1.3 plain ticks" }, within, 1.0, 0.0).cost = least.with;
    table.info({ name, "plain", "ticks" }, ticks).cost = least.without;
  }
}

} // namespace friction_experiment

void runFriction(const Conditions& conditions, Table& table)
{
  using namespace friction_experiment;
  test::Random random(conditions.seed);
  const auto floor = test::sceneOf(test::makeSheet({ 0.4, 0.4, 20, 20, 0.3 }, random));
  for (const Ours& ours : pointAndBall)
  {
    breakAway(floor, ours, table);
  }
  hysteresis(floor, conditions.pick(2000, 20000, 20000), table);
  corner(table);
  conditions.progress(0.3);
  incline(conditions.pick(5, 60, 60), conditions.seed, table);
  conditions.progress(0.8);
  cost(conditions.pick(3000, 30000, 100000), table);
}

} // namespace palpate::lab
