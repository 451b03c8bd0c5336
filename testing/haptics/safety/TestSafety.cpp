// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/safety/ForceLimits.h"
#include "haptics/safety/LatenessPolicy.h"
#include "haptics/safety/SafetyLimits.h"

namespace palpate
{
namespace
{

TEST(ClampMagnitude, ShortensAndKeepsTheDirection)
{
  const Vec3 force(3, -4, 12); // magnitude 13
  EXPECT_EQ(clampMagnitude(force, 13.0), force);
  const Vec3 cut = clampMagnitude(force, 6.5);
  EXPECT_NEAR((cut - 0.5 * force).norm(), 0.0, 1e-15);
  EXPECT_EQ(clampMagnitude(Vec3::Zero(), 0.0), Vec3::Zero());
  EXPECT_EQ(clampMagnitude(force, std::numeric_limits<double>::infinity()), force);
}

TEST(LimitRise, LetsForceGrowByRateTimesTimeAndFallFreely)
{
  const Vec3 wanted(0, 0, 5);
  EXPECT_NEAR(limitRise(wanted, Vec3(0, 0, 1), 100.0, 0.01).z(), 1.0 + 100.0 * 0.01, 1e-15);
  EXPECT_EQ(limitRise(Vec3::Zero(), Vec3(0, 0, 9), 100.0, 0.01), Vec3::Zero());
  EXPECT_EQ(limitRise(Vec3(0, 5, 0), Vec3(0, 0, 5), 100.0, 0.01), Vec3(0, 5, 0)) << "turning is not growing";
}

/// 3 N in no less than 20 ms, from a tenth of that over a second; let go in 50 ms, after a fault in 10.
TEST(SafetyLimits, OfADeviceWhoseForceNobodyKnowsAreThoseOfThreeNewtons)
{
  constexpr double largest_N = 3.0;
  for (const SafetyLimits& limits : { SafetyLimits(), SafetyLimits::forDevice(DeviceInfo()) })
  {
    EXPECT_EQ(limits.maxForce_N, largest_N);
    EXPECT_NEAR(limits.maxRise_N_per_s, largest_N / 0.02, 1e-12);
    EXPECT_NEAR(limits.engageBelow_N, largest_N / 10.0, 1e-15);
    EXPECT_EQ(limits.engageRamp_s, 1.0);
    EXPECT_EQ(limits.releaseRamp_s, 0.05);
    EXPECT_EQ(limits.faultRamp_s, 0.01);
    EXPECT_TRUE(limits.needsEngage);
  }
}

TEST(SafetyLimits, OfAKnownForceAreSharesOfIt)
{
  DeviceInfo info;
  info.maxForce_N = { 10.0, true };
  const SafetyLimits limits = SafetyLimits::forDevice(info);
  EXPECT_NEAR(limits.maxForce_N, 6.0, 1e-12);
  EXPECT_NEAR(limits.maxRise_N_per_s, 10.0 / 0.02, 1e-9) << "all of it in 20 ms";
  EXPECT_NEAR(limits.engageBelow_N, 1.0, 1e-12);
  EXPECT_NEAR(limits.frozenAbove_N, 2.0, 1e-12);
  info.simulated = true;
  EXPECT_EQ(SafetyLimits::forDevice(info).frozenAbove_N, PositionWatch::never) << "it may stand still to the bit";
  info.rendersForce = false;
  EXPECT_EQ(SafetyLimits::forDevice(info).hand.speed_m_per_s, HandLimits::unlimited);
}

TEST(SafetyLimits, OfATorqueAreThoseOfADeviceThatTurnsTheHandAndNoneOfAnother)
{
  DeviceInfo info;
  info.maxTorque_Nm = { 0.5, true };
  EXPECT_EQ(SafetyLimits::forDevice(info).maxTorque_Nm, 0.0);
  info.rendersTorque = true;
  EXPECT_NEAR(SafetyLimits::forDevice(info).maxTorque_Nm, 0.6 * 0.5, 1e-15);
  EXPECT_NEAR(SafetyLimits::forDevice(info).maxTorqueRise_Nm_per_s, 0.5 / 0.02, 1e-12) << "all of it in 20 ms";
  EXPECT_EQ(SafetyLimits::none().maxTorque_Nm, std::numeric_limits<double>::infinity());
}

TEST(Smoothstep, StartsAndEndsFlatAndStaysWithinItsBounds)
{
  EXPECT_EQ(smoothstep(-1.0), 0.0);
  EXPECT_EQ(smoothstep(0.0), 0.0);
  EXPECT_EQ(smoothstep(0.5), 0.5);
  EXPECT_EQ(smoothstep(1.0), 1.0);
  EXPECT_EQ(smoothstep(2.0), 1.0);
  constexpr double h = 1e-6; // 3 h^2 - 2 h^3
  EXPECT_NEAR(smoothstep(h), 3 * h * h, 1e-17);
}

TEST(FiniteGuard, SeesABadNumberInEveryField)
{
  const double bad[] = { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() };
  EXPECT_TRUE(isFinite(DeviceSample{}));
  DeviceSample far;
  far.pose_D.p.z() = -1e9;
  EXPECT_TRUE(isFinite(far));
  far.pose_D.p.z() = -1e299; // its square is not finite
  EXPECT_FALSE(isFinite(far));
  for (const double value : bad)
  {
    for (int k = 0; k < 3; ++k)
    {
      DeviceSample s;
      s.pose_D.p[k] = value;
      EXPECT_FALSE(isFinite(s));
      s = {};
      s.velocity_D.linear[k] = value;
      EXPECT_FALSE(isFinite(s));
      s = {};
      s.velocity_D.angular[k] = value;
      EXPECT_FALSE(isFinite(s));
    }
    for (int k = 0; k < 4; ++k)
    {
      DeviceSample s;
      s.pose_D.q.coeffs()[k] = value;
      EXPECT_FALSE(isFinite(s));
    }
    DeviceSample s;
    s.time_s = value;
    EXPECT_FALSE(isFinite(s));
  }
}

// The rows of the fault table.
TEST(LatenessPolicy, FollowsTheFaultTable)
{
  constexpr double period = 1e-3;
  EXPECT_EQ(judgeLateness(0.0, 0.0009, period, false).stiffnessFactor, 1.0);
  EXPECT_EQ(judgeLateness(0.021, 0.0, period, false).fault, Fault::LateServo);
  EXPECT_EQ(judgeLateness(0.019, 0.0, period, false).fault, Fault::None);
  EXPECT_EQ(judgeLateness(0.0, 0.0051, period, false).fault, Fault::LateServo);
  // K holds like 1 / (T/2 + lateness): 2 ms late on 1 ms leaves 0.5 / 2.5.
  EXPECT_NEAR(judgeLateness(0.0, 0.002, period, false).stiffnessFactor, 0.2, 1e-15);
  EXPECT_EQ(judgeLateness(1.0, 1.0, period, true).fault, Fault::None) << "simulated devices only count";
}

TEST(LatenessPolicy, ActsAboveEachLimitAndNotAtIt)
{
  constexpr double period = 1e-3, above = 1.0 + 1e-9;
  EXPECT_EQ(judgeLateness(0.020, 0.0, period, false).fault, Fault::None);
  EXPECT_EQ(judgeLateness(0.020 * above, 0.0, period, false).fault, Fault::LateServo);
  EXPECT_EQ(judgeLateness(0.0, 0.005, period, false).fault, Fault::None);
  EXPECT_EQ(judgeLateness(0.0, 0.005 * above, period, false).fault, Fault::LateServo);
  EXPECT_EQ(judgeLateness(0.0, 0.005 * above, period, false).stiffnessFactor, 0.0);
  EXPECT_EQ(judgeLateness(0.0, 0.001, period, false).stiffnessFactor, 1.0);
  // T/2 of a period of 1 ms over T/2 and the lateness: 0.5 / (0.5 + 1).
  EXPECT_NEAR(judgeLateness(0.0, 0.001 * above, period, false).stiffnessFactor, 1.0 / 3.0, 1e-9);
}

TEST(SafetyLimits, OfADeviceAreSharesOfItsLargestForce)
{
  DeviceInfo device;
  device.maxForce_N = { 10.0, true };
  device.workspaceRadius_m = { 0.1, true };
  const SafetyLimits limits = SafetyLimits::forDevice(device);
  EXPECT_EQ(limits.maxForce_N, 6.0);
  EXPECT_EQ(limits.maxRise_N_per_s, 500.0); // 0 to 10 N in 20 ms
  EXPECT_EQ(limits.engageBelow_N, 1.0);
  EXPECT_EQ(limits.frozenAbove_N, 2.0);
  EXPECT_EQ(limits.hand.speed_m_per_s, 2.0);
}

TEST(SafetyLimits, LetASimulatedDeviceStandStillToTheBit)
{
  DeviceInfo device;
  device.maxForce_N = { 10.0, true };
  device.simulated = true;
  EXPECT_EQ(SafetyLimits::forDevice(device).frozenAbove_N, PositionWatch::never);
}

TEST(SafetyLimits, OfAHeadlessTickLetEveryForceThroughFromTheFirstTick)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const SafetyLimits limits = SafetyLimits::none();
  EXPECT_EQ(limits.maxForce_N, unlimited);
  EXPECT_EQ(limits.maxRise_N_per_s, unlimited);
  EXPECT_EQ(limits.engageBelow_N, unlimited);
  EXPECT_EQ(limits.engageRamp_s + limits.releaseRamp_s + limits.faultRamp_s, 0.0);
  EXPECT_FALSE(limits.needsEngage);
}

TEST(SafetyLimits, LeaveADeviceThatPushesNobodyAsFastAsItIsLed)
{
  DeviceInfo device;
  device.rendersForce = false;
  EXPECT_EQ(SafetyLimits::forDevice(device).hand.speed_m_per_s, HandLimits::unlimited);
}

} // namespace
} // namespace palpate
