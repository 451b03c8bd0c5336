// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 49 and 54: the cost of a tick among lines, by a tree and by asking every line, and the saving by coarser lines.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "haptics/contact/sweep/Sweep.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/geometry/curves/MultiresolutionCurve.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/support/Meshes.h"
#include "testing/support/Polylines.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace plane_cost_experiment
{

using Vec2 = Eigen::Vector2d;

constexpr double half_u = 2.0; // of the square world
constexpr const char* ours = "tree, a whole tick";
constexpr const char* asked = "tree, asked once";
constexpr const char* flat = "every line, asked once";

std::shared_ptr<const Scene> sceneOf(const CurveSet& curves)
{
  return test::sceneOf(raiseWalls(curves, wallHalfHeight(curves, 0.0)));
}

/// A square of cells, half of their sides walls: about `segments` of them.
CurveSet maze(std::size_t segments, test::Random& random)
{
  const auto cells = static_cast<std::uint32_t>(std::max(2.0, std::round(std::sqrt(static_cast<double>(segments)))));
  const double cell_u = 2 * half_u / cells;
  CurveSet curves;
  const auto corner = [cells](std::uint32_t i, std::uint32_t j) { return j * (cells + 1) + i; };
  for (std::uint32_t j = 0; j <= cells; ++j)
  {
    for (std::uint32_t i = 0; i <= cells; ++i)
    {
      curves.points_W.emplace_back(i * cell_u - half_u, j * cell_u - half_u);
      if (i < cells && (j == 0 || j == cells || random.uniform() < 0.5))
      {
        curves.segments.push_back({ corner(i, j), corner(i + 1, j) });
      }
      if (j < cells && (i == 0 || i == cells || random.uniform() < 0.5))
      {
        curves.segments.push_back({ corner(i, j), corner(i, j + 1) });
      }
    }
  }
  return curves;
}

/// Where the segment from a to b first meets a line, as a share of it, 1 if nowhere: all lines in turn.
double firstCrossing(const CurveSet& curves, const Vec2& a, const Vec2& b)
{
  const auto cross = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
  double first = 1.0;
  for (const auto& [i, j] : curves.segments)
  {
    const Vec2 &p = curves.points_W[i], along = curves.points_W[j] - p, way = b - a;
    const double turn = cross(way, along);
    const double t = cross(p - a, along) / turn, s = cross(p - a, way) / turn;
    first = t >= 0.0 && t < first && s >= 0.0 && s <= 1.0 ? t : first;
  }
  return first;
}

/// A hand that strokes: about 0.2 m/s where the world is 10 cm wide, mostly behind walls.
std::vector<Vec3> stroking(std::size_t ticks, test::Random& random)
{
  constexpr double step_u = 0.2 * 1e-3 * 2 * half_u / 0.1;
  std::vector<Vec3> path_W{ { 0.0137, -0.0171, 0 } };
  Vec3 goal_W = path_W.front();
  while (path_W.size() < ticks)
  {
    const Vec3 way_W = goal_W - path_W.back();
    if (way_W.norm() <= step_u)
    {
      goal_W = path_W.back() + Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0);
      goal_W = goal_W.cwiseMax(Vec3(-half_u, -half_u, 0)).cwiseMin(Vec3(half_u, half_u, 0));
      continue;
    }
    path_W.push_back(path_W.back() + step_u * way_W.normalized());
  }
  return path_W;
}

/// Lines, and the same as walls.
struct World
{
  CurveSet curves;
  std::shared_ptr<const Scene> scene;

  [[nodiscard]] std::string name() const
  {
    return caseName({ { "lines", static_cast<double>(this->curves.segments.size()) } });
  }
};

/// Ticks of a stroke.
void judgeStroke(const World& world, const std::vector<Vec3>& path_W, Table& table)
{
  const std::string name = world.name();
  test::Probe probe(world.scene, 0.0, path_W.front());
  test::CostSample tree(path_W.size());
  double incomplete = 0.0, nodes = 0.0;
  for (const Vec3& p_W : path_W)
  {
    ContactResult result;
    tree.time([&] { result = probe.to(p_W); });
    incomplete += result.overBudget || result.capped;
    nodes = std::max(nodes, static_cast<double>(result.work));
  }
  table.within({ name, ours, "ticks that ran out of work" }, incomplete, 0.0, 0.0).cost = Cost::of(tree);
  table.info({ name, ours, "nodes in a tick, most" }, nodes);
}

