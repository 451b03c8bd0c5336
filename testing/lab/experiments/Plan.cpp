// SPDX-License-Identifier: GPL-3.0-or-later
// Choices of a plan: how large a ball may be, a tree or a flat list of triangles, all triangles or proven fewer.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/geometry/scene/ScenePlan.h"
#include "haptics/geometry/simplify/Simplification.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"
#include "testing/support/SpherePlay.h"

namespace palpate::lab
{
namespace plan_experiment
{

constexpr double sphere_mm = 50.0;

/// Edge of a triangle of the mean area on the sphere.
double edge_mm(const test::NoisySphere& sphere)
{
  const double area_mm2 = 4 * std::numbers::pi * sphere_mm * sphere_mm;
  return std::sqrt(area_mm2 / static_cast<double>(sphere.mesh().triangles.size()) * 4 / std::sqrt(3.0));
}

/// A ball so large that one sweep may be too much for a tick, where such a ball fits into the sphere.
void judgeBeyond(const test::NoisySphere& sphere, std::size_t ticks, std::uint64_t seed, Table& table)
{
  const auto scene = test::sceneOf(sphere.mesh());
  ContactPlan plan = test::fewPasses();
  const double limit_mm = radiusLimit(*scene, plan).largest_u;
  plan.radius_u = 1.05 * test::radiusOfOneSweep_u(*scene, plan);
  if (plan.radius_u < 0.9 * sphere_mm)
  {
    const test::SpherePlay seen = test::playOn(sphere, { plan, true, ticks, seed });
    const std::string name = caseName({ { "triangles", static_cast<double>(sphere.mesh().triangles.size()) },
      { "inside", 1.0 }, { "r/limit", plan.radius_u / limit_mm } });
    table.atLeast({ name, "no limit", "ticks over budget" }, static_cast<double>(seen.overBudget), 1.0).cost =
      Cost::of(seen.cost);
  }
}

void radiusAgainstWork(const Conditions& conditions, Table& table)
{
  const std::size_t ticks = conditions.pick<std::size_t>(4000, 10000, 100000);
  for (const std::size_t triangles : { 5000u, 100000u })
  {
    const test::NoisySphere sphere(triangles, 1.0);
    const double limit_mm = radiusLimit(*test::sceneOf(sphere.mesh()), ContactPlan{}).largest_u;
    const auto size = static_cast<double>(sphere.mesh().triangles.size());
    for (const bool inside : { false, true })
    {
      for (const double share : { 0.03, 0.1, 0.3, 1.0 })
      {
        ContactPlan plan;
        plan.radius_u = share * limit_mm;
        const test::SpherePlay seen = test::playOn(sphere, { plan, inside, ticks, conditions.seed });
        const std::string name =
          caseName({ { "triangles", size }, { "inside", inside ? 1.0 : 0.0 }, { "r/limit", share } });
        table.within({ name, "god-object", "ticks over budget" }, static_cast<double>(seen.overBudget), 0.0, 0.0).cost =
          Cost::of(seen.cost);
        table.info({ name, "god-object", "r / edge" }, share * limit_mm / edge_mm(sphere));
        table.info({ name, "god-object", "nodes in a tick, most" }, static_cast<double>(seen.mostNodes));
      }
    }
    // Such a tick is rare: there was none in the 4,000 of the quick size.
    judgeBeyond(sphere, std::max<std::size_t>(ticks, 10000), conditions.seed, table);
  }
}

/// The leaves of a surface as surfaces of their own: walked one after the other they are a flat list of boxes with up
/// to eight triangles each. The list tests edges between leaves twice, which the tree does not.
using Leaves = std::vector<std::unique_ptr<SurfaceTree>>;

Leaves flatList(const SurfaceData& data)
{
  Leaves leaves;
  for (const Leaf& leaf : data.leaves)
  {
    TriangleMesh part;
    part.vertices_W = data.mesh.vertices_W;
    const auto first = data.mesh.triangles.begin() + leaf.first;
    part.triangles.assign(first, first + leaf.count);
    leaves.push_back(std::make_unique<SurfaceTree>(cleanMesh(part).mesh));
  }
  return leaves;
}

/// Segments as a tick of sliding contact asks for: from where a ball touches, mostly along, a little down.
std::vector<SweepQuery> slides(double radius_u, double size_u, std::size_t count, test::Random& random)
{
  std::vector<SweepQuery> queries(count);
  for (SweepQuery& query : queries)
  {
    const Vec3 along_W(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.0));
    query.radius_u = radius_u;
    query.from_W = { random.uniform(-0.4, 0.4) * size_u, random.uniform(-0.4, 0.4) * size_u, 1.01 * radius_u };
    query.to_W = query.from_W + size_u * along_W;
    query.resolution.include(query.from_W);
  }
  return queries;
}

double firstTouch(const Leaves& leaves, const SweepQuery& query)
{
  double first = 1.0;
  for (const auto& leaf : leaves)
  {
    first = std::min(first, sweepSurface(leaf->data(), 0, query, ContactPlan{}.workBudget).t);
  }
  return first;
}

/// Costs of one query of either, from the medians over batches in turn.
struct QueryCosts
{
  Cost tree, list;
  double differ = 0.0; ///< queries whose first contacts were not at the same time
};

QueryCosts askBoth(
  const SurfaceData& data, const Leaves& leaves, const std::vector<SweepQuery>& queries, std::size_t repetitions)
{
  test::CostSample tree(repetitions), list(repetitions);
  std::vector<double> ofTree(queries.size()), ofList(queries.size());
  for (std::size_t k = 0; k < repetitions; ++k)
  {
    tree.time(
      [&]
      {
        std::transform(queries.begin(), queries.end(), ofTree.begin(),
          [&](const SweepQuery& q) { return sweepSurface(data, 0, q, ContactPlan{}.workBudget).t; });
      });
    list.time(
      [&]
      {
        std::transform(
          queries.begin(), queries.end(), ofList.begin(), [&](const SweepQuery& q) { return firstTouch(leaves, q); });
      });
  }
  const auto count = static_cast<double>(queries.size());
  const auto ofOne = [count](const test::CostSample& sample) {
    return Cost{ sample.quantile_us(0.5) / count, sample.quantile_us(0.99) / count };
  };
  QueryCosts costs{ ofOne(tree), ofOne(list) };
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    costs.differ += ofTree[i] != ofList[i];
  }
  return costs;
}

