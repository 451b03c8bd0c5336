// SPDX-License-Identifier: GPL-3.0-or-later
// Shots of meshes in the hand at a soft block: neither body ends in the other.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "HeldMesh.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/mesh/TriangleWeights.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// The nearest place of a closed surface to a point that is in it; no triangle: it is not.
struct Foot
{
  std::uint32_t triangle = SurfaceData::none;
  Vec3 p_W = Vec3::Zero();
  double away_u = std::numeric_limits<double>::infinity();
};

Foot footIn(const SurfaceTree& surface, const Vec3& p)
{
  const SurfaceData& data = surface.data();
  const bool near = ((p - data.low_W).array() > 0.0).all() && ((data.high_W - p).array() > 0.0).all();
  Foot foot;
  if (!near || sideOf(surface, p) != PointSide::Inside)
  {
    return foot;
  }
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    const auto corner = data.cornersOf(t);
    const Vec3 on_W = nearestOnTriangle(p, corner[0], corner[1], corner[2]);
    if ((p - on_W).norm() < foot.away_u)
    {
      foot = { t, on_W, (p - on_W).norm() };
    }
  }
  return foot;
}

/// How far the deepest vertex of either body is in the other. Between its vertices the block's surface is where the
/// compliance of its points says, which is deeper under a force than the plane of the bent vertices.
double deepest(
  const MechanismResult& result, const PressedBody& body, const SurfaceTree& tool, const std::vector<Vec3>& bent_W)
{
  double deepest = 0.0;
  const SurfaceTree& rest = *body.scene->surfaces().front().tree;
  const auto bent = rest.refitted(bent_W).tree;
  for (const Vec3& p : tool.mesh().vertices_W)
  {
    const Foot foot = footIn(*bent, p);
    if (foot.triangle == SurfaceData::none)
    {
      continue;
    }
    const auto& corners = rest.mesh().triangles[foot.triangle];
    const Vec3 weights = weightsOnTriangle(bent_W[corners[0]], bent_W[corners[1]], bent_W[corners[2]], foot.p_W);
    SurfacePoint place{ corners, weights, Vec3::Zero() };
    for (int c = 0; c < 3; ++c)
    {
      place.x_W += weights[c] * body.snapshot->free_W[corners[c]];
    }
    const CompliantPoint at = compliantPoint(*body.snapshot, place);
    Vec3 own_W = Vec3::Zero();
    for (int k = 0; k < result.pressCount; ++k)
    {
      const MechanismPress& press = result.presses[static_cast<std::size_t>(k)];
      const CompliantPoint from = compliantPoint(*body.snapshot, press.at);
      own_W += sharedBy(at, from) * at.own * from.own.transpose() * press.force_N;
    }
    deepest = std::max(deepest, foot.away_u - std::abs(own_W.dot((foot.p_W - p).normalized())));
  }
  for (const Vec3& p : bent_W)
  {
    const Foot foot = footIn(tool, p);
    deepest = foot.triangle == SurfaceData::none ? deepest : std::max(deepest, foot.away_u);
  }
  return deepest;
}

/// A shot of a tool at the block, as it ends.
class Shot
{
public:
  Shot(const Range& range, Random& random) : range_(range), finder_(range.meshes(), range.plan.held, range.most)
  {
    this->finder_.add(1, range.body, padYoung_Pa);
    const Vec3 aim = middleOfPad() + Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), -0.008);
    Vec3 way = random.direction();
    way.z() = std::abs(way.z()) + 0.3;
    this->from_ = aim + random.uniform(0.05, 0.08) * way.normalized();
    this->to_ = aim + Vec3(0, 0, random.uniform(0.0, 0.008));
    this->turn_ = Eigen::AngleAxisd(random.uniform(0, 3), random.direction());
    this->spin_ = random.uniform(0.0, 10.0) * random.direction();
    this->ticks_ = static_cast<int>(std::lround((this->to_ - this->from_).norm() / (0.5 * 1e-3)));
  }

  /// The deepest point of either body in the other.
  double run()
  {
    constexpr int answer = 33, rest = 150;
    for (int i = 0; i < this->ticks_ + rest; ++i)
    {
      if (i % answer == 0)
      {
        this->find(i);
      }
      this->step(i);
    }
    std::vector<Vec3> tool_W;
    for (const Vec3& p : this->range_.mesh->tree->mesh().vertices_W)
    {
      tool_W.push_back(this->result_.pose_W[0] * p);
    }
    const auto tool = this->range_.mesh->tree->refitted(tool_W).tree;
    return deepest(this->result_, this->range_.body, *tool, bentBy(this->result_, this->range_.body));
  }

  [[nodiscard]] double force_N() const { return this->result_.exact_W.force.norm(); }

private:
  [[nodiscard]] Pose handAt(int i) const
  {
    const double t = std::min(1.0, static_cast<double>(i) / this->ticks_);
    const Vec3 turn = 1e-3 * std::min(i, this->ticks_) * this->spin_;
    return { this->from_ + t * (this->to_ - this->from_),
      Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * this->turn_ };
  }

  void find(int i)
  {
    const Pose at = i == 0 ? this->handAt(0) : this->result_.pose_W[0];
    FinderView view;
    view.pose_W = { &at, 1 };
    view.held = { 0.25 * this->range_.mesh->diagonal_u + 0.05, 0.03 * this->range_.mesh->diagonal_u };
    view.soft = this->soft_;
    view.presses = { this->result_.presses.data(), static_cast<std::size_t>(this->result_.pressCount) };
    (void)this->finder_.find(view);
  }

  void step(int i)
  {
    MechanismInput input;
    input.tick = static_cast<std::uint64_t>(i + 1);
    input.plan = &this->range_.plan;
    input.hand_W = this->handAt(i);
    input.grip = { 1000.0, 2.0 };
    input.soft = this->soft_;
    input.found = &this->finder_.last();
    this->result_ = this->tick_.step(input);
  }

  const Range& range_;
  ContactFinder finder_;
  MechanismTick tick_;
  MechanismResult result_;
  std::array<const PressedBody*, 1> soft_{ &range_.body };
  Vec3 from_, to_, spin_;
  Quat turn_;
  int ticks_ = 0;
};

TEST(FoundShots, RandomShotsEndWithNeitherBodyInTheOther)
{
  const MeshTouch first(meshOnPad(makeIcosphere(1, 0.01), 8));
  const PressedBody& block = *first.touch().bodies().newest().front();
  const std::array<TriangleMesh, 3> tools{ makeBox(Vec3(-0.008, -0.005, -0.003), Vec3(0.008, 0.005, 0.003)),
    makeBox(Vec3(-0.015, -0.015, -0.001), Vec3(0.015, 0.015, 0.001)), makeIcosphere(2, 0.012) };
  Random random(testSeed(343));
  int touched = 0;
  double most = 0.0;
  const std::size_t count = testCount(60);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Range range(tools[i % tools.size()], block, i % 2 == 0 ? 0.4 : 0.0);
    Shot shot(range, random);
    const double in = shot.run();
    touched += shot.force_N() > 0.1;
    most = std::max(most, in);
  }
  EXPECT_GT(touched, static_cast<int>(count) / 2);
  // Places less than an edge apart whose normals are within acos .9 are one contact: so far the surfaces part there.
  const double edge = 0.1 / 8.0;
  EXPECT_LT(most, 0.5 * edge);
}

} // namespace
} // namespace palpate::test