/// The question of which a tick asks several: where a segment, 20 ticks long here, first meets a line.
void judgeQuestion(const World& world, const std::vector<Vec3>& path_W, Table& table)
{
  const std::string name = world.name();
  const std::size_t ways = std::min<std::size_t>(path_W.size(), 1 + 20000000 / world.curves.segments.size());
  test::CostSample list(ways), tree(ways);
  double differ = 0.0, hits = 0.0;
  for (std::size_t i = 1; i < ways; ++i)
  {
    const Vec3 from_W = path_W[i - 1], to_W = from_W + 20.0 * (path_W[i] - from_W);
    double met = 1.0, swept = 1.0;
    list.time([&] { met = firstCrossing(world.curves, from_W.head<2>(), to_W.head<2>()); });
    tree.time([&] { swept = sweepBall(*world.scene, straightQuery(from_W, to_W), ContactPlan().workBudget).t; });
    hits += met < 1.0;
    differ += std::fabs(swept - met) > 1e-9;
  }
  table.within({ name, asked, "first lines met that differ from those of the list" }, differ, 0.0, 0.0).cost =
    Cost::of(tree);
  table.atLeast({ name, flat, "ways that meet a line" }, hits, 1.0).cost = Cost::of(list);
  if (world.curves.segments.size() >= 2000)
  {
    const bool cheaper = tree.quantile_us(0.5) < list.quantile_us(0.5);
    table.within({ name, asked, "cheaper than every line" }, cheaper, 1.0, 0.0);
  }
}

Cost tickCost(const std::shared_ptr<const Scene>& scene, const std::vector<Vec3>& path_W)
{
  test::Probe probe(scene, 0.0, path_W.front());
  test::CostSample sample(path_W.size());
  for (const Vec3& p_W : path_W)
  {
    sample.time([&] { probe.to(p_W); });
  }
  return Cost::of(sample);
}

/// A tick among very many lines against one among two thousand: the path down a tree grows with their logarithm.
void judgeGrowth(const World& few, const World& many, const std::vector<Vec3>& path_W, Table& table)
{
  constexpr int allowed = 2;
  const auto [large, small] =
    test::costsInTurn([&] { return tickCost(many.scene, path_W); }, [&] { return tickCost(few.scene, path_W); });
  const bool within = large.p50_us <= allowed * small.p50_us;
  table
    .within({ many.name(), ours, "p50 within " + std::to_string(allowed) + " ticks among two thousand lines" }, within,
      1.0, 0.0)
    .cost = large;
}

CurveSet through(const std::vector<Vec3>& points_W)
{
  CurveSet lines;
  for (const Vec3& p_W : points_W)
  {
    lines.points_W.emplace_back(p_W.head<2>());
    const auto last = static_cast<std::uint32_t>(lines.points_W.size() - 1);
    if (last > 0)
    {
      lines.segments.push_back({ last - 1, last });
    }
  }
  return lines;
}

/// A ring as it is felt while the hand is there: a scene, and for how many ticks.
struct Level
{
  std::shared_ptr<const Scene> scene;
  std::size_t ticks = 0;
};

constexpr double strokeStep_rad = 4e-3; // 2 units from the middle: 0.2 mm of the hand

Vec3 strokeAt(std::size_t tick)
{
  const double angle_rad = strokeStep_rad * static_cast<double>(tick);
  return { 2.0 * std::cos(angle_rad), 2.0 * std::sin(angle_rad), 0 };
}

/// A stroke of 0.2 m/s from inside along a ring whose world is 10 cm wide. Ticks whose work did not suffice.
template<class LevelAt>
double stroked(LevelAt levelAt, const Vec3& start_W, std::size_t ticks, Cost& cost)
{
  Level level = levelAt(0);
  test::Probe probe(level.scene, 0.0, start_W);
  test::CostSample sample(ticks);
  double incomplete = 0.0;
  for (std::size_t i = 0, left = level.ticks; i < ticks; ++i, --left)
  {
    if (left == 0)
    {
      level = levelAt(i);
      left = level.ticks;
      probe.changeScene(level.scene);
    }
    ContactResult result;
    sample.time([&] { result = probe.to(strokeAt(i)); });
    incomplete += result.overBudget || result.capped;
  }
  cost = Cost::of(sample);
  return incomplete;
}

