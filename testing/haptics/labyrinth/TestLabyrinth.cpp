// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/labyrinth/LabyrinthGame.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

/// A corridor from (0, 0) to (10, 1), open on the left, entered from half a width outside.
Labyrinth corridor()
{
  Labyrinth labyrinth;
  labyrinth.name = "corridor.vtp";
  labyrinth.curves = { { { 0, 1 }, { 10, 1 }, { 10, 0 }, { 0, 0 } }, { { 0, 1 }, { 1, 2 }, { 2, 3 } } };
  labyrinth.start_W = Eigen::Vector2d(-0.5, 0.5);
  labyrinth.exit_W = Eigen::Vector2d(9.5, 0.5);
  return labyrinth;
}

TEST(Labyrinth, WithoutLinesStartOrExitItSaysItsNameAndWhatIsMissing)
{
  EXPECT_EQ(refuse(corridor()), "");
  Labyrinth without = corridor();
  without.curves.segments.clear();
  EXPECT_TRUE(test::says(refuse(without), { "corridor.vtp", "no lines" }));
  without = corridor();
  without.start_W.reset();
  EXPECT_NE(refuse(without).find("corridor.vtp: no start"), std::string::npos);
  without = corridor();
  without.exit_W.reset();
  EXPECT_NE(refuse(without).find("corridor.vtp: no exit"), std::string::npos);
  without = corridor();
  without.exit_W->x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refuse(without).find("not finite"), std::string::npos);
  without = corridor();
  without.corridor_u = 0.0;
  EXPECT_NE(refuse(without).find("above zero"), std::string::npos);
}

TEST(Labyrinth, WhoseLinesAreAllOnePointIsNamedWithThatPointAndOneThatOnlyLacksStartOrExitCanBeExplored)
{
  Labyrinth world = corridor();
  EXPECT_EQ(refuseWorld(world), "");
  world.start_W.reset();
  EXPECT_EQ(refuseWorld(world), "");
  for (const auto& curves :
    { CurveSet{ { { 1, 2 } }, { { 0, 0 } } }, CurveSet{ { { 1, 2 }, { 1, 2 } }, { { 0, 1 } } } })
  {
    world = corridor();
    world.curves = curves;
    EXPECT_TRUE(test::says(refuseWorld(world), { "corridor.vtp", "single point, (1, 2)" }));
    EXPECT_EQ(refuse(world), refuseWorld(world));
  }
}

// The start is 0.5 outside of the lines on the left: the fence is 0.5 beyond it there, and on the lines elsewhere.
TEST(Labyrinth, TheFenceIsTheBoxOfTheLinesAndAsFarBeyondTheStartAsThatIsOutside)
{
  const PlaneBox box = fence(corridor());
  EXPECT_EQ(box.low_W, Eigen::Vector2d(-1, 0));
  EXPECT_EQ(box.high_W, Eigen::Vector2d(10, 1));
  EXPECT_EQ(fenced(corridor()).segments.size(), corridor().curves.segments.size() + 4);
}

TEST(Labyrinth, FittedIntoAWorkspaceItsCornersAreWithinAndItsLongSideIsTheSideOfTheInnerSquare)
{
  constexpr double radius_m = 0.05;
  const WorkspaceMap map = fitted(corridor(), radius_m);
  const Vec3 low_D = map.toDevice({ -1, 0, 0 }), high_D = map.toDevice({ 10, 1, 0 });
  EXPECT_NEAR((low_D + high_D).norm(), 0.0, 1e-15);
  EXPECT_NEAR(high_D.x() - low_D.x(), std::sqrt(2.0) * radius_m, 1e-15);
  EXPECT_LE(low_D.norm(), radius_m);
}

TEST(LabyrinthGame, APlanBeyondWhatAHandMayBeGivenIsRefused)
{
  const GamePlan plan = gameOf(corridor());
  EXPECT_EQ(refuse(plan), "");
  const auto with = [&](double GamePlan::*member, double value)
  {
    GamePlan other = plan;
    other.*member = value;
    return refuse(other);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(with(&GamePlan::lead_m_per_s, 0.11), "");
  EXPECT_NE(with(&GamePlan::lead_m_per_s, nan), "");
  EXPECT_NE(with(&GamePlan::largest_N, 6.0), "");
  EXPECT_NE(with(&GamePlan::shake_N, 4.0), "");
  EXPECT_NE(with(&GamePlan::shake_Hz, 101.0), "");
  EXPECT_NE(with(&GamePlan::shake_s, 6.0), "");
  EXPECT_NE(with(&GamePlan::exitReach_u, 0.0), "");
}

} // namespace
} // namespace palpate
