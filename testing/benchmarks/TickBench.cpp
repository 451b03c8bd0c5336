// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-tick-bench: cost of one exact tick of contact at its median, in one of a hundred and at most, beside a walk
// of a plain tree in the same run.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/benchmarks/PlainWalk.h"
#include "testing/benchmarks/TickRows.h"
#include "testing/lab/backends/Backend.h"
#include "testing/support/Bender.h"
#include "testing/support/LeastCosts.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr int runs = 3;
constexpr int bendingRuns = 6; // building snapshots disturbs the caches, differently each time
/// The part of the ticks that is done. A snapshot is built for each 50 of them in each run, which takes eighty times as
/// long as they do.
constexpr std::size_t bendingShare = 4;

struct Options
{
  std::vector<std::size_t> triangles = { 100000, 1000000 };
  std::size_t ticks = 20000;
  double slack = 0.1; ///< how much more than the best a row may cost, as a share
  bool withAssertions = false;
};

/// Where the proxy was and where the device is, tick by tick.
struct Way
{
  Vec3 proxy_W, device_W;
};

std::vector<Vec3> devicePoints(const NoisySphere& sphere, std::size_t ticks)
{
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < ticks; ++i)
  {
    points.push_back(slideOver(sphere, i).p_W);
  }
  return points;
}

/// A slide over a scene that stands; `ways` receives each tick's displacement.
LeastCosts slide(const Scene& scene, const ContactPlan& plan, const Vec3& start_W, const std::vector<Vec3>& points,
  std::vector<Way>* ways = nullptr)
{
  return LeastCosts(runs,
    [&](auto call)
    {
      GodObjectState state;
      (void)moveGodObject(scene, plan, start_W, state);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (ways != nullptr)
        {
          ways->resize(points.size());
          (*ways)[i] = { state.x_W, points[i] };
        }
        call([&] { (void)moveGodObject(scene, plan, points[i], state); });
      }
    });
}

/// One query a tick: from where the proxy was to where the device is, which is the first thing a tick has to know.
template<class Query>
LeastCosts queries(const std::string& name, const std::vector<Way>& ways, Query query)
{
  std::size_t met = 0;
  LeastCosts costs(runs,
    [&](auto call)
    {
      for (const Way& way : ways)
      {
        call([&] { met += query(way) ? 1 : 0; });
      }
    });
  if (met == 0)
  {
    std::printf("  %s meets nothing: this is no comparison\n", name.c_str());
  }
  return costs;
}

/// A whole tick, by a hand that comes from outside. While the sphere bends, it swells and shrinks by a millimetre ten
/// times a second, in snapshots of 50 ms. Where the hand is, it is in metres. The program builds each snapshot on the
/// core of its ticks, which a session's servo does not. So a copy of the state ticks once more on the old snapshot
/// before each new one: code and data that building has displaced are in the caches again.
LeastCosts wholeTicks(const NoisySphere& sphere, const std::vector<Vec3>& points, bool bends)
{
  constexpr double perMetre = 1e3;
  TriangleMesh mesh = sphere.mesh();
  for (Vec3& v : mesh.vertices_W)
  {
    v /= perMetre;
  }
  const double share = bends ? 0.02 : 0.0;
  const auto swell = [share](const Vec3& v, double time_s)
  { return Vec3((1.0 + share * std::sin(62.8 * time_s)) * v); };
  const int ticksPerSnapshot = bends ? 50 : std::numeric_limits<int>::max();
  const Bender::Between between = bends ? Bender::Between::Moves : Bender::Between::Steps;
  return LeastCosts(bendingRuns,
    [&](auto call)
    {
      Bender bender(mesh, swell, ticksPerSnapshot, between);
      bender.parameters.contact.radius_u = 1e-3;
      (void)bender.tick(slideStart_W(sphere) / perMetre);
      TickOutput out;
      std::size_t touching = 0;
      bender.compute = [&](const TickInput& input)
      {
        if (input.previousScene != nullptr)
        {
          TickInput before = input;
          before.scene = std::exchange(before.previousScene, nullptr);
          const auto copy = std::make_unique<RendererState>(bender.state);
          (void)renderTick(before, bender.parameters, *copy);
        }
        call([&] { out = renderTick(input, bender.parameters, bender.state); });
        return out;
      };
      for (const Vec3& p_W : points)
      {
        touching += bender.tick(p_W / perMetre).state.contacts > 0 ? 1 : 0;
      }
      if (touching < points.size())
      {
        std::printf("  %zu ticks of %zu touch nothing: this is no slide\n", points.size() - touching, points.size());
      }
    });
}

