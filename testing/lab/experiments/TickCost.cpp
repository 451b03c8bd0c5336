// SPDX-License-Identifier: GPL-3.0-or-later
// Row 54: work of an exact tick of sliding contact, and its cost beside one segment query of CGAL's tree.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "haptics/contact/GodObject.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/backends/Backend.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::lab
{
namespace tick_cost_experiment
{

constexpr const char* ours = "god-object";

/// Work of the ticks of a slide; the same on every run. Costs come apart.
struct Work
{
  std::vector<double> nodes, sweeps, passes;
  double bound = 0.0; ///< ticks ended by a budget
  double lost = 0.0;  ///< ticks without contact
  std::vector<Vec3> proxies_W;
};

double quantile(std::vector<double> values, double fraction)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

void note(const ContactResult& result, Work& work)
{
  work.nodes.push_back(result.work);
  work.sweeps.push_back(result.sweeps);
  work.passes.push_back(result.passes);
  work.bound += result.capped || result.overBudget;
  work.lost += result.contacts == 0;
  work.proxies_W.push_back(result.proxy_W);
}

/// The slide once to warm up, which is also where its work is noted, and once against the clock.
Cost slide(
  const Scene& scene, double radius_mm, const test::NoisySphere& sphere, const std::vector<Vec3>& path_W, Work& work)
{
  ContactPlan plan;
  plan.radius_u = radius_mm;
  test::CostSample sample(path_W.size());
  for (const bool timed : { false, true })
  {
    GodObjectState state;
    (void)moveGodObject(scene, plan, test::slideStart_W(sphere), state);
    for (const Vec3& p_W : path_W)
    {
      if (timed)
      {
        sample.time([&] { (void)moveGodObject(scene, plan, p_W, state); });
      }
      else
      {
        note(moveGodObject(scene, plan, p_W, state), work);
      }
    }
  }
  return Cost::of(sample);
}

/// One query a tick, from where the proxy was to where the device is: the first thing a tick has to know.
Cost queryCost(Backend& backend, const std::vector<Vec3>& proxies_W, const std::vector<Vec3>& path_W)
{
  test::CostSample sample(path_W.size());
  int met = 0;
  sample.timeWarm(
    [&](auto call)
    {
      for (std::size_t i = 1; i < path_W.size(); ++i)
      {
        call([&] { met += backend.meets(proxies_W[i - 1], path_W[i]); });
      }
    });
  return Cost::of(sample);
}

/// Twice the bar of row 54, 1.5 us for a point and 4 us for a ball on 100 000 triangles (3 and 8 on a million), on a
/// machine whose segment query takes 0.25 us (0.5 us) there, so that other work beside it does not decide.
double queriesAllowed(double radius_mm)
{
  return radius_mm == 0.0 ? 12.0 : 32.0;
}

/// How far the ball is from touching the surface, at most: |distance - r| of every proxy but that of the first tick,
/// which comes from 5 mm above.
double gap_mm(Backend& oracle, double radius_mm, const std::vector<Vec3>& proxies_W)
{
  double gap_mm = 0.0;
  for (const Vec3& x_W : proxies_W)
  {
    gap_mm = std::max(gap_mm, std::abs(*oracle.distance_u(x_W) - radius_mm));
  }
  return gap_mm;
}

void reportWork(const std::string& caseName, const Work& work, Table& table)
{
  const ContactPlan plan;
  table.within({ caseName, ours, "ticks that lost the surface" }, work.lost, 0.0, 0.0);
  // A slide over more facets than a tick has passes goes on in the next tick: rare, and later by a millisecond.
  const auto ticks = static_cast<double>(work.nodes.size());
  table.atMost({ caseName, ours, "ticks ended by a budget, share" }, work.bound / ticks, 1e-3);
  table.atMost({ caseName, ours, "nodes in a tick, most" }, quantile(work.nodes, 1.0), plan.workBudget);
  table.atMost({ caseName, ours, "passes in a tick, most" }, quantile(work.passes, 1.0),
    plan.passCap + 1.0); // the pass that finds the cap reached counts
  for (const auto& [share, fraction] : { std::pair("half", 0.5), std::pair("99 %", 0.99) })
  {
    table.info({ caseName, ours, std::string("nodes in a tick, ") + share }, quantile(work.nodes, fraction));
    table.info({ caseName, ours, std::string("sweeps in a tick, ") + share }, quantile(work.sweeps, fraction));
    table.info({ caseName, ours, std::string("passes in a tick, ") + share }, quantile(work.passes, fraction));
  }
}

void runSize(std::size_t triangles, std::size_t ticks, Table& table)
{
  const test::NoisySphere sphere(triangles, 1.0);
  const auto scene = test::sceneOf(sphere.mesh());
  const auto cgal = makeCgal(sphere.mesh()), oracle = makeExact(sphere.mesh());
  std::vector<Vec3> path_W;
  for (std::size_t i = 0; i < ticks; ++i)
  {
    path_W.push_back(test::slideOver(sphere, i).p_W);
  }
  for (const double radius_mm : { 0.0, 1.0 })
  {
    const std::string name =
      caseName({ { "triangles", static_cast<double>(sphere.mesh().triangles.size()) }, { "r", radius_mm } });
    Work work;
    const auto [tick, query] = test::costsInTurn(
      [&]
      {
        work = {};
        return slide(*scene, radius_mm, sphere, path_W, work);
      },
      [&] { return queryCost(*cgal, work.proxies_W, path_W); });
    reportWork(name, work, table);
    // A point is kept some rounding errors above the surface, a ball touches it.
    table.atMost(
      { name, ours, "gap between ball and surface", "mm" }, gap_mm(*oracle, radius_mm, work.proxies_W), 1e-9);
    const double allowed = queriesAllowed(radius_mm);
    const bool within = tick.p50_us <= allowed * query.p50_us;
    table
      .within(
        { name, ours, "p50 within " + std::to_string(static_cast<int>(allowed)) + " CGAL queries" }, within, 1.0, 0.0)
      .cost = tick;
    table.info({ name, "cgal", "queries in a tick" }, 1.0).cost = query;
  }
}

} // namespace tick_cost_experiment

void runTickCost(const Conditions& conditions, Table& table)
{
  using namespace tick_cost_experiment;
  const std::vector<std::size_t> sizes =
    conditions.size == Size::Quick ? std::vector<std::size_t>{ 100000 } : std::vector<std::size_t>{ 100000, 1000000 };
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    runSize(sizes[i], conditions.pick<std::size_t>(3000, 30000, 100000), table);
    conditions.progress(static_cast<double>(i + 1) / static_cast<double>(sizes.size()));
  }
}

} // namespace palpate::lab
