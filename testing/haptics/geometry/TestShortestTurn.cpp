// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// By atan2 of sine and cosine, which is exact near 0 and half a turn alike.
double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.normalized().cross(b.normalized()).norm(), a.normalized().dot(b.normalized()));
}

TEST(ShortestTurn, LeadsFromOneDirectionToTheOtherByTheAngleBetweenThem)
{
  Random random(testSeed(31));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 from = random.uniform(0.1, 10.0) * random.direction(),
               to = random.uniform(0.1, 10.0) * random.direction();
    const Quat turn = shortestTurn(from, to);
    EXPECT_NEAR(turn.norm(), 1.0, 4e-15);
    EXPECT_LT(angleBetween(turn * from, to), 1e-13);
    EXPECT_NEAR(Quat::Identity().angularDistance(turn), angleBetween(from, to), 1e-13);
  }
}

TEST(ShortestTurn, BetweenNearlyOppositeDirectionsIsHalfATurn)
{
  Random random(testSeed(32));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 from = random.direction();
    const double off_rad = std::pow(10.0, random.uniform(-16.0, -3.0)); // both branches
    const Vec3 to = -(from + off_rad * random.direction());
    const Quat turn = shortestTurn(from, to);
    EXPECT_NEAR(turn.norm(), 1.0, 4e-15);
    EXPECT_LT(angleBetween(turn * from, to), 3e-8); // twice the rounding of a sum as long as the least, or that length
    EXPECT_NEAR(Quat::Identity().angularDistance(turn), std::numbers::pi, 2e-3);
  }
}

} // namespace
} // namespace palpate::test
