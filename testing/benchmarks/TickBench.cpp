// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-tick-bench: what one exact tick of contact costs, beside a single query of other libraries in the same run.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/lab/backends/Backend.h"
#include "testing/support/CostSample.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

struct Options
{
  std::vector<std::size_t> triangles = { 100000, 1000000 };
  std::vector<double> radii_mm = { 0.0, 1.0 };
  std::size_t ticks = 30000;
  bool withAssertions = false;
};

struct Cost
{
  double p50_us, p99_us;
};

/// Where the proxy was and where the device is, tick by tick.
struct Way
{
  Vec3 proxy_W, device_W;
};

/// A library's answer to one collision query, to compare a tick with.
struct Reference
{
  std::string name;
  std::unique_ptr<lab::Backend> backend;
};

Cost costOf(const CostSample& sample)
{
  return { sample.quantile_us(0.5), sample.quantile_us(0.99) };
}

std::vector<Vec3> devicePoints(const NoisySphere& sphere, std::size_t ticks)
{
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < ticks; ++i)
  {
    points.push_back(slideOver(sphere, i).p_W);
  }
  return points;
}

/// The whole slide once to warm up and once timed; `ways` receives what happened.
Cost tickCost(
  const Scene& scene, double radius_u, const Vec3& start_W, const std::vector<Vec3>& points, std::vector<Way>& ways)
{
  ContactPlan plan;
  plan.radius_u = radius_u;
  CostSample sample(points.size());
  sample.timeWarm(
    [&](auto call)
    {
      GodObjectState state;
      (void)moveGodObject(scene, plan, start_W, state);
      ways.clear();
      for (const Vec3& p_W : points)
      {
        ways.push_back({ state.x_W, p_W });
        call([&] { (void)moveGodObject(scene, plan, p_W, state); });
      }
    });
  return costOf(sample);
}

/// One query a tick: from where the proxy was to where the device is, which is the first thing a tick has to know.
Cost referenceCost(const Reference& reference, const std::vector<Way>& ways)
{
  CostSample sample(ways.size());
  std::size_t met = 0;
  sample.timeWarm(
    [&](auto call)
    {
      for (const Way& way : ways)
      {
        call([&] { met += reference.backend->meets(way.proxy_W, way.device_W); });
      }
    });
  if (met == 0)
  {
    std::printf("  %s meets nothing: this is no comparison\n", reference.name.c_str());
  }
  return costOf(sample);
}

/// The libraries that a tick of contact is compared with, CGAL first.
std::vector<Reference> references(const TriangleMesh& mesh)
{
  std::vector<Reference> all;
  for (const lab::BackendKind& kind : lab::backendKinds())
  {
    const std::string name = kind.name;
    if (kind.make != nullptr && (name == "cgal" || name == "vtkStaticCellLocator"))
    {
      all.push_back({ name + ", one segment", kind.make(mesh) });
    }
  }
  return all;
}

/// Prints what a tick and a query of a reference cost; the ratio of their medians.
double reportRatio(double radius_mm, const Reference& other, const Cost& tick, const Cost& query)
{
  std::printf("  tick r = %-4g mm  p50 %7.2f us  p99 %7.2f us\n", radius_mm, tick.p50_us, tick.p99_us);
  std::printf("    %-30s p50 %7.2f us  p99 %7.2f us  ratios p50 %6.2f  p99 %6.2f\n", other.name.c_str(), query.p50_us,
    query.p99_us, tick.p50_us / query.p50_us, tick.p99_us / query.p99_us);
  return tick.p50_us / query.p50_us;
}

/// Twice the targets of row 54 at 100 000 triangles, 1.5 and 4 us, on a machine whose segment query takes 0.25 us
/// there.
bool isWithin(double radius_mm, double ratio)
{
  const double limit = radius_mm == 0.0 ? 12.0 : 32.0;
  if (ratio > limit)
  {
    std::printf("  OVER: a tick at r = %g mm costs %.1f segment queries, the limit is %.0f\n", radius_mm, ratio, limit);
  }
  return ratio <= limit;
}

bool benchmark(std::size_t triangles, const Options& options)
{
  const NoisySphere sphere(triangles, 1.0);
  const auto mesh = std::make_shared<TriangleMesh>(sphere.mesh());
  const auto begin = std::chrono::steady_clock::now();
  const SceneBuildResult built = SceneBuilder().build({ { "noisy sphere", mesh, {} } });
  const double build_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto count = static_cast<double>(mesh->triangles.size());
  std::printf("noisy sphere, %.0f triangles, %zu ticks of 1 ms at 100 mm/s, 1 to 2 mm deep\n", count, options.ticks);
  std::printf("  build %.2f s per million triangles; beside the mesh %.0f MB per million triangles\n",
    build_s * 1e6 / count, static_cast<double>(built.scene->surfaces()[0].tree->bytes()) / count);

  const std::vector<Vec3> points = devicePoints(sphere, options.ticks);
  std::vector<Way> pointWays, ways;
  (void)tickCost(*built.scene, 0.0, slideStart_W(sphere), points, pointWays); // which the queries follow
  const auto others = references(*mesh);
  bool within = true;
  for (const double r : options.radii_mm)
  {
    for (const Reference& other : others)
    {
      const auto [tick, query] =
        costsInTurn([&] { return tickCost(*built.scene, r, slideStart_W(sphere), points, ways); },
          [&] { return referenceCost(other, pointWays); });
      const double ratio = reportRatio(r, other, tick, query);
      within = (&other != &others.front() || isWithin(r, ratio)) && within; // CGAL's is the one that counts
    }
  }
  return within;
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  palpate::test::Options options;
  CLI::App app("Cost of one exact tick in sliding contact, as a ratio to single queries of other libraries");
  app.add_option("--triangles", options.triangles, "sizes of the noisy sphere")->check(CLI::PositiveNumber);
  app.add_option("--radius", options.radii_mm, "ball radii [mm]")->check(CLI::NonNegativeNumber);
  app.add_option("--ticks", options.ticks, "ticks timed of each")->check(CLI::PositiveNumber);
  app.add_flag("--assert", options.withAssertions, "exit 1 if a tick costs more than row 54 leaves room for");
  CLI11_PARSE(app, argc, argv);
  bool within = true;
  for (const std::size_t triangles : options.triangles)
  {
    within = palpate::test::benchmark(triangles, options) && within;
  }
  return within || !options.withAssertions ? 0 : 1;
}
