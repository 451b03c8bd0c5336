// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "devices/common/Condition.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

TEST(Condition, GivesNoForceInItsDeadBandAndASpringFromEachEndOfIt)
{
  Condition c;
  c.centre = 0.1;
  c.deadBand = 0.3;
  c.positiveCoefficient = 2.0;
  c.negativeCoefficient = 5.0;
  for (int i = -100; i <= 100; ++i)
  {
    const double m = 0.01 * i;
    // Two springs, one from 0.4 upwards and one from -0.2 downwards.
    const double wanted = -2.0 * std::max(0.0, m - 0.4) + 5.0 * std::max(0.0, -0.2 - m);
    EXPECT_NEAR(conditionForce(c, m), wanted, 1e-15) << m;
  }
}

TEST(Condition, EachSideIsCutToItsOwnSaturationWhateverTheSignOfItsCoefficient)
{
  Condition c;
  c.positiveSaturation = 0.5;
  c.negativeSaturation = 0.25;
  for (const double coefficient : { 10.0, -10.0 })
  {
    c.positiveCoefficient = c.negativeCoefficient = coefficient;
    EXPECT_EQ(conditionForce(c, 1.0), coefficient > 0 ? -0.5 : 0.5);
    EXPECT_EQ(conditionForce(c, -1.0), coefficient > 0 ? 0.25 : -0.25);
  }
  EXPECT_EQ(conditionForce(c, 0.0), 0.0);
}

// The dead band is counted to either side. Given the corridor's whole width, as Linux and SDL count, both walls would
// stand half a width too far out: a hand would go through them unfelt.
TEST(Condition, TheDeadBandOfACorridorIsHalfItsWidth)
{
  test::Random random(test::testSeed(5201));
  for (int i = 0; i < 1000; ++i)
  {
    const double low = random.uniform(-1.0, 0.0), width = random.uniform(0.01, 1.0), high = low + width;
    const Condition c = corridor(low, high, 3.0, 4.0);
    const double deep = 0.25 * width;
    EXPECT_NEAR(conditionForce(c, high + deep), -4.0 * deep, 1e-12);
    EXPECT_NEAR(conditionForce(c, low - deep), 3.0 * deep, 1e-12);
    EXPECT_EQ(conditionForce(c, random.uniform(low + 1e-9, high - 1e-9)), 0.0);
    Condition trap = c;
    trap.deadBand = width;
    EXPECT_EQ(conditionForce(trap, high + deep), 0.0);
  }
}

TEST(Condition, ALowerWallPushesBackWhatIsBelowItAndADamperBrakesBothWays)
{
  EXPECT_EQ(conditionForce(lowerWall(0.5, 8.0), 0.25), 2.0);
  EXPECT_EQ(conditionForce(lowerWall(0.5, 8.0), 0.75), 0.0);
  EXPECT_EQ(conditionForce(damper(4.0), 0.5), -2.0);
  EXPECT_EQ(conditionForce(damper(4.0), -0.5), 2.0);
}

} // namespace
} // namespace palpate