/// One choice for all of the stroke.
double stroked(const std::vector<Vec3>& ring_W, std::size_t ticks, Cost& cost)
{
  const Level level{ sceneOf(through(ring_W)), ticks };
  return stroked([&](std::size_t) { return level; }, 0.2 * ring_W.front(), ticks, cost);
}

/// Saving by a level that follows the hand: a choice every 16 ms that is fine where the hand may come meanwhile and
/// coarser beyond.
void judgeFollowing(const MultiresolutionCurve& curve, double limit_u, std::size_t ticks, Table& table)
{
  constexpr std::size_t every_ticks = 16;
  constexpr double reach_u = 1.0, growth = 0.1; // the hand is up to 2 / 3 of a unit from where it touches
  std::size_t most = 0;
  const auto levelAt = [&](std::size_t tick)
  {
    const std::vector<Vec3> chosen_W =
      test::pick(curve.points_W(), curve.choose({ strokeAt(tick), limit_u, reach_u, growth }));
    most = std::max(most, chosen_W.size());
    return Level{ sceneOf(through(chosen_W)), every_ticks };
  };
  Cost cost;
  const double incomplete = stroked(levelAt, 0.2 * curve.points_W().front(), ticks, cost);
  const std::string kept =
    caseName({ { "points", static_cast<double>(curve.points_W().size()) }, { "kept", static_cast<double>(most) } });
  table.within({ kept, "fine near the hand", "ticks that ran out of passes" }, incomplete, 0.0, 0.0).cost = cost;
}

/// A curve far finer than a hand feels: a tick passes one facet after the other, and a stroke passes more of them than
/// a tick has passes. Coarser lines are for that, not for the tree; once they are within the threshold of a hand, all
/// at once.
void judgeLevels(const Conditions& conditions, Table& table)
{
  constexpr double stiffness_N_per_u = 500.0 / 40.0; // 500 N/m where the world is 10 cm wide
  const std::size_t points = conditions.pick<std::size_t>(100000, 300000, 1000000);
  const std::size_t ticks = conditions.pick<std::size_t>(1500, 5000, 50000);
  const MultiresolutionCurve curve(test::wavyLine(conditions.seed, points, true));
  CurveDetail detail;
  detail.limit_u = 0.5 * leastForce_N / stiffness_N_per_u; // two choices differ by at most twice that
  const std::vector<Vec3> coarse_W = test::pick(curve.points_W(), curve.choose(detail));
  const std::string all = caseName({ { "points", static_cast<double>(points) } });
  const std::string kept =
    caseName({ { "points", static_cast<double>(points) }, { "kept", static_cast<double>(coarse_W.size()) } });
  Cost cost;
  table.atLeast({ all, "all points", "ticks that ran out of passes" }, stroked(curve.points_W(), ticks, cost), 1.0)
    .cost = cost;
  table
    .within({ kept, "within what is felt", "ticks that ran out of passes" }, stroked(coarse_W, ticks, cost), 0.0, 0.0)
    .cost = cost;
  judgeFollowing(curve, detail.limit_u, ticks, table);
  double away_u = 0.0;
  for (std::size_t i = 0; i < points; i += points / 2000)
  {
    away_u = std::max(away_u, test::distanceToPolyline(curve.points_W()[i], coarse_W));
  }
  table.atMost(
    { kept, "within what is felt", "force of a change of level", "N" }, 2 * stiffness_N_per_u * away_u, leastForce_N);
}

} // namespace plane_cost_experiment

void runPlaneCost(const Conditions& conditions, Table& table)
{
  using namespace plane_cost_experiment;
  test::Random random(conditions.seed);
  std::vector<std::size_t> sizes = { 8, 32, 128, 512, 2000, 10000, 100000 };
  if (conditions.size != Size::Quick)
  {
    sizes.push_back(1000000);
  }
  test::Random hand(conditions.seed + 4);
  const std::vector<Vec3> path_W = stroking(conditions.pick<std::size_t>(2000, 20000, 100000), hand);
  World few, world;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    world.curves = maze(sizes[i], random);
    world.scene = sceneOf(world.curves);
    few = sizes[i] == 2000 ? world : few;
    judgeStroke(world, path_W, table);
    judgeQuestion(world, path_W, table);
    conditions.progress(0.8 * static_cast<double>(i + 1) / static_cast<double>(sizes.size()));
  }
  judgeGrowth(few, world, path_W, table);
  judgeLevels(conditions, table);
}

} // namespace palpate::lab
