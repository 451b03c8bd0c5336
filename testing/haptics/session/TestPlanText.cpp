// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/PlanText.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

SurfaceChoice all(std::size_t triangles, const std::string& reason)
{
  return { "surface", triangles, triangles, 0.0, reason };
}

TouchChoice ballOf(double used_u, double asked_u, double largest_u)
{
  TouchChoice touch;
  touch.plan.radius_u = used_u;
  touch.asked_u = asked_u;
  touch.largest_u = largest_u;
  return touch;
}

std::string said(const TouchChoice& touch)
{
  return planText({ all(320, "why") }, touch);
}

TEST(PlanText, AddsSurfacesUpAndSaysEachReasonOnce)
{
  const SurfaceChoice fewer{ "fine", 1000, 250, 0.06, "" };
  EXPECT_THAT(
    planText({ all(10, "a"), all(20, "a"), all(30, "b") }, {}), StartsWith("all 60 triangles are used (a; b), by "));
  EXPECT_THAT(planText({ all(10, "a"), fewer }, {}), StartsWith("260 of 1010 triangles are used (proven: "));
  EXPECT_THAT(planText({ all(10, "") }, {}), HasSubstr("(a simpler surface is looked for meanwhile)"));
  EXPECT_EQ(planText({}, {}), "no rigid surface is touched");
}

TEST(PlanText, CountsSegmentsOfCurvesAndSaysWhatStandsForThem)
{
  SurfaceChoice lines = all(300000, "");
  lines.curves = true;
  EXPECT_THAT(
    planText({ lines }, {}), StartsWith("all 300000 segments are used (coarser lines are looked for meanwhile), by "));
  EXPECT_THAT(planText({ lines, all(10, "a") }, {}), StartsWith("all 300010 triangles and segments are used ("));
  lines.wall_WP = Pose();
  lines.felt = 4;
  lines.bound_u = 0.0625;
  EXPECT_THAT(planText({ lines }, {}),
    ::testing::AllOf(StartsWith("4 of 300000 segments are used (proven: no point is further than 0.0625 u from the "
                                "data's lines, or vice versa"),
      HasSubstr("a list (up to 8 triangles)"))); // a wall is two
  lines.felt = 5;
  EXPECT_THAT(planText({ lines }, {}), HasSubstr("a tree of boxes"));
}

TEST(PlanText, SaysWhyTheBallIsAsLargeAsItIs)
{
  EXPECT_THAT(said(ballOf(0, 0, 3)), HasSubstr(", by a point (no radius is set) "));
  EXPECT_THAT(said(ballOf(2, 2, infinity)), HasSubstr("a sphere of 2 u (as set; any size can be computed"));
  EXPECT_THAT(said(ballOf(2, 2, 3)), HasSubstr("a sphere of 2 u (as set; up to 3 u can be computed within a tick)"));
  EXPECT_THAT(said(ballOf(3, 8, 3)), HasSubstr("a sphere of 3 u (8 u is set, but may exceed the work of a tick"));
  EXPECT_THAT(said(ballOf(8, 8, 3)), HasSubstr("a sphere of 8 u (as set and forced; above 3 u the work of a tick"));
  EXPECT_THAT(said(ballOf(0, 8, 0)), HasSubstr("a point (8 u is set, but may exceed the work of a tick"));
  EXPECT_THAT(said(ballOf(0.001, 0, infinity)), HasSubstr("a sphere of 0.001 u (curves need a small sphere"));
}

TEST(PlanText, SaysWhereFrictionComesFrom)
{
  TouchChoice touch;
  EXPECT_THAT(said(touch), HasSubstr(" without friction (none is set), "));
  touch.frictionFromData = true;
  EXPECT_THAT(said(touch), HasSubstr(" with friction from the data, "));
  touch.plan.friction = { 0.5, 0.25 };
  EXPECT_THAT(
    said(touch), HasSubstr("friction 0.5 at rest, 0.25 sliding (as set; data with their own friction keep it)"));
  touch.frictionFromData = false;
  EXPECT_THAT(said(touch), HasSubstr(" with friction 0.5 at rest, 0.25 sliding (as set), "));
}

TEST(PlanText, ALeafIsAListAndAllElseIsATree)
{
  const std::string list = "through a list (up to 8 triangles)";
  EXPECT_THAT(planText({ all(8, "why") }, {}), EndsWith(list));
  for (const auto& choices :
    { std::vector{ all(9, "why") }, std::vector{ all(4, "why"), all(4, "why") } }) // two leaves stand in a tree
  {
    EXPECT_THAT(planText(choices, {}), EndsWith("through a tree of boxes (lists of more than 8 triangles are slower)"));
  }
}

TEST(PlanText, KnowsFrictionOfASurfaceHoweverItCame)
{
  Surface plain = sceneOf(makeBox(Vec3::Zero(), Vec3::Ones()))->surfaces().front();
  Surface material = plain, arrays = plain;
  material.material.frictionStatic = 0.0;
  auto fields = std::make_shared<MaterialFields>();
  fields->frictionStatic.assign(plain.tree->mesh().vertices_W.size(), 0.3);
  arrays.fields = fields;
  EXPECT_FALSE(hasOwnFriction(Scene(1, { plain })));
  EXPECT_TRUE(hasOwnFriction(Scene(2, { plain, material })));
  EXPECT_TRUE(hasOwnFriction(Scene(3, { plain, arrays })));
}

TEST(PlanText, TheChosenBallIsNoLargerThanTheLimitUnlessItIsForced)
{
  EXPECT_EQ(chosenRadius_u(2.0, 3.0, true), 2.0);
  EXPECT_EQ(chosenRadius_u(8.0, 3.0, true), 3.0);
  EXPECT_EQ(chosenRadius_u(8.0, 3.0, false), 8.0);
  EXPECT_EQ(chosenRadius_u(infinity, 3.0, true), infinity); // no radius: for others to refuse
  EXPECT_TRUE(std::isnan(chosenRadius_u(std::nan(""), 3.0, true)));
}

} // namespace
} // namespace palpate::test
