// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of single ticks is judged: it must see each of the things it is there for, and nothing else.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/Families.h"
#include "testing/support/FeatureHand.h"
#include "testing/support/FreeWay.h"
#include "testing/support/FrictionCone.h"
#include "testing/support/Meshes.h"
#include "testing/support/TickJudge.h"

namespace palpate::test
{
namespace
{

/// The square [-1, 1]^2 in z = 0.
TriangleMesh floorMesh()
{
  return { { { -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 1, 2, 3 } } };
}

/// The judgement of one straight tick over the floor that ends at `to_W` with the device at `p_W`.
TickFigures judged(const ContactPlan& plan, const Vec3& from_W, const Vec3& to_W, const Vec3& p_W, bool capped = false)
{
  TickJudge judge(PathChecker(floorMesh(), 0.0), plan, 2.0);
  judge.segment(from_W, to_W);
  ContactResult result;
  result.proxy_W = to_W;
  result.pull_W = to_W - p_W;
  result.capped = capped;
  judge.judge(from_W, p_W, result, to_W);
  return judge.figures();
}

TEST(TickJudge, SaysNothingOfATickThatEndsAtTheDeviceOrIsHeldByAFace)
{
  const Vec3 start_W(0.2, 0.1, 1);
  for (const double r : { 0.0, 0.1 })
  {
    ContactPlan plan;
    plan.radius_u = r;
    EXPECT_TRUE(judged(plan, start_W, { 0.3, 0.1, 0.5 }, { 0.3, 0.1, 0.5 }).clean());
    const double lift_u = r > 0.0 ? r : 1e-15;
    EXPECT_TRUE(judged(plan, start_W, { 0.3, 0.1, lift_u }, { 0.3, 0.1, -0.5 }).clean());
  }
}

TEST(TickJudge, SeesAGodObjectThatStaysAlthoughItsWayIsFree)
{
  ContactPlan plan;
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 1e-15 }, { 0, 0, 1e-6 }).glued, 1u);
  EXPECT_EQ(
    judged(plan, { 1.5, 0, 1 }, { std::nextafter(1.0, 2.0), 0, 1 }, { std::nextafter(1.0, 2.0), 0, -1 }).glued, 1u);
  EXPECT_EQ(judged(plan, { 0.5, 0, 1 }, { 1.0, 0, 1 }, { 1.0, 0, -1 }).glued, 0u);  // the rim itself blocks the path
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 0.5 }, { 0, 0, 1 }, true).glued, 0u); // excused, and counted
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 0.5 }, { 0, 0, 1 }, true).capped, 1u);
  plan.radius_u = 0.1;
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 0.1 }, { 0.2, 0, 0.1 }).glued, 1u); // it could roll on
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 0.1 }, { 0.2, 0, 0.09 }).glued, 0u);
}

TEST(TickJudge, SeesAPathThatMeetsTheSurfaceJumpsOrEndsElsewhere)
{
  const ContactPlan plan;
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, -1 }, { 0, 0, -1 }).through, 1u);
  TickJudge judge(PathChecker(floorMesh(), 0.0), plan, 2.0);
  ContactResult result;
  result.proxy_W = Vec3(0, 0, 2);
  judge.segment({ 0, 0, 1 }, { 0, 0, 1.5 });
  judge.judge({ 0, 0, 1 }, { 0, 0, 2 }, result, { 0, 0, 2 });
  EXPECT_EQ(judge.figures().through, 1u);
}

TEST(TickJudge, SeesWhatIsHeldByNothing)
{
  EXPECT_EQ(judged({}, { 0, 0, 1 }, { 0, 0, 0.5 }, { 0, 0, -1 }).adrift, 1u);
}

TEST(TickJudge, SeesAPullBeyondFriction)
{
  ContactPlan plan;
  plan.radius_u = 0.1;
  plan.friction = { 0.5, 0.4 };
  EXPECT_EQ(judged(plan, { 0, 0, 1 }, { 0, 0, 0.1 }, { 0.0499, 0, 0.0 }).beyond, 0u); // 0.5 times 0.1 deep
  const TickFigures figures = judged(plan, { 0, 0, 1 }, { 0, 0, 0.1 }, { 0.1, 0, 0.0 });
  EXPECT_EQ(figures.beyond, 1u);
  EXPECT_NEAR(figures.mostBeyond, (0.1 - 0.05) / std::hypot(0.1, 0.1), 1e-12);
}

TEST(TickJudge, SeesAPullThatIsNotTheWayToTheGodObjectAndOneThatIsNoNumber)
{
  TickJudge judge(PathChecker(floorMesh(), 0.0), {}, 2.0);
  ContactResult result;
  result.proxy_W = Vec3(0, 0, 1);
  result.pull_W = Vec3(0, 0, 1e-300);
  judge.judge({ 0, 0, 1 }, { 0, 0, 1 }, result, { 0, 0, 1 });
  EXPECT_EQ(judge.figures().untrue, 1u);
  result.pull_W.x() = std::nan("");
  judge.judge({ 0, 0, 1 }, { 0, 0, 1 }, result, { 0, 0, 1 });
  EXPECT_EQ(judge.figures().notFinite, 1u);
}

TEST(FrictionCone, OfACornerIsTheSumOfBothReactionsAndOfOneFaceItsOwn)
{
  const std::vector<Vec3> normals = { Vec3::UnitZ(), Vec3::UnitX() };
  EXPECT_EQ(beyondFriction(normals, { -2, 1.9, -3 }, 0.4), 0.0); // 0.4 (2 + 3) along y
  EXPECT_NEAR(beyondFriction(normals, { -2, 2.5, -3 }, 0.4), 0.5, 1e-12);
  EXPECT_NEAR(beyondFriction(normals, { 2, 0, -3 }, 0.4), 2 - 0.4 * 3, 1e-12);
  EXPECT_TRUE(std::isinf(beyondFriction(normals, { 2, 0, 3 }, 0.4)));
}

/// The grid leaves nothing out: the same answers as all triangles asked one by one, for paths of every length.
TEST(FreeWay, IsTheSameWithAndWithoutAGrid)
{
  Random random(testSeed(2851));
  for (const Family& family : families())
  {
    const TriangleMesh mesh = cleanMesh(family.make(random)).mesh;
    const TriangleGrid grid(mesh);
    FeatureHand hand(mesh, random.next());
    Vec3 from_W = hand.next();
    for (std::size_t i = 0; i < testCount(30); ++i)
    {
      const Vec3 to_W = hand.next();
      const bool free = std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
        [&](const auto& t)
        {
          const TriangleMesh alone{ { mesh.vertices_W[t[0]], mesh.vertices_W[t[1]], mesh.vertices_W[t[2]] },
            { { 0, 1, 2 } } };
          return wayIsFree(TriangleGrid(alone), from_W, to_W);
        });
      EXPECT_EQ(wayIsFree(grid, from_W, to_W), free) << family.name << ", way " << i;
      from_W = to_W;
    }
  }
}

} // namespace
} // namespace palpate::test
