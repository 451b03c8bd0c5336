// SPDX-License-Identifier: GPL-3.0-or-later
// A map that a person turns, scales or shifts: the hand stays where it is.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/session/plan/HandMap.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

Quat randomTurn(test::Random& random)
{
  return Quat(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)).normalized();
}

WorkspaceMap randomMap(test::Random& random)
{
  return { std::pow(10.0, random.uniform(-3, 6)), randomTurn(random), random.inCube(1000.0) };
}

HandPlace placeIn(const WorkspaceMap& map, const Vec3& p_D)
{
  return { p_D, map.toScene(p_D) };
}

/// As large as rounding of the numbers that it is made of.
double rounding_u(const WorkspaceMap& map)
{
  return 1e-14 * (map.scale_u_per_m + map.offset_W.norm());
}

TEST(HandMap, ThereAndBackIsTheSamePlaceForRandomMaps)
{
  test::Random random(test::testSeed(151));
  for (std::size_t i = 0; i < test::testCount(2000); ++i)
  {
    const WorkspaceMap map = randomMap(random);
    const Vec3 p_D = random.inCube(0.1);
    EXPECT_LE((map.toDevice(map.toScene(p_D)) - p_D).norm(), rounding_u(map) / map.scale_u_per_m) << i;
  }
}

TEST(HandMap, NothingIsTurnedScaledOrShiftedAwayFromUnderTheHand)
{
  test::Random random(test::testSeed(152));
  for (std::size_t i = 0; i < test::testCount(2000); ++i)
  {
    WorkspaceMap map = randomMap(random);
    HandMap hands;
    for (int change = 0; change < 8; ++change)
    {
      HandWishes wishes;
      wishes.clutch = random.below(3) == 0;
      wishes.precise = random.below(2) == 0;
      wishes.precision = random.uniform(1.0, 20.0);
      wishes.q_WD = random.below(2) == 0 ? std::optional(randomTurn(random)) : std::nullopt;
      const HandPlace hand = placeIn(map, random.inCube(0.1));
      if (const auto next = hands.follow(wishes, map, hand))
      {
        EXPECT_LE((next->map.toScene(hand.p_D) - hand.p_W).norm(), 4.0 * (rounding_u(map) + rounding_u(next->map)))
          << i;
        EXPECT_EQ(next->clutch, wishes.clutch);
        map = next->map;
      }
    }
  }
}

TEST(HandMap, OfACameraHasRightUpAndTowardsWhereTheViewHasThem)
{
  test::Random random(test::testSeed(153));
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    const Mat3 axes = randomTurn(random).toRotationMatrix();
    // the view's up need not be square to right, and neither is as long as one
    const auto q_WD =
      viewRotation(random.uniform(0.1, 9.0) * axes.col(0), axes.col(1) + random.uniform(-1.0, 1.0) * axes.col(0));
    ASSERT_TRUE(q_WD);
    EXPECT_LT((*q_WD * Vec3::UnitX() - axes.col(0)).norm(), 1e-12);
    EXPECT_LT((*q_WD * Vec3::UnitY() - axes.col(1)).norm(), 1e-12);
    EXPECT_LT((*q_WD * Vec3::UnitZ() - axes.col(2)).norm(), 1e-12);
  }
}

TEST(HandMap, OfACameraThatLooksNowhereThereIsNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(viewRotation(Vec3::UnitX(), Vec3::UnitX()));
  EXPECT_FALSE(viewRotation(Vec3::Zero(), Vec3::UnitY()));
  EXPECT_FALSE(viewRotation(Vec3(nan, 0, 0), Vec3::UnitY()));
}

TEST(HandMap, PrecisionIsThatMuchLessOfTheSameWayAndGoesAsItCame)
{
  const WorkspaceMap coarse{ 1000.0, Quat(0.5, 0.5, 0.5, 0.5), { 1, 2, 3 } };
  HandMap hands;
  HandWishes wishes;
  wishes.precise = true;
  wishes.precision = 5.0;
  const HandPlace hand = placeIn(coarse, { 0.01, -0.02, 0.03 });
  const auto fine = hands.follow(wishes, coarse, hand);
  ASSERT_TRUE(fine);
  const Vec3 way_D(0.001, 0.002, -0.003);
  const Vec3 way_W = fine->map.toScene(hand.p_D + way_D) - hand.p_W;
  EXPECT_LT((way_W - coarse.directionToScene(way_D) * 1000.0 / 5.0).norm(), 1e-11);
  EXPECT_FALSE(hands.follow(wishes, fine->map, hand)) << "it is so already";
  wishes.precise = false;
  const auto back = hands.follow(wishes, fine->map, hand);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->map.scale_u_per_m, 1000.0, 1e-9);
  EXPECT_LT((back->map.offset_W - coarse.offset_W).norm(), 1e-10) << "the hand has not moved meanwhile";
}

TEST(HandMap, ADeviceThatWasMovedWhileTheClutchWasHeldGoesOnFromWhereItIs)
{
  const WorkspaceMap before{ 1000.0, Quat::Identity(), { 0, 0, 0 } };
  HandMap hands;
  HandWishes held;
  held.clutch = true;
  const auto clutched = hands.follow(held, before, { { 0.05, 0, 0 }, { 50, 0, 0 } });
  ASSERT_TRUE(clutched);
  EXPECT_TRUE(clutched->clutch);
  EXPECT_TRUE(isSame(clutched->map, before));
  EXPECT_FALSE(hands.follow(held, before, { { 0.02, 0, 0 }, { 50, 0, 0 } }));
  const auto after = hands.follow({}, before, { { -0.05, 0, 0 }, { 50, 0, 0 } });
  ASSERT_TRUE(after);
  EXPECT_FALSE(after->clutch);
  EXPECT_LT((after->map.toScene({ -0.05, 0, 0 }) - Vec3(50, 0, 0)).norm(), 1e-12);
  EXPECT_LT((after->map.toScene({ -0.04, 0, 0 }) - Vec3(60, 0, 0)).norm(), 1e-12);
  EXPECT_FALSE(hands.follow({}, after->map, { { -0.05, 0, 0 }, { 50, 0, 0 } }));
}

TEST(HandMap, ItsBoxHoldsTheBallThatTheDeviceReaches)
{
  test::Random random(test::testSeed(154));
  const double radius_m = 0.08;
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const WorkspaceMap map = randomMap(random);
    Vec3 low_D = Vec3::Constant(1e9), high_D = -low_D;
    for (const Vec3& corner_W : workspaceCorners(map, radius_m))
    {
      low_D = low_D.cwiseMin(map.toDevice(corner_W));
      high_D = high_D.cwiseMax(map.toDevice(corner_W));
    }
    const double rounding_m = 10.0 * rounding_u(map) / map.scale_u_per_m;
    EXPECT_LE((low_D + Vec3::Constant(radius_m)).norm(), rounding_m);
    EXPECT_LE((high_D - Vec3::Constant(radius_m)).norm(), rounding_m);
  }
}

} // namespace
} // namespace palpate