/// Up to eight triangles stand in one leaf: there the tree is the list.
void treeAgainstList(const Conditions& conditions, Table& table)
{
  constexpr double busy = 1.25; // shift of a ratio of medians by other work on the machine
  test::Random random(conditions.seed);
  for (int columns = 1, rows = 2; columns * rows <= 1024; columns < rows ? columns *= 2 : rows *= 2)
  {
    const auto scene = test::sceneOf(test::makeSheet({ 1.0, 1.0, columns, rows, 0.3 }, random));
    const SurfaceData& data = scene->surfaces().front().tree->data();
    const QueryCosts costs =
      askBoth(data, flatList(data), slides(0.05, 1.0, 200, random), conditions.pick<std::size_t>(50, 300, 3000));
    const std::string name = caseName({ { "triangles", 2.0 * columns * rows } });
    table.within({ name, "flat list", "first contacts that differ from the tree's" }, costs.differ, 0.0, 0.0).cost =
      costs.list;
    const bool within = costs.tree.p50_us <= busy * costs.list.p50_us;
    table.within({ name, "tree", "no dearer than the list" }, within, 1.0, 0.0).cost = costs.tree;
  }
}

/// Forces under the same hand on a surface and on its proven simpler one, 1 N/mm.
struct Comparison
{
  double worst_mm = 0.0;   ///< largest difference of their magnitudes
  double noticeable = 0.0; ///< share of ticks beyond the just noticeable difference
  Cost full, fewer;
};