/// Prints a row and says whether its costs are at most so much more than the best that were seen.
bool report(const std::string& name, std::size_t triangles, const LeastCosts& tick, double walk_us, double slack)
{
  const TickCosts in{ tick.quantile_us(0.5) / walk_us, tick.quantile_us(0.99) / walk_us,
    tick.quantile_us(1.0) / walk_us };
  const TickCosts* const best = bestOf(name, triangles);
  const double most = 1.0 + slack;
  const bool within =
    best == nullptr || (in.p50 <= most * best->p50 && in.p99 <= most * best->p99 && in.most <= most * best->most);
  std::printf("  %-16s p50 %7.2f us  p99 %7.2f us  most %7.1f us;  in walks %6.1f %6.1f %7.1f%s\n", name.c_str(),
    tick.quantile_us(0.5), tick.quantile_us(0.99), tick.quantile_us(1.0), in.p50, in.p99, in.most,
    within ? "" : "  OVER");
  if (!within)
  {
    std::printf(
      "    more than %.0f %% above the best: %.1f %.1f %.1f walks\n", 1e2 * slack, best->p50, best->p99, best->most);
  }
  return within;
}

/// True if one of three measurements keeps to the limit: a tick that costs more than before exceeds it in all of them,
/// and other work of the machine seldom does. `tick` and `walk_us` measure anew.
template<class Tick, class Walk>
bool keepsTo(const std::string& name, std::size_t triangles, double slack, Tick tick, Walk walk_us)
{
  constexpr int measurements = 3;
  bool within = false;
  for (int i = 0; i < measurements && !within; ++i)
  {
    within = report(name, triangles, tick(), walk_us(), slack);
  }
  return within;
}

/// A surface that stands, with its slides.
class Standing
{
public:
  Standing(const TriangleMesh& mesh, const NoisySphere& sphere, const std::vector<Vec3>& points, double slack)
    : scene_(SceneBuilder().build({ { "sphere", std::make_shared<TriangleMesh>(mesh), {} } }).scene), walk_(mesh),
      start_W_(slideStart_W(sphere)), points_(points), triangles_(mesh.triangles.size()), slack_(slack)
  {
    (void)slide(*this->scene_, ContactPlan{}, this->start_W_, points, &this->ways_);
  }

  [[nodiscard]] const Scene& scene() const { return *this->scene_; }
  [[nodiscard]] const std::vector<Way>& ways() const { return this->ways_; }
  /// Of the plain tree, along the paths of the point [us].
  [[nodiscard]] double walk_us() const
  {
    const auto hits = [this](const Way& way) { return this->walk_.firstHit(way.proxy_W, way.device_W) <= 1.0; };
    return queries("the plain tree", this->ways_, hits).quantile_us(0.5);
  }
  /// Measures the reference again beside each row: a machine's clock rate may change meanwhile.
  [[nodiscard]] bool row(const std::string& name, const ContactPlan& plan) const
  {
    return keepsTo(
      name, this->triangles_, this->slack_, [&] { return slide(*this->scene_, plan, this->start_W_, this->points_); },
      [this] { return this->walk_us(); });
  }

private:
  std::shared_ptr<const Scene> scene_;
  PlainWalk walk_;
  Vec3 start_W_;
  const std::vector<Vec3>& points_;
  std::size_t triangles_;
  double slack_;
  std::vector<Way> ways_;
};

ContactPlan ball()
{
  ContactPlan plan;
  plan.radius_u = 1.0;
  return plan;
}

