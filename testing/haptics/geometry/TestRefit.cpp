// SPDX-License-Identifier: GPL-3.0-or-later
// A tree whose vertices moved answers as one that was built there.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/contact/sweep/Sweep.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "testing/support/Meshes.h"
#include "testing/support/Says.h"
#include "testing/support/TreeOf.h"

namespace palpate::test
{
namespace
{

/// Every vertex somewhere else: stretched, sheared and shaken.
std::vector<Vec3> bent(const TriangleMesh& mesh, double shake, Random& random)
{
  std::vector<Vec3> moved;
  for (const Vec3& v : mesh.vertices_W)
  {
    moved.emplace_back(
      Vec3(1.3 * v.x() + 0.2 * v.y(), 0.7 * v.y(), v.z() + 0.3 * v.x() * v.y()) + random.inCube(shake));
  }
  return moved;
}

std::shared_ptr<const Scene> sceneWith(const std::shared_ptr<const SurfaceTree>& tree)
{
  return std::make_shared<const Scene>(1, std::vector<Surface>{ { "surface", tree, {} } });
}

TEST(Refit, WithTheSameVerticesIsTheSameTree)
{
  const SurfaceTree tree = treeOf(makeIcosphere(3, 0.05));
  const RefitResult again = tree.refitted(tree.mesh().vertices_W);
  ASSERT_TRUE(again.tree) << again.refusal;
  EXPECT_EQ(again.tree->contentHash(), tree.contentHash());
  const SurfaceData &a = tree.data(), &b = again.tree->data();
  EXPECT_EQ(a.low_W, b.low_W);
  EXPECT_EQ(a.high_W, b.high_W);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
  {
    ASSERT_EQ(a.nodes[i].low_W, b.nodes[i].low_W);
    ASSERT_EQ(a.nodes[i].high_W, b.nodes[i].high_W);
  }
  ASSERT_EQ(a.discs.size(), b.discs.size());
  for (std::size_t i = 0; i < a.discs.size(); ++i)
  {
    ASSERT_EQ(a.discs[i].cx, b.discs[i].cx);
    ASSERT_EQ(a.discs[i].radius, b.discs[i].radius);
  }
  for (std::size_t i = 0; i < a.faces.size(); ++i)
  {
    ASSERT_EQ(a.faces[i].normal_W, b.faces[i].normal_W);
    ASSERT_EQ(a.faces[i].owned, b.faces[i].owned);
  }
}

TEST(Refit, KeepsTheTrianglesAndTheirNumbersButNotItsContent)
{
  Random random(testSeed(401));
  const SurfaceTree tree = treeOf(makeIcosphere(3, 0.05));
  const RefitResult moved = tree.refitted(bent(tree.mesh(), 1e-3, random));
  ASSERT_TRUE(moved.tree) << moved.refusal;
  EXPECT_EQ(moved.tree->topologyHash(), tree.topologyHash());
  EXPECT_NE(moved.tree->contentHash(), tree.contentHash());
  EXPECT_EQ(moved.tree->mesh().triangles, tree.mesh().triangles);
  EXPECT_EQ(moved.tree->data().fan, tree.data().fan);
  EXPECT_NE(treeOf(makeIcosphere(2, 0.05)).topologyHash(), tree.topologyHash());
}

TEST(Refit, AnswersEveryQueryAsATreeThatWasBuiltThere)
{
  Random random(testSeed(402));
  const TriangleMesh mesh = makeIcosphere(4, 0.05);
  const auto first = std::make_shared<const SurfaceTree>(cleanMesh(mesh).mesh);
  const auto moved = first->refitted(bent(first->mesh(), 1e-3, random)).tree;
  ASSERT_TRUE(moved);
  const auto refit = sceneWith(moved), built = sceneOf(moved->mesh());
  std::size_t hits = 0;
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const Vec3 from_W = random.inCube(0.08), to_W = random.inCube(0.08);
    const SweepQuery query = straightQuery(from_W, to_W, i % 2 == 0 ? 0.0 : 2e-3);
    const SweepHit a = sweepBall(*refit, query, 1000000), b = sweepBall(*built, query, 1000000);
    ASSERT_EQ(a.hit, b.hit) << i;
    // Built anew, vertices have other numbers and corners another order: the same times, rounded otherwise.
    ASSERT_NEAR(a.t, b.t, 1e-10) << i;
    hits += a.hit ? 1 : 0;
  }
  EXPECT_GT(hits, testCount(20000) / 10);
}

TEST(Refit, ChainsFromOneToTheNextWithoutDrift)
{
  Random random(testSeed(403));
  const SurfaceTree tree = treeOf(makeIcosphere(2, 0.05));
  auto moved = tree.refitted(bent(tree.mesh(), 1e-3, random)).tree;
  for (int i = 0; i < 5; ++i)
  {
    moved = moved->refitted(bent(moved->mesh(), 1e-3, random)).tree;
    ASSERT_TRUE(moved);
  }
  EXPECT_EQ(moved->refitted(tree.mesh().vertices_W).tree->contentHash(), tree.contentHash());
}

TEST(Refit, InTheMemoryOfARetiredTreeIsTheSameAndNeverTakesOneThatIsHeld)
{
  Random random(testSeed(404));
  const SurfaceTree tree = treeOf(makeIcosphere(3, 0.05));
  const std::vector<Vec3> one = bent(tree.mesh(), 1e-3, random), two = bent(tree.mesh(), 1e-3, random);
  const auto expected = tree.refitted(two).tree;
  auto retired = tree.refitted(one).tree;
  const auto held = retired;
  EXPECT_EQ(tree.refitted(two, retired).tree->contentHash(), expected->contentHash());
  EXPECT_EQ(held->mesh().vertices_W, one);

  auto alone = tree.refitted(one).tree;
  const FacePlane* const memory = alone->data().faces.data();
  const auto reused = tree.refitted(two, std::move(alone)).tree;
  EXPECT_EQ(reused->data().faces.data(), memory);
  EXPECT_EQ(reused->contentHash(), expected->contentHash());
  EXPECT_EQ(reused->data().low_W, expected->data().low_W);
  for (std::size_t i = 0; i < reused->data().discs.size(); ++i)
  {
    ASSERT_EQ(reused->data().discs[i].cx, expected->data().discs[i].cx);
    ASSERT_EQ(reused->data().discs[i].radius, expected->data().discs[i].radius);
  }
}

TEST(Refit, OfASingleTriangleWorks)
{
  const SurfaceTree tree(TriangleMesh{ { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 } }, { { 0, 1, 2 } } });
  const RefitResult moved = tree.refitted({ { 0, 0, 5 }, { 0, 1, 5 }, { 1, 0, 6 } });
  ASSERT_TRUE(moved.tree) << moved.refusal;
  EXPECT_EQ(moved.tree->data().low_W, Vec3(0, 0, 5));
  EXPECT_EQ(moved.tree->data().high_W, Vec3(1, 1, 6));
}

