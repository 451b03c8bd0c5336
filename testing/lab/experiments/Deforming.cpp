// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a surface between two snapshots, in motion or in steps, and the cost of keeping it felt: moving the
// vertices of its tree against building it anew, and a tick in motion against one on a surface that stands.
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/carry/HandOver.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Bender.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::lab
{
namespace deforming_experiment
{

std::shared_ptr<const SurfaceTree> refitted(const SurfaceTree& tree, std::vector<Vec3> vertices_W,
  std::shared_ptr<const SurfaceTree> retired = nullptr, const VertexWay* way = nullptr)
{
  RefitResult result = tree.refitted(std::move(vertices_W), std::move(retired), way);
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

/// A worker that answers a stream of moved vertices: the last tree is felt until the next one is there.
class Worker
{
public:
  using Tree = std::shared_ptr<const SurfaceTree>;
  using Make = std::function<Tree(std::vector<Vec3> moved_W, Tree retired)>;

  Worker(const std::vector<Vec3>& vertices_W, int repetitions, Make make)
    : vertices_W_(vertices_W), make_(std::move(make)), times_(static_cast<std::size_t>(repetitions))
  {
  }

  void answer(double factor, bool timed)
  {
    std::vector<Vec3> moved_W = stretched(this->vertices_W_, factor);
    Tree next;
    const auto make = [&] { next = this->make_(std::move(moved_W), std::move(this->retired_)); };
    timed ? this->times_.time(make) : make();
    this->retired_ = std::exchange(this->felt_, std::move(next));
  }
  [[nodiscard]] const test::CostSample& times() const { return this->times_; }

private:
  const std::vector<Vec3>& vertices_W_;
  Make make_;
  test::CostSample times_;
  Tree felt_, retired_;
};

/// The workers answer in turn, so that whatever else the machine does meets them all alike.
void answerInTurn(int repetitions, std::initializer_list<Worker*> workers)
{
  constexpr int first = -2; // the first ones pay for memory that the others use again
  for (int i = first; i < repetitions; ++i)
  {
    for (Worker* worker : workers)
    {
      worker->answer(1.1 + 0.01 * i, i >= 0);
    }
  }
}

/// Building cleans the triangles first, as they come; moving has done so once. Judged by the least time of each, which
/// is the one that nothing else on the machine has lengthened.
void compareCost(std::size_t triangles, int repetitions, Table& table)
{
  const TriangleMesh mesh = test::NoisySphere(triangles, 1e-3).mesh();
  const SurfaceTree first(cleanMesh(mesh).mesh);
  const std::vector<Vec3>& vertices_W = first.mesh().vertices_W;
  const std::vector<Vec3> began_W = stretched(vertices_W, 1.05);
  const VertexWay way{ 1, { &began_W, &vertices_W } }; // a snapshot that came early: three places
  Worker build(mesh.vertices_W, repetitions,
    [&](std::vector<Vec3> moved_W, const Worker::Tree&) {
      return std::make_shared<const SurfaceTree>(cleanMesh({ std::move(moved_W), mesh.triangles }).mesh);
    });
  Worker move(vertices_W, repetitions,
    [&](std::vector<Vec3> moved_W, Worker::Tree retired)
    { return refitted(first, std::move(moved_W), std::move(retired)); });
  Worker come(vertices_W, repetitions,
    [&](std::vector<Vec3> moved_W, Worker::Tree retired)
    { return refitted(first, std::move(moved_W), std::move(retired), &way); });
  answerInTurn(repetitions, { &build, &move, &come });

  const std::string name = caseName({ { "triangles", static_cast<double>(triangles) } });
  const auto count = static_cast<double>(first.mesh().triangles.size());
  table.info({ name, "build", "triangles" }, count).cost = Cost::of(build.times());
  const auto judge = [&](const char* method, const char* judged, const Worker& worker, double most)
  {
    const double share = worker.times().quantile_us(0.0) / build.times().quantile_us(0.0);
    table.atLeast({ name, method, judged }, share <= most ? 1.0 : 0.0, 1.0).cost = Cost::of(worker.times());
  };
  // A sixth alone; beside other work, which lengthens waits for memory most, up to 0.28 was seen.
  judge("refit", "refit costs at most a third of a build", move, 1.0 / 3.0);
  // Boxes and balls of three places, each read through the triangles: 0.46 alone, a half beside other work.
  judge("refit for a way", "refit costs at most 0.6 of a build", come, 0.6);
}

constexpr double K = 1000.0, T = 1e-3;
constexpr double mostTickRatio = 10.0;
constexpr int at20Hz = 50; // ticks a snapshot

TriangleMesh sheet()
{
  test::Random random(test::testSeed(431));
  return test::makeSheet({ 0.2, 0.2, 30, 30, 0.2 }, random);
}

struct Felt
{
  double wrong_N = 0.0; ///< against the straight motion between the snapshots
  double step_N = 0.0;  ///< largest change from one tick to the next
};

/// A flat sheet that rises at 50 mm/s under a hand at rest, its snapshots 20 a second.
Felt feelRise(test::Bender::Between between, double blend_s, double ball_m, int ticks)
{
  constexpr double speed = 0.05;
  test::Bender rising(
    sheet(), [](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, speed * t_s)); }, at20Hz, between);
  rising.parameters.contact.radius_u = ball_m;
  rising.parameters.sceneBlend_s = blend_s;
  const Vec3 hand_W(0.0031, 0.0023, ball_m - 1e-3);
  static_cast<void>(rising.tick(hand_W + Vec3(0, 0, 0.01)));
  Felt felt;
  double before_N = rising.tick(hand_W).state.force_D.z();
  for (int i = 3; i <= ticks; ++i)
  {
    const double force_N = rising.tick(hand_W).state.force_D.z();
    felt.wrong_N = std::max(felt.wrong_N, std::abs(force_N - K * (speed * T * i + 1e-3)));
    felt.step_N = std::max(felt.step_N, std::abs(force_N - before_N));
    before_N = force_N;
  }
  return felt;
}

void compareRise(int ticks, Table& table)
{
  constexpr double perTick_N = K * 0.05 * T, perSnapshot_N = at20Hz * perTick_N;
  for (const double ball_m : { 0.0, 1e-3 })
  {
    const std::string name = "sheet rises at 50 mm/s, 20 Hz " + caseName({ { "r", 1e3 * ball_m } });
    const Felt way = feelRise(test::Bender::Between::Moves, 0.03, ball_m, ticks);
    table.atMost({ name, "on its way", "error of the force", "N" }, way.wrong_N, 1e-9);
    table.within({ name, "on its way", "largest step of the force", "N" }, way.step_N, perTick_N, 1e-9);
    const Felt step = feelRise(test::Bender::Between::Steps, 0.0, ball_m, ticks);
    table.atLeast({ name, "a step a snapshot", "largest step of the force", "N" }, step.step_N, 0.99 * perSnapshot_N);
    const Felt blended = feelRise(test::Bender::Between::Steps, 0.03, ball_m, ticks);
    table.atLeast(
      { name, "a step a snapshot, force blended", "error of the force", "N" }, blended.wrong_N, 0.2 * perSnapshot_N);
  }
}

/// A bump that shoots up to a hand over its flank, at rest in the air or pressed; snapshots 100 a second.
int passes(double speed, double depth_m, double ball_m)
{
  const auto height = [=](double x, double y, double t_s)
  { return speed * t_s * std::exp(-(x * x + y * y) / (0.03 * 0.03)); };
  test::Bender bump(
    sheet(), [=](const Vec3& v, double t_s) { return Vec3(v.x(), v.y(), height(v.x(), v.y(), t_s)); }, 10);
  bump.parameters.contact.radius_u = ball_m;
  const Vec3 hand_W(0.0131, 0.0043, ball_m - depth_m);
  static_cast<void>(bump.tick({ hand_W.x(), hand_W.y(), 0.03 }));
  int through = 0;
  // Facets lie below the bump by less than its curvature times an edge squared, which grows with its height.
  for (int i = 2; i <= std::min(400, static_cast<int>(200.0 / speed)); ++i)
  {
    const Vec3 x = bump.tick(hand_W).state.proxy_W.p;
    const double top = height(x.x(), x.y(), T * i), edge = 1.6 * 0.2 / 30;
    const double facet = 2.0 * speed * T * (i + 10) / (0.03 * 0.03) * edge * edge / 2;
    through += x.z() < top - facet ? 1 : 0;
  }
  return through;
}

/// The same stroke over a noisy sphere that stands and one whose vertices are in motion.
void compareTicks(std::size_t triangles, int ticks, Table& table)
{
  const test::NoisySphere sphere(triangles, 1e-3);
  const SurfaceTree first(cleanMesh(sphere.mesh()).mesh);
  const std::vector<Vec3>& begin = first.mesh().vertices_W;
  const VertexWay way{ 1, { &begin } };
  const std::vector<Vec3> end = stretched(begin, 1.01);
  Surface bending{ "it", refitted(first, end, nullptr, &way), {} };
  bending.from = std::make_shared<const VertexStart>(begin, 0);
  const Scene moving(1, { bending }, T * ticks), standing(2, { { "it", refitted(first, end), {} } });
  ContactPlan plan;
  plan.radius_u = 1e-3;
  const auto handAt = [&](int i)
  {
    const double turn = 1e-3 * i;
    return Vec3(0.047 * Vec3(std::sin(turn), 0.3, std::cos(turn)).normalized());
  };
  GodObjectState a, b;
  static_cast<void>(moveGodObject(standing, plan, 1.5 * handAt(0), a));
  static_cast<void>(moveGodObject(MovingScene(moving, 0.0), plan, 1.5 * handAt(0), b));
  test::CostSample stillTimes(static_cast<std::size_t>(ticks)), wayTimes(static_cast<std::size_t>(ticks));
  for (int i = 1; i <= ticks; ++i) // in turn, so that whatever else the machine does meets both alike
  {
    stillTimes.time([&] { static_cast<void>(moveGodObject(standing, plan, handAt(i), a)); });
    wayTimes.time(
      [&]
      {
        const double share = static_cast<double>(i) / ticks, before = static_cast<double>(i - 1) / ticks;
        const MovingScene was(moving, before), is(moving, share);
        static_cast<void>(carryWithVertices(was, is, plan, b));
        static_cast<void>(moveGodObject(is, plan, handAt(i), b));
      });
  }
  const Cost still = Cost::of(stillTimes), onWay = Cost::of(wayTimes);
  const std::string name = caseName({ { "triangles", static_cast<double>(triangles) }, { "r", 1.0 } });
  table.info({ name, "standing", "ticks" }, ticks).cost = still;
  // A triangle that is met is computed again each time it is asked for: that costs most where most are near, in the
  // slowest ticks. These must stay in step.
  const bool bounded = onWay.p99_us <= mostTickRatio * still.p99_us;
  table
    .atLeast(
      { name, "on its way", "the slowest hundredth of ticks takes at most 10 times as long" }, bounded ? 1.0 : 0.0, 1.0)
    .cost = onWay;
}

/// The force on a hand on a smooth sphere that breathes when a method answers for new vertices.
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
        static_cast<void>(handOver(*scene, *next, plan, p, state));
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

} // namespace deforming_experiment

void runDeforming(const Conditions& conditions, Table& table)
{
  using namespace deforming_experiment;
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
  compareRise(conditions.pick(200, 400, 4000), table);
  for (const double speed : { 0.1, 1.0, 5.0 })
  {
    for (const double ball_m : { 0.0, 1e-3 })
    {
      const std::string name = "bump shoots at the hand " + caseName({ { "speed", speed }, { "r", 1e3 * ball_m } });
      const int through = passes(speed, -0.02, ball_m) + passes(speed, 2e-3, ball_m);
      table.atMost({ name, "on its way", "ticks below the surface" }, through, 0.0);
    }
  }
  compareTicks(100000, conditions.pick(500, 2000, 20000), table);
  conditions.progress(0.3);
  compareCost(100000, conditions.pick(5, 9, 15), table);
  conditions.progress(0.5);
  if (conditions.size != Size::Quick)
  {
    compareCost(1000000, 5, table);
  }
}

} // namespace palpate::lab
