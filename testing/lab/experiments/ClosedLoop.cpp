// SPDX-License-Identifier: GPL-3.0-or-later
// Row 27: the energy that a hand gets out of a closed loop.
//
// Where the free space is convex the god-object is the nearest free point, so the force of the spring is the negative
// gradient of V = K d^2 / 2, convex and with a gradient that changes by at most K a metre. A force held over a step s
// then does between 0 and K |s|^2 / 2 more work than V falls by: in a loop between 0 and K v T / 2 times its length.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace closed_loop_experiment
{

constexpr double K = 1000.0, pi = std::numbers::pi; // N/m; scenes in metres

/// A loop of so many steps, sampled: in and out of every wall of a box of 50 mm along each axis, up to 15 mm deep.
std::vector<Vec3> lissajous(int steps)
{
  std::vector<Vec3> path_W;
  for (int i = 0; i <= steps; ++i)
  {
    const double a = 2 * pi * i / steps;
    path_W.push_back(0.065 * Vec3(std::sin(a), std::sin(2 * a + 0.5), std::sin(3 * a + 1.1)));
  }
  return path_W;
}

struct Work
{
  double held_J = 0.0;        ///< of forces held over a step
  double quasiStatic_J = 0.0; ///< of their means
  double limit_J = 0.0;       ///< K / 2 times the sum of squared steps
};

/// Once round a closed path, after a first round that only leads to where it begins.
template<class ForceAt>
Work work(const std::vector<Vec3>& path_W, ForceAt forceAt)
{
  for (const Vec3& p_W : path_W)
  {
    (void)forceAt(p_W);
  }
  Work done;
  Vec3 force_N = forceAt(path_W.front());
  for (std::size_t i = 1; i < path_W.size(); ++i)
  {
    const Vec3 step_m = path_W[i] - path_W[i - 1], next_N = forceAt(path_W[i]);
    done.held_J += force_N.dot(step_m);
    done.quasiStatic_J += 0.5 * (force_N + next_N).dot(step_m);
    done.limit_J += 0.5 * K * step_m.squaredNorm();
    force_N = next_N;
  }
  return done;
}

void judgeRoom(
  const std::string& name, const std::shared_ptr<const Scene>& scene, double radius_m, int steps, Table& table)
{
  const char* const ours = radius_m == 0.0 ? "god-object r=0" : "god-object r=1mm";
  double work_J[2] = {}, limit_J = 0.0;
  for (const int slower : { 0, 1 })
  {
    const int count = slower ? 10 * steps : steps;
    test::Probe probe(scene, radius_m, Vec3::Zero());
    const Work done = work(lissajous(count),
      [&](const Vec3& p_W)
      {
        probe.to(p_W);
        return Vec3(probe.force(K));
      });
    const std::string caseOf = name + " steps=" + std::to_string(count);
    table.atMost({ caseOf, ours, "work of a loop", "J" }, done.held_J, done.limit_J);
    table.atLeast({ caseOf, ours, "work of a loop", "J" }, done.held_J, 0.0);
    work_J[slower] = done.held_J;
    limit_J = slower ? limit_J : done.limit_J;
  }
  // The leak goes with the speed: its extrapolation to no speed, from two speeds, is zero.
  const double left_J = (10 * work_J[1] - work_J[0]) / 9;
  table.atMost({ name, ours, "work of a loop at no speed, share of the limit" }, std::abs(left_J) / limit_J, 1e-3);
}

constexpr double bump_m = 2e-4, wave_m = 2e-3, shallow_m = 1e-3, deep_m = 3e-3;

/// Up the side of a bump 1 mm deep, down into 3 mm, back and up: every corner is a sample.
std::vector<Vec3> rectangle(int stepsPerSide)
{
  const Vec3 corners_W[] = { { 0, 0, -shallow_m }, { 0, 0, -deep_m }, { wave_m / 2, 0, -deep_m },
    { wave_m / 2, 0, -shallow_m } };
  std::vector<Vec3> path_W;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < stepsPerSide; ++i)
    {
      path_W.push_back(
        corners_W[side] + static_cast<double>(i) / stepsPerSide * (corners_W[(side + 1) % 4] - corners_W[side]));
    }
  }
  path_W.push_back(corners_W[0]);
  return path_W;
}

/// A texture as a turned normal (Minsky et al. 1990): depth of the flat plane, sideways by the slope of bumps
/// h = bump (1 - cos(2 pi x / wave)) / 2 that are not there.
Vec3 turnedNormal_N(const Vec3& p_W)
{
  const double depth_m = std::max(0.0, -p_W.z());
  const double slope = bump_m * pi / wave_m * std::sin(2 * pi * p_W.x() / wave_m);
  return K * depth_m * Vec3(slope, 0, 1);
}

void textures(int steps, Table& table)
{
  test::Random random(1);
  const auto floor = test::sceneOf(test::makePlane(Vec3::UnitZ(), 0.05, 10, random));
  test::Probe probe(floor, 0.0, { 0, 0, 0.01 });
  const Work plain = work(rectangle(steps),
    [&](const Vec3& p_W)
    {
      probe.to(p_W);
      return Vec3(probe.force(K));
    });
  const std::string name = "floor loop=1mm..3mm";
  table.atMost({ name, "god-object r=0", "work of a loop", "J" }, plain.held_J, plain.limit_J);
  const Work turned = work(rectangle(steps), turnedNormal_N);
  // Over the bump and back at another depth: K (deep - shallow) bump, as slow as one likes.
  const double truth_J = K * (deep_m - shallow_m) * bump_m;
  table.within(
    { name, "turned normal", "work of a loop, quasi-static", "J" }, turned.quasiStatic_J, truth_J, 1e-6 * truth_J);
  table.atLeast(
    { name, "turned normal", "work of a loop over the limit of a held spring" }, turned.held_J / turned.limit_J, 10.0);
}

} // namespace closed_loop_experiment

void runClosedLoop(const Conditions& conditions, Table& table)
{
  using namespace closed_loop_experiment;
  const int steps = conditions.pick(2000, 20000, 200000);
  const auto box = test::sceneOf(test::makeBox({ -0.05, -0.05, -0.05 }, { 0.05, 0.05, 0.05 }));
  const auto ball = test::sceneOf(test::makeIcosphere(2, 0.05));
  for (const double radius_m : { 0.0, 1e-3 })
  {
    judgeRoom("room=box", box, radius_m, steps, table);
    judgeRoom("room=320-faces", ball, radius_m, steps, table);
    conditions.progress(radius_m == 0.0 ? 0.5 : 1.0);
  }
  textures(steps, table);
}

} // namespace palpate::lab
