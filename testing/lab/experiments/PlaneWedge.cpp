// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 44 and 45: a point among lines, in one tick, in any order, through none, round their ends.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/geometry/curves/CurveSet.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/backends/Backend.h"
#include "testing/lab/methods/IterateUntilFixed.h"
#include "testing/support/CostSample.h"
#include "testing/support/Meshes.h"
#include "testing/support/PathChecker.h"
#include "testing/support/Probe.h"
#include "testing/support/QpOracle.h"

namespace palpate::lab
{
namespace plane_wedge_experiment
{

using Vec2 = Eigen::Vector2d;

constexpr double wallHeight_u = 1.0;
/// A tick among two thousand lines takes about 15 of them, so one that becomes twice as dear is seen.
constexpr int queriesAllowed = 22;
constexpr const char* ours = "god-object r=0";
constexpr const char* original = "iterate-until-fixed";
constexpr const char* zeroSize = "iterate-until-fixed, no size";

std::shared_ptr<const Scene> sceneOf(const CurveSet& curves)
{
  return test::sceneOf(raiseWalls(curves, wallHeight_u));
}

Vec2 unit(double angle_rad)
{
  return { std::cos(angle_rad), std::sin(angle_rad) };
}

/// Two lines from the origin that enclose the angle about the x axis, the free place to the right.
CurveSet wedge(double angle_rad)
{
  return { { { 0, 0 }, 10 * unit(angle_rad / 2), 10 * unit(-angle_rad / 2) }, { { 0, 1 }, { 0, 2 } } };
}

/// The wedge among other lines that are far enough away to play no part, all in a random order.
CurveSet crowded(double angle_rad, test::Random& random)
{
  CurveSet curves = wedge(angle_rad);
  for (std::uint32_t i = 0; i < 40; ++i)
  {
    const double y_u = 20.0 + i;
    curves.points_W.insert(curves.points_W.end(), { { -5.0, y_u }, { 5.0, y_u + 0.3 } });
    curves.segments.push_back({ 3 + 2 * i, 4 + 2 * i });
  }
  random.shuffle(curves.segments);
  return curves;
}

const Vec3 pushed_W(-1.0, 0.2, 0.0);

/// The point of the wedge nearest to the pushed place, in exact arithmetic.
Vec3 nearestInWedge(double angle_rad)
{
  const Vec2 below = unit(angle_rad / 2 - std::numbers::pi / 2), above = unit(std::numbers::pi / 2 - angle_rad / 2);
  const PlaneRow rows[] = { { { below.x(), below.y(), 0 }, 0.0 }, { { above.x(), above.y(), 0 }, 0.0 } };
  return test::projectExactly(rows, pushed_W).y;
}

void judgeOrder(const std::string& name, double angle_rad, const Conditions& conditions, Table& table)
{
  test::Random random(conditions.seed + 44);
  const Vec3 truth_W = nearestInWedge(angle_rad);
  double worst_u = 0.0, spread_u = 0.0;
  Vec3 first_W = Vec3::Zero();
  const int orders = conditions.pick(1000, 1000, 10000);
  for (int i = 0; i < orders; ++i)
  {
    test::Probe probe(sceneOf(crowded(angle_rad, random)), 0.0, { 5, 0, 0 });
    probe.to(pushed_W);
    first_W = i == 0 ? probe.x_W() : first_W;
    worst_u = std::max(worst_u, (probe.x_W() - truth_W).norm());
    spread_u = std::max(spread_u, (probe.x_W() - first_W).norm());
  }
  table.atMost({ name, ours, "distance from the nearest point after a tick", "u" }, worst_u, 1e-12);
  table.atMost({ name, ours, "spread over orders of the lines", "u" }, spread_u, 0.0);
}

/// Every projection on the other line shortens the distance to the tip by the cosine of the angle.
void judgeSteps(const std::string& name, double angle_rad, Table& table)
{
  constexpr double near = 1e-6;
  constexpr int most = 100000;
  Vec2 at = unit(angle_rad / 2);
  int steps = 0;
  for (bool upper = false; at.norm() > near && steps < most; ++steps, upper = !upper)
  {
    const Vec2 line = unit(upper ? angle_rad / 2 : -angle_rad / 2);
    at = at.dot(line) * line;
  }
  const double contraction = std::abs(std::cos(angle_rad));
  const double truth = std::max(1.0, std::ceil(std::log(near) / std::log(contraction)));
  table.within({ name, original, "projections to 1e-6 of the way" }, steps, truth, 1.0);
}

/// The original where two lines cross at that angle (where they only meet, its rule for ends helps): as many steps as
/// it is given in a tick do not bring it to the crossing.
void judgeOriginal(const std::string& name, double angle_rad, Table& table)
{
  constexpr int budget = 100;
  const Vec2 up = 10 * unit(angle_rad / 2), down = 10 * unit(-angle_rad / 2);
  IterateUntilFixed point({ { -up, up, -down, down }, { { 0, 1 }, { 2, 3 } } }, 1e-9);
  point.start({ 5, 0 });
  point.tick(pushed_W.head<2>(), budget);
  const double away_u = (point.x_W() - nearestInWedge(angle_rad).head<2>()).norm();
  table.atLeast({ name, original, "distance from the nearest point after 100 steps", "u" }, away_u, 0.1);
}

/// A square room with a line across its middle that leaves a door.
CurveSet room()
{
  return { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, 0 }, { 0.5, 0 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 } } };
}

