// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <mutex>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/session/soft/BodyMaker.h"
#include "haptics/session/soft/SoftAside.h"
#include "testing/support/Eventually.h"

namespace palpate::test
{
namespace
{

std::unique_ptr<BodyMaker> madeOf(const SoftBodyInput& input)
{
  std::string refusal;
  auto maker = BodyMaker::make(input, "block", 0, refusal);
  EXPECT_TRUE(maker) << refusal;
  return maker;
}

/// Presses with a point on the top of the block once it has a snapshot, which names its triangles.
BodyHand handOn(const PressedBody& body, double press_N)
{
  BodyHand hand;
  hand.revision = body.revision;
  hand.ball_W = topOfBlock();
  hand.device_W = topOfBlock() - Vec3(0, 0, 0.002);
  const TriangleMesh& mesh = body.scene->surfaces().back().tree->mesh();
  const auto off = [&mesh](const std::array<std::uint32_t, 3>& t)
  { return (mesh.vertices_W[t[0]] - topOfBlock()).norm(); };
  const auto top = std::ranges::min_element(mesh.triangles, {}, off);
  hand.forceAt[0] = { *top, Vec3(0.6, 0.3, 0.1), topOfBlock() };
  hand.force_N[0] = Vec3(0.1 * press_N, 0.0, -press_N);
  hand.count = 1;
  return hand;
}

void condense(const std::shared_ptr<KeptInverse>& kept)
{
  while (kept->condenseNext())
  {
  }
}

double farthest_u(const BodyShape& a, const BodyShape& b)
{
  double most = 0.0;
  for (std::size_t v = 0; v < a.displacement_u.size(); ++v)
  {
    most = std::max(most, (a.displacement_u[v] - b.displacement_u[v]).norm() + (a.dent_u[v] - b.dent_u[v]).norm());
  }
  return most;
}

TEST(SoftBodyMaker, ThatKeepsAnInverseIsFeltAndSeenAsOneThatDoesNot)
{
  const auto byFactor = madeOf(bumpyBlock(ElasticModel::Linear));
  const auto byKept = madeOf(bumpyBlock(ElasticModel::Linear));
  const auto kept = byKept->keepAround(topOfBlock());
  ASSERT_TRUE(kept);
  condense(kept);
  const BodyHand begin;
  const auto first = byFactor->press(begin, 0.01);
  ASSERT_TRUE(first && byKept->press(begin, 0.01));
  for (const double press_N : { 0.1, 0.5, 0.0 })
  {
    const BodyHand hand = handOn(*first, press_N);
    const auto truth = byFactor->press(hand, 0.01);
    const auto found = byKept->press(hand, 0.01);
    const Eigen::MatrixXd& c = truth->snapshot->compliance;
    EXPECT_LE((found->snapshot->compliance - c).lpNorm<Eigen::Infinity>(), 1e-12 * c.lpNorm<Eigen::Infinity>());
    const BodyShape seen = byFactor->shape();
    EXPECT_LE(farthest_u(byKept->shape(), seen), 1e-12);
    EXPECT_NEAR(byKept->shape().mostGradient, seen.mostGradient, 1e-12);
    EXPECT_EQ(seen.mostGradient > 1e-4, press_N > 0.0);
  }
}

TEST(SoftBodyMaker, KeepsOneInverseAsLongAsItMayAnswer)
{
  const auto maker = madeOf(softBlock(ElasticModel::Linear));
  const auto kept = maker->keepAround(topOfBlock());
  ASSERT_TRUE(kept);
  EXPECT_FALSE(maker->keepAround(Vec3(1.0, 0.0, 0.0))) << "it is not condensed yet";
  condense(kept);
  ASSERT_TRUE(maker->press({}, 0.01));
  EXPECT_FALSE(maker->keepAround(Vec3(1.0, 0.0, 0.0))) << "it answered";
  EXPECT_FALSE(madeOf(softBlock(ElasticModel::NeoHookean))->keepAround(topOfBlock())) << "no stiffness to keep";
}

TEST(SoftAside, ShowsTheNewestSightInTheEndAndCondensesMeanwhile)
{
  const auto maker = madeOf(softBlock(ElasticModel::Linear));
  const auto first = maker->press({}, 0.01);
  ASSERT_TRUE(first && maker->press(handOn(*first, 0.1), 0.01));
  const BodySight light = maker->sight();
  ASSERT_TRUE(maker->press(handOn(*first, 0.5), 0.01));
  const BodyShape truth = maker->shape();
  std::mutex mutex;
  std::vector<BodyShape> seen;
  const auto kept = maker->keepAround(topOfBlock());
  SoftAside aside(
    [&](BodyShape shape)
    {
      const std::lock_guard lock(mutex);
      seen.push_back(std::move(shape));
    });
  const auto isLast = [&](const BodyShape& shape)
  {
    const std::lock_guard lock(mutex);
    return !seen.empty() && seen.back().displacement_u == shape.displacement_u && seen.back().dent_u == shape.dent_u;
  };
  aside.condense(kept);
  aside.look(light);
  EXPECT_TRUE(eventually([&] { return kept->known() == kept->size() && isLast(shapeOf(light)); }));
  aside.look(light);
  aside.look(maker->sight());
  EXPECT_TRUE(eventually([&] { return isLast(truth); }));
}

} // namespace
} // namespace palpate::test
