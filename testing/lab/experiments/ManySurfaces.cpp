// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of one to a thousand surfaces are felt as the one mesh of all their triangles, and cost about as much.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/methods/StaticFrameProxy.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace many_surfaces_experiment
{

constexpr double largest_m = 0.04;

/// Spheres of 4 to 40 mm in a cube of 100 mm about the largest: many overlap, every fifth is a shell inside the one
/// before it.
std::vector<TriangleMesh> crowd(std::size_t count, test::Random& random)
{
  double radius_m = largest_m;
  Vec3 centre_W = Vec3::Zero();
  std::vector<TriangleMesh> meshes;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i % 5 == 4)
    {
      radius_m *= 0.5;
    }
    else if (i > 0)
    {
      radius_m = 0.1 * largest_m * std::pow(10.0, random.uniform());
      centre_W = random.inCube(0.05);
    }
    meshes.push_back(test::shifted(test::makeIcosphere(2, radius_m), centre_W));
  }
  return meshes;
}

std::shared_ptr<const Scene> sceneOfMany(const std::vector<TriangleMesh>& meshes)
{
  std::vector<SurfaceInput> inputs;
  for (const TriangleMesh& mesh : meshes)
  {
    inputs.push_back({ "part " + std::to_string(inputs.size()), std::make_shared<TriangleMesh>(mesh), {} });
  }
  return SceneBuilder().build(inputs).scene;
}

TriangleMesh merged(const std::vector<TriangleMesh>& meshes)
{
  TriangleMesh whole;
  for (const TriangleMesh& mesh : meshes)
  {
    append(whole, mesh);
  }
  return whole;
}

const Vec3 start_W(0, 0, 0.2), landing_W(0, 0, 0.039);

/// A hand that pulls the proxy over all bumps, at up to 0.3 m/s round and round, and presses it to the middle a sixth
/// as much: slopes of up to 80 degrees do not stop it. From steeper ones it hops a millimetre outwards.
Vec3 pull_W(const Vec3& x_W, int tick, bool stopped)
{
  const double a = 2.8e-3 * tick, b = 0.3 * a;
  const Vec3 axis(std::cos(b), std::sin(b), 0.3 * std::sin(a));
  const Vec3 inwards = -x_W.normalized();
  return x_W + (stopped ? -1e-3 : 5e-5) * inwards + 3e-4 * axis.cross(inwards).normalized();
}

struct Comparison
{
  double apart_m = 0.0;  ///< largest distance between the two proxies
  double contacts = 0.0; ///< ticks in contact, without which nothing is compared
  double way_m = 0.0;    ///< of the proxy, without which it is no slide
  Cost many, one;
  std::vector<Vec3> path_W; ///< of the device
};

/// The same path in both scenes, tick by tick in turn, so that a change of the machine's pace meets both.
Comparison compare(
  const std::shared_ptr<const Scene>& many, const std::shared_ptr<const Scene>& one, double radius_m, int ticks)
{
  test::Probe apart(many, radius_m, start_W), together(one, radius_m, start_W);
  test::CostSample manyCost(static_cast<std::size_t>(ticks)), oneCost(static_cast<std::size_t>(ticks));
  apart.to(landing_W);
  Comparison seen;
  Vec3 x_W = together.to(landing_W).proxy_W;
  bool stopped = false;
  for (int i = 0; i < ticks; ++i)
  {
    seen.path_W.push_back(pull_W(x_W, i, stopped));
    ContactResult a, b;
    manyCost.time([&] { a = apart.to(seen.path_W.back()); });
    oneCost.time([&] { b = together.to(seen.path_W.back()); });
    seen.apart_m = std::max(seen.apart_m, (a.proxy_W - b.proxy_W).norm());
    seen.contacts += a.contacts > 0;
    const double way_m = (b.proxy_W - x_W).norm();
    seen.way_m += way_m;
    stopped = way_m < 1e-5;
    x_W = b.proxy_W;
  }
  seen.many = Cost::of(manyCost);
  seen.one = Cost::of(oneCost);
  return seen;
}

struct EachAsked
{
  Cost each, merged;
};

/// A proxy without anything above the surfaces, each of which is asked, and a point on the merged mesh beside it.
EachAsked askEach(
  const std::vector<TriangleMesh>& meshes, const std::shared_ptr<const Scene>& one, const std::vector<Vec3>& path_W)
{
  StaticFrameProxy proxy(meshes, start_W);
  test::Probe together(one, 0.0, start_W);
  const std::vector<Pose> poses(meshes.size());
  test::CostSample each(path_W.size()), merged(path_W.size());
  for (const Vec3& p_W : path_W)
  {
    each.time([&] { (void)proxy.tick(poses, p_W); });
    merged.time([&] { (void)together.to(p_W); });
  }
  return { Cost::of(each), Cost::of(merged) };
}

void runCount(std::size_t count, int ticks, std::uint64_t seed, Table& table)
{
  test::Random random(seed);
  const std::vector<TriangleMesh> meshes = crowd(count, random);
  const auto many = sceneOfMany(meshes), one = test::sceneOf(merged(meshes));
  std::vector<Vec3> path_W;
  for (const double radius_m : { 0.0, 5e-4 })
  {
    const std::string name = caseName({ { "surfaces", static_cast<double>(count) }, { "r_mm", 1e3 * radius_m } });
    const Comparison seen = compare(many, one, radius_m, ticks);
    path_W = seen.path_W;
    table.atMost({ name, "god-object", "distance from the proxy of the merged mesh", "m" }, seen.apart_m, 1e-9);
    table.atLeast({ name, "god-object", "ticks in contact" }, seen.contacts, 0.5 * ticks);
    table.atLeast({ name, "god-object", "way of a tick, mean", "m" }, seen.way_m / ticks, 1e-4);
    const bool cheap = seen.many.p50_us <= 2 * seen.one.p50_us;
    table.within({ name, "god-object", "p50 within 2 ticks on the merged mesh" }, cheap, 1.0, 0.0).cost = seen.many;
    table.info({ name, "merged", "surfaces" }, 1.0).cost = seen.one;
  }
  const EachAsked asked = askEach(meshes, one, path_W);
  const std::string name = caseName({ { "surfaces", static_cast<double>(count) } });
  if (count >= 1000)
  {
    const bool dear = asked.each.p50_us > 2 * asked.merged.p50_us;
    table.within({ name, "each-in-turn", "p50 above 2 ticks on the merged mesh" }, dear, 1.0, 0.0).cost = asked.each;
    return;
  }
  table.info({ name, "each-in-turn", "surfaces" }, static_cast<double>(count)).cost = asked.each;
}

} // namespace many_surfaces_experiment

void runManySurfaces(const Conditions& conditions, Table& table)
{
  using namespace many_surfaces_experiment;
  double done = 0.0;
  for (const std::size_t count : { 1u, 10u, 100u, 1000u })
  {
    runCount(count, conditions.pick(1500, 10000, 100000), conditions.seed, table);
    conditions.progress(done += 0.25);
  }
}

} // namespace palpate::lab