/// Devices that wander in and far behind the lines.
std::vector<Vec3> wandering(int ticks, test::Random& random)
{
  std::vector<Vec3> path_W{ { 0.3, -0.5, 0 } };
  Vec3 goal_W = path_W.front();
  while (static_cast<int>(path_W.size()) < ticks)
  {
    const Vec3 way_W = goal_W - path_W.back();
    if (way_W.norm() < 0.05)
    {
      goal_W = { random.uniform(-2, 2), random.uniform(-2, 2), 0 };
      continue;
    }
    path_W.push_back(path_W.back() + std::min(way_W.norm(), random.uniform(0.0, 0.1)) * way_W.normalized());
  }
  return path_W;
}

void judgeCrossings(const Conditions& conditions, Table& table)
{
  test::Random random(conditions.seed + 45);
  const std::vector<Vec3> path_W = wandering(conditions.pick(200000, 1000000, 1000000), random);
  test::PathChecker checker(raiseWalls(room(), wallHeight_u), 0.0);
  test::Probe probe(sceneOf(room()), 0.0, path_W.front(), &checker);
  IterateUntilFixed point(room(), 0.0);
  point.start(path_W.front().head<2>());
  int firstOutside = 0;
  for (std::size_t i = 1; i < path_W.size(); ++i)
  {
    probe.to(path_W[i]);
    point.tick(path_W[i].head<2>(), 100);
    firstOutside = !firstOutside && point.x_W().cwiseAbs().maxCoeff() > 1.0 ? static_cast<int>(i) : firstOutside;
  }
  const std::string name = "ticks=" + std::to_string(path_W.size());
  table.within({ name, ours, "outcome", outcomeUnit }, probe.finding().empty() ? 0 : 1, 0, 0);
  table.atLeast({ name, zeroSize, "outcome", outcomeUnit }, firstOutside > 0 ? 1 : 0, 1);
}

/// Adds up the length of the path.
class Length final : public PathSink
{
public:
  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override { this->length_u += (to_W - from_W).norm(); }
  double length_u = 0.0;
};

/// From above the end of a line to below it in one tick: as a string would be pulled tight, over the end.
void judgeEnds(Table& table)
{
  const auto scene = sceneOf({ { { -5, 0 }, { 0, 0 } }, { { 0, 1 } } });
  for (const double below_u : { 0.1, 0.5, 2.0 })
  {
    ContactPlan plan;
    GodObjectState state;
    Length way;
    (void)moveGodObject(*scene, plan, { -1, 0.5, 0 }, state);
    (void)moveGodObject(*scene, plan, { -1, -below_u, 0 }, state);
    const Vec3 target_W(0.5, -below_u, 0);
    (void)moveGodObject(*scene, plan, target_W, state, &way);
    const std::string name = caseName({ { "depth", below_u } });
    const double taut_u = 1.0 + target_W.norm();
    table.within({ name, ours, "way round the end of a line", "u" }, way.length_u, taut_u, 1e-9);
    table.atMost({ name, ours, "distance from the device once round it", "u" }, (state.x_W - target_W).norm(), 1e-9);
  }
}

