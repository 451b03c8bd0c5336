// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-tool-bench: cost of an update of a rigid tool in rich contact, beside a plain query of the same two trees of
// oriented boxes for near pairs.
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>

#include <CLI/CLI.hpp>

#include "haptics/tool/worker/ToolFollower.h"
#include "testing/support/CostSample.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Thread.h"
#include "testing/support/WindingHand.h"

namespace palpate::test
{
namespace
{

struct Options
{
  std::size_t updates = 1500;
  std::uint64_t work = 0; ///< that of a session
  double speed_mm_s = 100.0;
  bool large = false, withAssertions = false;
};

struct Case
{
  std::string name;
  TriangleMesh tool, scene;
  Pose start_W;
  std::function<Pose(double time_s)> hand;
};

Case noisySpheres(const std::string& name, std::size_t tool, std::size_t scene, const Options& options)
{
  return { name, scaled(NoisySphere(tool, 1.0).mesh(), 0.3), NoisySphere(scene, 1.0).mesh(),
    { Vec3(80.0, 0.0, 0.0), Quat::Identity() },
    [speed = options.speed_mm_s](double time_s) { return windingHand(time_s, speed); } };
}

/// A box cut into small triangles lies flat on a plane of triangles and slides.
Case flatOnFlat(int plane)
{
  Random random(testSeed(2002));
  TriangleMesh plate = makeSheet({ 40.0, 40.0, 28, 28, 0.0 }, random);
  append(plate, shifted(plate, Vec3(0.0, 0.0, 40.0)));
  return { "flat on flat", plate, makeSheet({ 200.0, 200.0, plane, plane, 0.3 }, random),
    { Vec3(0.0, 0.0, 21.0), Quat::Identity() }, [](double time_s) {
      return Pose{ Vec3(20.0 * std::sin(5.0 * time_s), 0.0, 18.0), Quat::Identity() };
    } };
}

/// A nut is turned on its screw and pulled to and fro: all of its thread is in contact.
Case nutOnScrew(int around)
{
  constexpr double pitch = 2.0, turn_rad_s = 6.0;
  const ThreadSize screw{ 5.0, pitch, 12.0 }, bore{ 5.3, pitch, 10.0 };
  TriangleMesh nut = threadMesh(bore, around);
  return { "nut on screw", nut, threadMesh(screw, around), { makeTool(nut).value.centre_W, Quat::Identity() },
    [start = makeTool(nut).value.centre_W](double time_s)
    {
      const double turn = 2.0 * std::sin(turn_rad_s / 2.0 * time_s);
      const double along = pitch * turn / (2.0 * std::numbers::pi) + 0.4 * std::sin(20.0 * time_s);
      return Pose{ start + Vec3(0.0, 0.0, along), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())) };
    } };
}

struct Figures
{
  double p50_us = 0.0, p99_us = 0.0, most_us = 0.0;
};

Figures figuresOf(const CostSample& sample)
{
  return { sample.quantile_us(0.5), sample.quantile_us(0.99), sample.quantile_us(1.0) };
}

void print(const char* what, const Figures& f)
{
  std::printf("  %-8s p50 %8.1f us  p99 %8.1f us  most %8.1f us\n", what, f.p50_us, f.p99_us, f.most_us);
}

/// The servo's cost of a set of contacts: points of a ball, pressed from all sides of a half space.
void solveCosts(std::size_t count, std::size_t rounds)
{
  Random random(testSeed(2003));
  const ProcessorClock clock;
  CostSample sample(rounds, clock);
  double sum = 0.0;
  for (std::size_t i = 0; i < rounds; ++i)
  {
    std::vector<MotionRow> rows(count);
    for (MotionRow& row : rows)
    {
      Vec3 n = random.direction();
      n.z() = std::abs(n.z());
      row = motionRow(n, random.direction(), random.uniform(-0.01, 0.0), 0.6);
    }
    const Vec6 wish = whitened(random.direction() - Vec3::UnitZ(), random.direction(), 0.6);
    sample.time([&] { sum += nearestMotion(rows, wish).y.x(); });
  }
  std::printf("  nearest motion, %3zu rows: p50 %6.2f us  p99 %6.2f us%s\n", count, sample.quantile_us(0.5),
    sample.quantile_us(0.99), std::isfinite(sum) ? "" : "  not finite");
}

