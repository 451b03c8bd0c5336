// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-build-bench: how long a surface takes from the raw mesh to a tree that can be touched, and how long when only
// its vertices have moved.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

template<class Call>
double seconds(Call call)
{
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The least of some runs [s].
struct Least
{
  double build_s = 1e9, refit_s = 1e9;
};

void report(const char* name, const std::shared_ptr<const TriangleMesh>& mesh, unsigned workers, int runs)
{
  auto moved = std::make_shared<TriangleMesh>(*mesh);
  for (Vec3& v_W : moved->vertices_W)
  {
    v_W *= 1.01;
  }
  Least least;
  for (int run = 0; run < runs; ++run)
  {
    SceneBuilder builder(workers);
    SceneBuildResult built;
    least.build_s = std::min(least.build_s, seconds([&] { built = builder.build({ { "s", mesh, {} } }); }));
    for (int again = 0; again < 2; ++again) // the first refit of a surface learns where its vertices have gone
    {
      built = builder.build({ { "s", moved, {} } });
      const double refit_s = seconds([&] { built = builder.build({ { "s", mesh, {} } }, built.scene.get()); });
      least.refit_s = std::min(least.refit_s, refit_s);
    }
  }
  const double millions = static_cast<double>(mesh->triangles.size()) / 1e6;
  std::printf("  %-6s %u thread%s  build %.3f s  refit %.3f s  per million triangles\n", name, workers,
    workers > 1 ? "s" : " ", least.build_s / millions, least.refit_s / millions);
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  std::size_t triangles = 1000000;
  int runs = 5;
  CLI::App app("Time from a raw mesh to a surface that can be touched");
  app.add_option("--triangles", triangles, "size of the sphere")->check(CLI::PositiveNumber);
  app.add_option("--runs", runs, "runs, of which the least time counts")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  const palpate::test::NoisySphere sphere(triangles, 1.0);
  const auto mesh = std::make_shared<const palpate::TriangleMesh>(sphere.mesh());
  palpate::test::Random random(palpate::test::testSeed(77));
  const auto soup =
    std::make_shared<const palpate::TriangleMesh>(palpate::test::shuffled(palpate::test::unwelded(*mesh), random));
  std::printf("sphere with bumps, %zu triangles, least of %d runs\n", mesh->triangles.size(), runs);
  for (const unsigned workers : { 1u, 2u })
  {
    palpate::test::report("mesh", mesh, workers, runs);
    palpate::test::report("soup", soup, workers, runs);
  }
  return 0;
}
