// SPDX-License-Identifier: GPL-3.0-or-later
// The judge itself is judged: it must see a crossing, a touch, a jump and a lack of clearance.
#include "testing/support/PathChecker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;

TriangleMesh oneTriangle()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
}

std::string judge(PathChecker& checker, const Vec3& from, const Vec3& to)
{
  checker.segment(from, to);
  return checker.finding(from);
}

TEST(PathChecker, SeesACrossingThroughFaceEdgeAndVertex)
{
  PathChecker checker(oneTriangle(), 0.0);
  for (const Vec3& aim : { Vec3(0.2, 0.2, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0) })
  {
    EXPECT_THAT(judge(checker, aim + Vec3(0, 0, 1), aim - Vec3(0, 0, 1)), HasSubstr("meets triangle 0"));
    EXPECT_THAT(judge(checker, aim + Vec3(0, 0, 1), aim), HasSubstr("meets triangle 0")); // touching is meeting
    EXPECT_EQ(judge(checker, aim + Vec3(0, 0, 1), aim + Vec3(0, 0, 1e-300)), "");
  }
  EXPECT_EQ(judge(checker, { 1.0000001, 0, 1 }, { 1.0000001, 0, -1 }), "");
}

TEST(PathChecker, SeesAWayThatRunsInThePlaneOfATriangle)
{
  PathChecker checker(oneTriangle(), 0.0);
  EXPECT_NE(judge(checker, { -1, 0.25, 0 }, { 2, 0.25, 0 }), "");
  EXPECT_EQ(judge(checker, { -1, 0.25, 1e-300 }, { 2, 0.25, 1e-300 }), "");
}

TEST(PathChecker, SeesAJump)
{
  PathChecker checker(oneTriangle(), 0.0);
  checker.segment({ 0, 0, 1 }, { 0, 0, 2 });
  checker.segment({ 0, 0, 2.5 }, { 0, 0, 3 });
  EXPECT_THAT(checker.finding({ 0, 0, 1 }), HasSubstr("jumps"));
  checker.segment({ 0, 0, 3 }, { 0, 0, 4 });
  EXPECT_THAT(checker.finding({ 0, 0, 1 }), HasSubstr("jumps"));
}

TEST(PathChecker, SeesABallThatComesTooNear)
{
  PathChecker checker(oneTriangle(), 0.5);
  EXPECT_EQ(judge(checker, { -1, 0.25, 0.5 }, { 2, 0.25, 0.5 }), "");
  EXPECT_NE(judge(checker, { -1, 0.25, 0.4999999 }, { 2, 0.25, 0.4999999 }), "");
  EXPECT_NE(judge(checker, { -0.49, -1, 0 }, { -0.49, 2, 0 }), ""); // passes an edge
  EXPECT_EQ(judge(checker, { -0.5, -1, 0 }, { -0.5, 2, 0 }), "");
}

TEST(PathChecker, MissesNoTriangleOfALargeMesh)
{
  Random random(testSeed(111));
  const TriangleMesh sphere = makeIcosphere(4, 50.0);
  PathChecker checker(sphere, 0.0);
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 inside = random.direction() * random.uniform(0, 49),
               outside = random.direction() * random.uniform(51, 60);
    ASSERT_NE(judge(checker, inside, outside), "") << "case " << i;
  }
}

} // namespace
} // namespace palpate::test