/// A push deep into an inside corner, on and on.
void judgeCorner(const Conditions& conditions, Table& table)
{
  const CurveSet corner{ { { -5, 0 }, { 0, 0 }, { 0, -5 } }, { { 0, 1 }, { 1, 2 } } };
  test::Random random(conditions.seed + 46);
  test::Probe probe(sceneOf(corner), 0.0, { -1, -1, 0 });
  double worst_u = 0.0;
  for (int i = 0; i < conditions.pick(1000, 10000, 100000); ++i)
  {
    probe.to({ random.uniform(0.1, 3), random.uniform(0.1, 3), 0 });
    worst_u = std::max(worst_u, probe.x_W().norm());
  }
  table.atMost({ "inside corner", ours, "distance from the corner", "u" }, worst_u, 1e-9);
}

/// The whole path twice, once to warm up; `proxies_W` receives where the proxy was before each tick.
Cost tickCost(const std::shared_ptr<const Scene>& scene, const std::vector<Vec3>& path_W, std::vector<Vec3>& proxies_W)
{
  test::CostSample cost(path_W.size());
  cost.timeWarm(
    [&](auto call)
    {
      test::Probe probe(scene, 0.0, path_W.front());
      proxies_W.clear();
      for (const Vec3& p_W : path_W)
      {
        proxies_W.push_back(probe.x_W());
        call([&] { probe.to(p_W); });
      }
    });
  return Cost::of(cost);
}

/// One query a tick, from where the proxy was to where the device is.
Cost queryCost(Backend& cgal, const std::vector<Vec3>& proxies_W, const std::vector<Vec3>& path_W)
{
  test::CostSample cost(path_W.size());
  int met = 0;
  cost.timeWarm(
    [&](auto call)
    {
      for (std::size_t i = 0; i < path_W.size(); ++i)
      {
        call([&] { met += cgal.meets(proxies_W[i], path_W[i]); });
      }
    });
  return Cost::of(cost);
}

/// Two thousand segments in random places, the device wandering among and behind them.
void judgeCost(const Conditions& conditions, Table& table)
{
  test::Random random(conditions.seed + 47);
  CurveSet maze;
  for (std::uint32_t i = 0; i < 2000; ++i)
  {
    const Vec2 a(random.uniform(-2, 2), random.uniform(-2, 2));
    maze.points_W.insert(maze.points_W.end(), { a, a + 0.08 * unit(random.uniform(0, 6)) });
    maze.segments.push_back({ 2 * i, 2 * i + 1 });
  }
  const std::vector<Vec3> path_W = wandering(20000, random);
  const TriangleMesh walls = raiseWalls(maze, wallHalfHeight(maze, 0.0));
  test::PathChecker checker(walls, 0.0);
  const auto scene = test::sceneOf(walls);
  test::Probe judged(scene, 0.0, path_W.front(), &checker);
  for (const Vec3& p_W : path_W)
  {
    judged.to(p_W);
  }
  const char* const name = "segments=2000";
  table.within({ name, ours, "outcome", outcomeUnit }, judged.finding().empty() ? 0 : 1, 0, 0);

  const auto cgal = makeCgal(walls);
  std::vector<Vec3> proxies_W;
  const auto [tick, query] = test::costsInTurn(
    [&] { return tickCost(scene, path_W, proxies_W); }, [&] { return queryCost(*cgal, proxies_W, path_W); });
  const bool within = tick.p50_us <= queriesAllowed * query.p50_us;
  const std::string limit = "p50 within " + std::to_string(queriesAllowed) + " CGAL queries";
  table.within({ name, ours, limit }, within, 1.0, 0.0).cost = tick;
  table.info({ name, "cgal", "queries in a tick" }, 1.0).cost = query;
}

} // namespace plane_wedge_experiment

void runPlaneWedge(const Conditions& conditions, Table& table)
{
  using namespace plane_wedge_experiment;
  for (const double degrees : { 90.0, 60.0, 45.0, 30.0, 20.0, 10.0, 5.0 })
  {
    const double angle_rad = degrees * std::numbers::pi / 180;
    const std::string name = caseName({ { "angle", degrees } });
    judgeOrder(name, angle_rad, conditions, table);
    judgeSteps(name, angle_rad, table);
    if (degrees <= 10.0)
    {
      judgeOriginal(name, angle_rad, table);
    }
    conditions.progress(0.5 * (90.0 - degrees) / 85.0);
  }
  judgeCrossings(conditions, table);
  judgeEnds(table);
  judgeCorner(conditions, table);
  judgeCost(conditions, table);
}

} // namespace palpate::lab
