// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "haptics/safety/DeadMan.h"
#include "haptics/safety/HandLimits.h"
#include "haptics/safety/PositionWatch.h"

namespace palpate
{
namespace
{

TEST(DeadMan, AsksForNothingUnlessItIsTold)
{
  EXPECT_TRUE(isHeld({}, 0, false));
}

TEST(DeadMan, IsHeldByAnyOfItsButtonsOrTheGrip)
{
  constexpr DeadMan either{ 0b101, true };
  EXPECT_FALSE(isHeld(either, 0, false));
  EXPECT_FALSE(isHeld(either, 0b010, false)) << "another button";
  EXPECT_TRUE(isHeld(either, 0b100, false));
  EXPECT_TRUE(isHeld(either, 0b011, false));
  EXPECT_TRUE(isHeld(either, 0, true));
  EXPECT_FALSE(isHeld({ 0b1, false }, 0, true)) << "a grip that was not asked for";
}

TEST(HandLimits, OfADeviceAreARadiusInFiftyMillisecondsAndFiveTimesItsAllowance)
{
  const HandLimits limits = handLimits(0.1, 6.0);
  EXPECT_DOUBLE_EQ(limits.speed_m_per_s, 0.1 / 0.05);
  EXPECT_DOUBLE_EQ(limits.excess_J, 5 * 5e-3 * 6.0 / 3.0);
}

TEST(HandLimits, OfADeviceThatSaysNothingAreNone)
{
  const HandLimits limits = handLimits(0.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(judgeHand(limits, 1e9, 1e9, 1e9), Fault::None);
}

TEST(HandLimits, CutAHandThatIsTooFastOnlyUnderForce)
{
  constexpr HandLimits limits{ 2.0, 0.05 };
  EXPECT_EQ(judgeHand(limits, 2.0, 1.0, 0.0), Fault::None);
  EXPECT_EQ(judgeHand(limits, 2.1, 1.0, 0.0), Fault::VelocityCut);
  EXPECT_EQ(judgeHand(limits, 2.1, 0.0, 0.0), Fault::None);
}

TEST(HandLimits, LatchOnEnergyBeyondTheAllowance)
{
  constexpr HandLimits limits{ 2.0, 0.05 };
  EXPECT_EQ(judgeHand(limits, 0.0, 1.0, 0.05), Fault::None);
  EXPECT_EQ(judgeHand(limits, 0.0, 1.0, 0.051), Fault::EnergyLatch);
}

TEST(PositionWatch, CallsFrozenWhatStaysTheSameToTheBitForAQuarterOfASecondUnderForce)
{
  constexpr double dt_s = 1.0 / 1024; // exact sums
  const Vec3 p_D(0.01, 0.02, 0.03);
  PositionWatch watch;
  for (int i = 1; i <= 256; ++i)
  {
    ASSERT_FALSE(watch.look(p_D, p_D, 1.0, 0.6, dt_s)) << i;
  }
  EXPECT_TRUE(watch.look(p_D, p_D, 1.0, 0.6, dt_s));
  EXPECT_FALSE(watch.look(p_D + Vec3(1e-17, 0, 1e-9), p_D, 1.0, 0.6, dt_s)) << "it moved";
  EXPECT_FALSE(watch.look(p_D, p_D, 1.0, 0.6, dt_s)) << "and begins anew";
}

TEST(PositionWatch, LeavesAHandThatRestsWithoutForceAlone)
{
  const Vec3 p_D(0.01, 0.02, 0.03);
  PositionWatch watch;
  for (int i = 0; i < 1000; ++i)
  {
    ASSERT_FALSE(watch.look(p_D, p_D, 0.6, 0.6, 1e-3));
    ASSERT_FALSE(watch.look(p_D, p_D, 1e9, PositionWatch::never, 1e-3));
  }
}

} // namespace
} // namespace palpate
