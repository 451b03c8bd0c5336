// SPDX-License-Identifier: GPL-3.0-or-later
// Row 51: surfaces replaced ten times a second under a pressed hand.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "devices/FedDevice.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/session/HapticSession.h"
#include "testing/lab/Experiments.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace scene_swap_experiment
{

constexpr double size_m = 0.05, depth_m = 3e-3, displacement_m = 1e-3;
constexpr int ticksPerSwap = 100;

std::shared_ptr<const Scene> sceneWith(std::uint64_t revision, std::shared_ptr<const SurfaceTree> tree)
{
  return std::make_shared<const Scene>(revision, std::vector<Surface>{ { "surface", std::move(tree), {} } });
}

std::shared_ptr<const SurfaceTree> treeOf(const TriangleMesh& mesh)
{
  return std::make_shared<const SurfaceTree>(cleanMesh(mesh).mesh);
}

std::shared_ptr<const SurfaceTree> lifted(const SurfaceTree& tree)
{
  std::vector<Vec3> vertices_W = tree.mesh().vertices_W;
  for (Vec3& v : vertices_W)
  {
    v.z() += displacement_m;
  }
  RefitResult moved = tree.refitted(std::move(vertices_W));
  if (!moved.tree)
  {
    throw std::runtime_error(moved.refusal);
  }
  return std::move(moved.tree);
}

/// Two surfaces that take turns under the hand.
struct Pair
{
  const char* what;
  std::shared_ptr<const SurfaceTree> one, other;
};

std::vector<Pair> pairs()
{
  const TriangleMesh sphere = test::makeIcosphere(4, size_m);
  const auto tree = treeOf(sphere);
  return {
    { "swap=same", tree, treeOf(sphere) },
    { "swap=moved-1-mm", tree, lifted(*tree) },
    { "swap=built-1-mm-away", tree, treeOf(test::shifted(sphere, { 0, 0, displacement_m })) },
    { "swap=refined-4x", tree, treeOf(test::makeIcosphere(5, size_m)) },
    { "swap=other-topology", tree, treeOf(test::makeBox(Vec3::Constant(-size_m), Vec3::Constant(size_m))) },
  };
}

/// The outcome of a minute of swaps.
struct Felt
{
  int falls = 0;       ///< ticks in which the proxy was not in front of the surface
  double step_N = 0.0; ///< largest change of the force from one tick to the next
  std::uint64_t allocations = 0, frees = 0, locks = 0;
};

class Press
{
public:
  Press(const Pair& pair, double radius_m, double blend_s) : scenes_{ sceneWith(1, pair.one), sceneWith(2, pair.other) }
  {
    HapticParameters parameters;
    parameters.contact.radius_u = radius_m;
    parameters.sceneBlend_s = blend_s;
    demand(this->session_.setParameters(parameters));
    this->session_.setScene(this->scenes_[0]);
    SessionOptions options;
    options.virtualTime = true;
    demand(this->session_.start(std::make_unique<FedDevice>(), options));
    constexpr int approach = 1000, settle = 1000;
    for (int tick = 0; tick <= approach; ++tick)
    {
      const double height = 0.02 + radius_m - (0.02 + depth_m) * tick / approach;
      this->tick(at(height));
    }
    for (int tick = 0; tick < settle; ++tick)
    {
      this->tick(at(radius_m - depth_m));
    }
    this->felt_ = {};
  }

  Felt swapFor(int ticks, double radius_m)
  {
    for (int tick = 0; tick < ticks; ++tick)
    {
      if (tick % ticksPerSwap == 0)
      {
        this->session_.setScene(sceneWith(static_cast<std::uint64_t>(10 + tick),
          this->scenes_[tick / ticksPerSwap % 2 == 0 ? 1 : 0]->surfaces()[0].tree));
      }
      this->tick(at(radius_m - depth_m));
    }
    demand(this->session_.stop());
    return this->felt_;
  }

private:
  static void demand(const std::string& problem)
  {
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
    }
  }

  /// Straight above a facet near the top.
  [[nodiscard]] static Vec3 at(double height_m) { return { 1e-3, 2e-3, size_m + height_m }; }

  void tick(const Vec3& hand_W)
  {
    auto& device = static_cast<FedDevice&>(*this->session_.device());
    DeviceSample sample;
    sample.pose_D.p = hand_W;
    device.feed(sample);
    const test::AllocationGuard guard;
    (void)this->session_.step(1);
    this->felt_.allocations += guard.allocations();
    this->felt_.frees += guard.frees();
    this->felt_.locks += guard.locks();
    const HapticState& state = this->session_.state();
    const Vec3 force_N = state.rendered_D; // blended, before the limits of the device that would hide a step
    this->felt_.step_N = std::max(this->felt_.step_N, (force_N - this->last_N_).norm());
    this->last_N_ = force_N;
    // Every surface here is at least as high as the first one's facets, which lie within 0.3 mm of the sphere.
    const Vec3 pull_W = state.proxy_W.p - hand_W;
    this->felt_.falls += pull_W.z() < depth_m - 0.5e-3 ? 1 : 0;
  }

  HapticSession session_;
  std::array<std::shared_ptr<const Scene>, 2> scenes_;
  Vec3 last_N_ = Vec3::Zero();
  Felt felt_;
};

void judge(const Pair& pair, double radius_m, int ticks, Table& table)
{
  const std::string name = std::string(pair.what) + " " + caseName({ { "r", 1e3 * radius_m } });
  const char* const method = "hand-over and blend";
  const Felt felt = Press(pair, radius_m, HapticParameters{}.sceneBlend_s).swapFor(ticks, radius_m);
  table.atMost({ name, method, "ticks fallen through" }, felt.falls, 0.0);
  const bool same = pair.one->contentHash() == pair.other->contentHash();
  table.atMost({ name, method, "largest change of force in a tick", "N" }, felt.step_N, same ? 0.0 : 0.1);
  const Subject cost{ name, method, "allocations, frees and locks of the tick" };
  if (test::AllocationGuard::works())
  {
    table.atMost(cost, static_cast<double>(felt.allocations + felt.frees + felt.locks), 0.0);
  }
  else
  {
    table.absent(cost);
  }
}

} // namespace scene_swap_experiment

void runSceneSwap(const Conditions& conditions, Table& table)
{
  using namespace scene_swap_experiment;
  const int ticks = conditions.pick(3000, 60000, 60000);
  for (const double radius_m : { 0.0, 1e-3 })
  {
    const std::vector<Pair> all = pairs();
    for (const Pair& pair : all)
    {
      judge(pair, radius_m, ticks, table);
    }
    const std::string moved = std::string(all[1].what) + " " + caseName({ { "r", 1e3 * radius_m } });
    const Felt stepped = Press(all[1], radius_m, 0.0).swapFor(1000, radius_m);
    table.atLeast({ moved, "hand-over without blend", "largest change of force in a tick", "N" }, stepped.step_N, 0.1);
    conditions.progress(radius_m == 0.0 ? 0.5 : 1.0);
  }
}

} // namespace palpate::lab
