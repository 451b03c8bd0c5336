// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 11, 12 and 13: concave corners in one tick, valleys that are almost flat, wedges.
#include "testing/support/Corners.h"
#include "haptics/core/PoseMath.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"
#include "testing/support/QpOracle.h"

namespace palpate::lab
{
namespace corners_experiment
{

constexpr double stiffness_N_per_m = 1000.0;

/// Ticks until the proxy is within `near_m` of where it must rest, the device there from the first tick on.
int ticksToRest(const World& world, const std::string& name, const test::Corner& corner, double near_m)
{
  constexpr int most = 100;
  const auto proxy = method(name).make(world);
  proxy->start(corner.start_W());
  int ticks = 1;
  while ((proxy->tick(corner.p_W).proxy_W - corner.x_W).norm() > near_m && ticks < most)
  {
    ++ticks;
  }
  return ticks;
}

struct OneTick
{
  double position_m = 0.0, force_N = 0.0;
  int changedByOrder = 0; ///< meshes on which another order of the triangles changed a bit
};

OneTick oneTick(const test::Corner& corner, int meshes, int shuffles, test::Random& random)
{
  OneTick worst;
  const auto rest = [&corner](const TriangleMesh& mesh)
  {
    const auto proxy = method("god-object r=0").make(World(mesh));
    proxy->start(corner.start_W());
    return proxy->tick(corner.p_W);
  };
  for (int i = 0; i < meshes; ++i)
  {
    const TriangleMesh mesh = test::meshOf(corner, random);
    const MethodTick first = rest(mesh);
    worst.position_m = std::max(worst.position_m, (first.proxy_W - corner.x_W).norm());
    worst.force_N = std::max(worst.force_N, std::abs(stiffness_N_per_m * first.force_u.norm() - corner.force_N));
    for (int k = 0; k < shuffles; ++k)
    {
      worst.changedByOrder += rest(test::shuffled(mesh, random)).proxy_W != first.proxy_W;
    }
  }
  return worst;
}

void runNineCorners(const Conditions& conditions, test::Random& random, Table& table)
{
  const std::string ours = "god-object r=0", single = "one-constraint";
  for (const test::Corner& corner : test::corners())
  {
    const std::string caseName = "corner=" + corner.name.substr(0, 2);
    const OneTick worst = oneTick(corner, conditions.pick(5, 20, 200), conditions.pick(5, 50, 200), random);
    table.atMost({ caseName, ours, "position error after one tick", "m" }, worst.position_m, 1e-12);
    table.atMost({ caseName, ours, "force error after one tick", "N" }, worst.force_N, 1e-9);
    table.within({ caseName, ours, "results changed by the order of triangles", "" }, worst.changedByOrder, 0.0, 0.0);
    const World world(test::meshOf(corner, random));
    table.within({ caseName, ours, "ticks to rest", "" }, ticksToRest(world, ours, corner, 1e-12), 1.0, 0.0);
    // It stops at each new plane, so it is wrong for a tick at least.
    table.atLeast({ caseName, single, "ticks to rest", "" }, ticksToRest(world, single, corner, 1e-4), 2.0);
  }
}

/// Force errors [relative] on a valley whose sides rise by `rise_rad` each; the truth is straight up by symmetry.
double valleyError(double rise_rad)
{
  const World world(test::makeGroove(std::numbers::pi / 2 - rise_rad, 1.0));
  const auto proxy = method("god-object r=0").make(world);
  proxy->start({ 0.1, 0.01, 0.9 });
  return (proxy->tick({ 0, 0, -1 }).force_u - Vec3::UnitZ()).norm();
}

/// The same by the inverse of the normal matrix: l = (N N^T)^-1 (c - N p) for the planes n . x >= 0, in a turned frame.
/// A singular matrix gives no force: all of it is missing.
double normalMatrixError(double rise_rad, test::Random& random)
{
  const Quat turn = shortestTurn(Vec3::UnitZ(), random.direction());
  const Vec3 n1 = turn * Vec3(std::sin(rise_rad), 0, std::cos(rise_rad));
  const Vec3 n2 = turn * Vec3(-std::sin(rise_rad), 0, std::cos(rise_rad));
  const Vec3 p = random.uniform(0.5, 1.0) * (turn * Vec3(random.uniform(-0.4, 0.4) * rise_rad, random.uniform(), -1));
  const double g11 = n1.squaredNorm(), g22 = n2.squaredNorm(), g12 = n1.dot(n2);
  const double determinant = g11 * g22 - g12 * g12;
  const Vec3 force =
    determinant == 0.0
      ? Vec3(Vec3::Zero())
      : Vec3((n1 * (g12 * n2.dot(p) - g22 * n1.dot(p)) + n2 * (g12 * n1.dot(p) - g11 * n2.dot(p))) / determinant);
  const std::array<PlaneRow, 2> rows{ PlaneRow{ n1, 0.0 }, PlaneRow{ n2, 0.0 } };
  const Vec3 truth = test::projectExactly(rows, p).y - p;
  return std::min(1.0, (force - truth).norm() / truth.norm());
}

void runValleys(test::Random& random, Table& table)
{
  for (int digits = 1; digits <= 12; ++digits)
  {
    const double rise_rad = std::pow(10.0, -digits) / 2;
    const std::string caseName = "angle=1e-" + std::to_string(digits);
    table.atMost({ caseName, "god-object r=0", "force error", "" }, valleyError(rise_rad), 1e-9);
    double worst = 0.0;
    for (int i = 0; i < 50; ++i)
    {
      worst = std::max(worst, normalMatrixError(rise_rad, random));
    }
    // The determinant is the square of the angle and known to rounding, 2e-16: nine digits are left down to 1e-3.
    const Subject naive{ caseName, "normal-matrix", "force error", "" };
    if (digits <= 3)
    {
      table.atMost(naive, worst, 1e-8);
    }
    else
    {
      table.atLeast(naive, worst, 1e-9);
    }
  }
}

/// Steps of alternate projection in a wedge until the distance to its edge has fallen by `factor`.
int alternatingSteps(double opening_rad, double factor)
{
  const std::array<Plane, 2> planes{ Plane{ Vec3::UnitZ(), 0.0 },
    Plane{ Vec3(std::sin(opening_rad), 0, -std::cos(opening_rad)), 0.0 } };
  Vec3 y(-1, 0, 0); // in the first plane, behind the second
  int steps = 0;
  while (y.norm() > factor)
  {
    const Plane& plane = planes[static_cast<std::size_t>(++steps % 2)];
    y -= plane.height(y) * plane.n;
  }
  return steps;
}

void runWedges(Table& table)
{
  constexpr double factor = 1e-6;
  for (const int degrees : { 10, 20, 30, 45, 60, 80 })
  {
    const double opening_rad = degrees * std::numbers::pi / 180;
    const std::string caseName = "opening=" + std::to_string(degrees) + "deg";
    // From one plane to the other the distance to their line shrinks by the cosine of the angle between them.
    const double truth = std::ceil(std::log(factor) / std::log(std::cos(opening_rad)));
    table.within({ caseName, "alternating", "steps to 1e-6", "" }, alternatingSteps(opening_rad, factor), truth, 1.0);
  }
}

void runTremble(const Conditions& conditions, test::Random& random, Table& table)
{
  const test::Corner wedge = test::corners()[3];
  const World world(test::meshOf(wedge, random));
  const Subject subject{ "corner=S4 noise=20um", "god-object r=0", "movement across the wedge", "m" };
  const auto proxy = method("god-object r=0").make(world);
  proxy->start(wedge.start_W());
  double largest_m = 0.0;
  for (int i = 0; i < conditions.pick(1000, 10000, 100000); ++i)
  {
    const Vec3 count_W = 20e-6 * Vec3(random.below(3) - 1.0, random.below(3) - 1.0, random.below(3) - 1.0);
    const Vec3 x_W = proxy->tick(wedge.p_W + count_W).proxy_W;
    largest_m = std::max(largest_m, std::hypot(x_W.x(), x_W.z()));
  }
  table.atMost(subject, largest_m, 1e-12);
  const auto alternating = method("alternating").make(world);
  alternating->start(wedge.start_W());
  // After 16 of the 97 steps a tenth of the distance is left.
  table.atLeast({ "corner=S4", "alternating", "position error after one tick", "m" },
    (alternating->tick(wedge.p_W).proxy_W - wedge.x_W).norm(), 1e-4);
}

} // namespace corners_experiment

void runCorners(const Conditions& conditions, Table& table)
{
  using namespace corners_experiment;
  test::Random random(conditions.seed + 11);
  runNineCorners(conditions, random, table);
  runValleys(random, table);
  runWedges(table);
  runTremble(conditions, random, table);
}

} // namespace palpate::lab