TEST(Refit, RefusesWhatCannotBeTouchedInOneSentence)
{
  const SurfaceTree tree = treeOf(makeIcosphere(1, 50.0));
  const std::vector<Vec3> good = tree.mesh().vertices_W;

  std::vector<Vec3> fewer = good;
  fewer.pop_back();
  EXPECT_TRUE(test::says(tree.refitted(fewer).refusal, { "surface", "42 vertices", "positions", "41" }));

  std::vector<Vec3> broken = good;
  broken[7].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(test::says(tree.refitted(broken).refusal, { "vertex 7", "not finite" }));

  const VertexWay three{ 1, { &good, &good, &good } };
  EXPECT_TRUE(test::says(tree.refitted(good, nullptr, &three).refusal, { "at most 2 positions", "not 3" }));

  const auto& t = tree.mesh().triangles[5];
  std::vector<Vec3> flat = good;
  flat[t[2]] = flat[t[0]];
  EXPECT_NE(tree.refitted(flat).refusal.find("collinear"), std::string::npos);
  flat[t[0]] = { 1, 2, 3 };
  flat[t[1]] = { 2, 4, 6 };
  flat[t[2]] = { 4, 8, 12 };
  const RefitResult refused = tree.refitted(flat);
  EXPECT_NE(refused.refusal.find("collinear"), std::string::npos);
  EXPECT_FALSE(refused.tree);
}

} // namespace
} // namespace palpate::test