/// Returns p50 of an update in queries.
double benchmark(const Case& c, const Options& options)
{
  const ToolMesh tool = makeTool(c.tool).value;
  TriangleMesh clean = cleanMesh(c.scene).mesh;
  const ProcessorClock clock;
  const std::int64_t begin_ns = clock.now_ns();
  const auto scene_W = makeToolScene(std::move(clean), tool);
  const double build_s = 1e-9 * static_cast<double>(clock.now_ns() - begin_ns);
  ToolMove move(tool, scene_W, tool.gyration_u);
  const std::string refusal = move.place(c.start_W);
  CostSample updates(options.updates, clock), queries(options.updates, clock);
  const std::uint64_t work = options.work > 0 ? options.work : ToolFollower::workOf(tool, *scene_W);
  std::size_t spent = 0, touching = 0, rows = 0, steps = 0;
  for (std::size_t i = 0; i < options.updates; ++i)
  {
    const Pose hand_W = c.hand(1e-3 * static_cast<double>(i));
    ToolUpdate done;
    updates.time([&] { done = move.update(hand_W, work); });
    spent += done.spent ? 1 : 0;
    steps += done.steps;
    touching += move.rows().empty() ? 0 : 1;
    rows = std::max(rows, move.rows().size());
    if (i % 20 == 0)
    {
      PairFront fresh(*tool.shape_B, *scene_W, tool.restGap_u());
      WorkBudget unlimited(1u << 30);
      queries.time([&] { static_cast<void>(fresh.gather(move.pose_W(), 0.3, unlimited)); });
    }
  }
  std::printf("%s: %zu on %zu triangles%s; built in %.2f s, %zu bytes a triangle; of %zu updates %zu touch, %zu out of "
              "work, %.1f steps each, at most %zu rows\n",
    c.name.c_str(), tool.shape_B->mesh().triangles.size(), scene_W->mesh().triangles.size(), refusal.c_str(), build_s,
    scene_W->nodes().size() * sizeof(BoxedMesh::Node) / scene_W->mesh().triangles.size() + 25, options.updates,
    touching, spent, static_cast<double>(steps) / static_cast<double>(options.updates), rows);
  const Figures update = figuresOf(updates), query = figuresOf(queries);
  print("update", update);
  print("query", query);
  return update.p50_us / query.p50_us;
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  using namespace palpate::test;
  Options options;
  CLI::App app("what an update of a rigid tool costs");
  app.add_option("--updates", options.updates, "1 ms each");
  app.add_option("--work", options.work, "of an update; without it that of a session");
  app.add_option("--speed", options.speed_mm_s, "of the hand, mm/s");
  app.add_flag("--large", options.large, "50 k on 1 M triangles too");
  app.add_flag("--assert", options.withAssertions, "fail if an update costs more queries than it may");
  CLI11_PARSE(app, argc, argv);
  constexpr double mostQueries = 4.0; // twice as many as are seen
  const double ratio = benchmark(noisySpheres("noisy spheres", 5000, 100000, options), options);
  benchmark(flatOnFlat(70), options);
  benchmark(nutOnScrew(240), options);
  if (options.large)
  {
    benchmark(noisySpheres("noisy spheres", 50000, 1000000, options), options);
  }
  for (const std::size_t rows : { 8u, 30u, 100u, 300u })
  {
    solveCosts(rows, 2000);
  }
  std::printf("ratio p50 %.2f\n", ratio);
  return ratio <= mostQueries || !options.withAssertions ? 0 : 1;
}
