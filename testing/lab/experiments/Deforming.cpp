// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to keep a deforming surface felt: moving the vertices of its tree against building it anew, and that
// the moved tree holds a pressed hand where the surface is.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/SurfaceTree.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::lab
{
namespace
{

std::shared_ptr<const SurfaceTree> refitted(
  const SurfaceTree& tree, std::vector<Vec3> vertices_W, std::shared_ptr<const SurfaceTree> retired = nullptr)
{
  RefitResult result = tree.refitted(std::move(vertices_W), std::move(retired));
  if (!result.tree)
  {
    throw std::runtime_error(result.refusal);
  }
  return std::move(result.tree);
}

std::vector<Vec3> stretched(const std::vector<Vec3>& vertices_W, double factor)
{
  std::vector<Vec3> moved = vertices_W;
  for (Vec3& v : moved)
  {
    v *= factor;
  }
  return moved;
}

/// As a worker answers a stream of new vertices: the last tree is felt until the next one is there.
template <class Make>
Cost costOf(const std::vector<Vec3>& vertices_W, int repetitions, Make make)
{
  test::CostSample sample(static_cast<std::size_t>(repetitions));
  std::shared_ptr<const SurfaceTree> felt, retired;
  constexpr int first = -2; // the first ones pay for memory that the others use again
  for (int i = first; i < repetitions; ++i)
  {
    std::vector<Vec3> moved = stretched(vertices_W, 1.1 + 0.01 * i);
    std::shared_ptr<const SurfaceTree> next;
    const auto answer = [&] { next = make(std::move(moved), std::move(retired)); };
    i < 0 ? answer() : sample.time(answer);
    retired = std::exchange(felt, std::move(next));
  }
  return Cost::of(sample);
}

/// Building cleans the triangles first, as they come; moving has done so once.
void compareCost(std::size_t triangles, int repetitions, Table& table)
{
  const test::NoisySphere sphere(triangles, 1e-3);
  const std::string name = caseName({ { "triangles", static_cast<double>(triangles) } });
  const Cost build = costOf(sphere.mesh().vertices_W, repetitions,
    [&](std::vector<Vec3> moved_W, const std::shared_ptr<const SurfaceTree>&) {
      return std::make_shared<const SurfaceTree>(cleanMesh({ std::move(moved_W), sphere.mesh().triangles }).mesh);
    });
  const SurfaceTree first(cleanMesh(sphere.mesh()).mesh);
  const Cost move = costOf(first.mesh().vertices_W, repetitions,
    [&](std::vector<Vec3> moved_W, std::shared_ptr<const SurfaceTree> retired)
    { return refitted(first, std::move(moved_W), std::move(retired)); });
  table.info({ name, "build", "triangles" }, static_cast<double>(first.mesh().triangles.size())).cost = build;
  const bool quarter = 4 * move.p50_us <= build.p50_us;
  table.atLeast({ name, "refit", "refit costs at most a quarter of a build" }, quarter ? 1.0 : 0.0, 1.0).cost = move;
}

/// What a hand feels on a smooth sphere that breathes when a method answers for new vertices.
struct Breath
{
  double radius_m = 0.05;
  [[nodiscard]] double factor(double time_s) const { return 1.0 + 0.1 * std::sin(2 * std::numbers::pi * time_s); }
};

/// Presses 3 mm into the smallest sphere for some breaths, with a new mesh every 16 ticks. `keep`: with a hand-over;
/// without one the point stays where it was, as where a scene is replaced under it.
int falls(const SurfaceTree& first, double ball_m, int ticks, bool keep)
{
  const Breath breath;
  ContactPlan plan;
  plan.radius_u = ball_m;
  auto scene = std::make_shared<const Scene>(
    1, std::vector<Surface>{ { "sphere", refitted(first, first.mesh().vertices_W), {} } });
  GodObjectState state;
  static_cast<void>(moveGodObject(*scene, plan, { 0.01, 0.02, 0.1 }, state));
  int through = 0;
  for (int i = 1; i <= ticks; ++i)
  {
    const double time_s = 1e-3 * i;
    const Vec3 p = 0.043 * Vec3(std::sin(3 * time_s), 0.4 * std::cos(2 * time_s), std::cos(3 * time_s)).normalized();
    if (i % 16 == 0)
    {
      const auto tree = refitted(first, stretched(first.mesh().vertices_W, breath.factor(time_s)));
      const auto next =
        std::make_shared<const Scene>(scene->revision() + 1, std::vector<Surface>{ { "sphere", tree, {} } });
      if (keep)
      {
        handOver(*scene, *next, plan, p, state);
      }
      else
      {
        state.count = 0;
      }
      scene = next;
    }
    static_cast<void>(moveGodObject(*scene, plan, p, state));
    through += state.x_W.norm() < 0.0435 ? 1 : 0; // 1 mm below the smallest sphere and its facets, where the hand is
  }
  return through;
}

} // namespace

void runDeforming(const Conditions& conditions, Table& table)
{
  const SurfaceTree sphere(cleanMesh(test::makeIcosphere(5, 0.05)).mesh);
  const int ticks = conditions.pick(2000, 10000, 60000);
  for (const double ball_m : { 0.0, 1e-3 })
  {
    const std::string name = caseName({ { "r", 1e3 * ball_m }, { "seconds", 1e-3 * ticks } });
    table.atMost({ name, "refit and hand-over", "ticks below the surface" }, falls(sphere, ball_m, ticks, true), 0.0);
  }
  const std::string point = caseName({ { "r", 0.0 }, { "seconds", 1e-3 * ticks } });
  table.atLeast(
    { point, "new mesh, point where it was", "ticks below the surface" }, falls(sphere, 0.0, ticks, false), 1.0);
  conditions.progress(0.3);
  compareCost(100000, conditions.pick(5, 9, 15), table);
  conditions.progress(0.5);
  if (conditions.size != Size::Quick)
  {
    compareCost(1000000, 5, table);
  }
}

} // namespace palpate::lab