template<class Hand>
Comparison compare(const TriangleMesh& mesh, const TriangleMesh& simpler, std::size_t ticks, Hand hand)
{
  test::Probe full(test::sceneOf(mesh), 0.0, hand(0) * (1.0 + 0.1)), fewer(test::sceneOf(simpler), 0.0, full.x_W());
  test::CostSample costFull(ticks), costFewer(ticks);
  Comparison seen;
  for (std::size_t i = 0; i < ticks; ++i)
  {
    const Vec3 p_W = hand(i);
    costFull.time([&] { full.to(p_W); });
    costFewer.time([&] { fewer.to(p_W); });
    const double force_mm = full.force(1.0).norm(), difference_mm = std::abs(fewer.force(1.0).norm() - force_mm);
    seen.worst_mm = std::max(seen.worst_mm, difference_mm);
    seen.noticeable += (difference_mm > ScenePlan::noticed * force_mm) / static_cast<double>(ticks);
  }
  seen.full = Cost::of(costFull);
  seen.fewer = Cost::of(costFewer);
  return seen;
}

Simplification simplified(const TriangleMesh& mesh)
{
  const auto scene = test::sceneOf(mesh);
  TouchConditions touch;
  touch.scale_u_per_m = 1e3;
  const SurfaceTree& tree = *scene->surfaces().front().tree;
  return simplifyWithin(tree, { planTouch(tree, touch).unnoticed_u() });
}

/// Once round a tilted great circle, 1 mm deep: there a proven bound is the largest difference of two springs.
void fewerTriangles(const Conditions& conditions, Table& table)
{
  const auto ticks = conditions.pick<std::size_t>(2000, 10000, 60000);
  const TriangleMesh mesh = test::makeIcosphere(conditions.pick(5, 6, 6), sphere_mm);
  const Simplification simpler = simplified(mesh);
  if (!simpler.tree)
  {
    throw std::runtime_error(simpler.refusal);
  }
  const Comparison seen = compare(mesh, simpler.tree->mesh(), ticks,
    [ticks](std::size_t i) -> Vec3
    {
      const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(ticks);
      return (sphere_mm - 1.0) * Vec3(std::cos(a), 0.6 * std::sin(a), 0.8 * std::sin(a));
    });
  const double kept = static_cast<double>(simpler.tree->mesh().triangles.size());
  const std::string name = caseName({ { "triangles", static_cast<double>(mesh.triangles.size()) } });
  table.info({ name, "full", "triangles" }, static_cast<double>(mesh.triangles.size())).cost = seen.full;
  table
    .atMost(
      { name, "proven simpler", "share of triangles left" }, kept / static_cast<double>(mesh.triangles.size()), 0.5)
    .cost = seen.fewer;
  table.atMost(
    { name, "proven simpler", "difference of forces over the proven bound" }, seen.worst_mm / simpler.bound_u, 1.0);
  table.within({ name, "proven simpler", "ticks with a felt difference, share" }, seen.noticeable, 0.0, 0.0);
}

/// Bumps as short as 3 mm need their triangles: a rough sphere of a triangle a square millimetre keeps them all.
void roughKeepsItsTriangles(Table& table)
{
  const bool kept = !simplified(test::NoisySphere(20000, 1.0).mesh()).tree;
  table.within({ "noisy sphere", "proven simpler", "refused" }, kept, 1.0, 0.0);
}

} // namespace plan_experiment

void runPlan(const Conditions& conditions, Table& table)
{
  using namespace plan_experiment;
  treeAgainstList(conditions, table);
  conditions.progress(0.3);
  radiusAgainstWork(conditions, table);
  conditions.progress(0.8);
  fewerTriangles(conditions, table);
  roughKeepsItsTriangles(table);
  conditions.progress(1.0);
}

} // namespace palpate::lab