/// The sphere with every vertex somewhere else by up to a tenth of a millimetre along each axis, as the noise of a scan
/// would have it.
TriangleMesh noisy(TriangleMesh mesh)
{
  Random random(testSeed(541));
  for (Vec3& v : mesh.vertices_W)
  {
    v += random.inCube(0.1);
  }
  return mesh;
}

/// Time of other libraries for one query, for information; nothing is asserted.
void reportOthers(const TriangleMesh& mesh, const std::vector<Way>& ways)
{
  for (const lab::BackendKind& kind : lab::backendKinds())
  {
    const std::string name = kind.name;
    if (kind.make != nullptr && name != "ours")
    {
      const auto backend = kind.make(mesh);
      const LeastCosts costs =
        queries(name, ways, [&](const Way& way) { return backend->meets(way.proxy_W, way.device_W); });
      std::printf("  one segment of %-22s p50 %7.2f us  p99 %7.2f us\n", name.c_str(), costs.quantile_us(0.5),
        costs.quantile_us(0.99));
    }
  }
}

bool benchmark(std::size_t triangles, const Options& options)
{
  const NoisySphere sphere(triangles, 1.0);
  const auto count = static_cast<double>(sphere.mesh().triangles.size());
  const std::vector<Vec3> points = devicePoints(sphere, options.ticks);
  const auto begin = std::chrono::steady_clock::now();
  const SceneBuildResult built =
    SceneBuilder().build({ { "sphere", std::make_shared<TriangleMesh>(sphere.mesh()), {} } });
  const double build_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Standing smooth(sphere.mesh(), sphere, points, options.slack),
    rough(noisy(sphere.mesh()), sphere, points, options.slack);
  std::printf(
    "sphere with bumps, %.0f triangles, %zu ticks of 1 ms at 100 mm/s, 1 to 2 mm deep\n", count, options.ticks);
  std::printf(
    "  build %.2f s per million triangles; beside the mesh %.0f MB per million triangles; a walk of the plain "
    "tree %.2f us\n",
    build_s * 1e6 / count, static_cast<double>(built.scene->surfaces()[0].tree->bytes()) / count, smooth.walk_us());
  ContactPlan friction = ball(), shading = ball();
  friction.friction = { 0.4, 0.3 };
  shading.shading = true;
  bool within = smooth.row("point", {});
  within = smooth.row("ball", ball()) && within;
  within = smooth.row("ball, friction", friction) && within;
  within = smooth.row("ball, shading", shading) && within;
  within = rough.row("point, noise", {}) && within;
  within = rough.row("ball, noise", ball()) && within;
  if (triangles <= 100000)
  {
    const std::vector<Vec3> bending(
      points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / bendingShare));
    for (const bool bends : { false, true })
    {
      within = keepsTo(
                 bends ? "ball, bending" : "ball, whole tick", sphere.mesh().triangles.size(), options.slack,
                 [&] { return wholeTicks(sphere, bending, bends); }, [&] { return smooth.walk_us(); }) &&
               within;
    }
  }
  if (!options.withAssertions)
  {
    reportOthers(sphere.mesh(), smooth.ways());
  }
  return within;
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  palpate::test::Options options;
  CLI::App app("Cost of one exact tick in sliding contact, as a ratio to a walk of a plain tree");
  app.add_option("--triangles", options.triangles, "sizes of the sphere")->check(CLI::PositiveNumber);
  app.add_option("--ticks", options.ticks, "ticks timed of each")->check(CLI::PositiveNumber);
  app.add_option("--slack", options.slack, "share by which a row may cost more than the best that was seen")
    ->check(CLI::NonNegativeNumber);
  app.add_flag("--assert", options.withAssertions, "exit 1 if a row costs more than that");
  CLI11_PARSE(app, argc, argv);
  bool within = true;
  for (const std::size_t triangles : options.triangles)
  {
    within = palpate::test::benchmark(triangles, options) && within;
  }
  return within || !options.withAssertions ? 0 : 1;
}
