// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "haptics/line/LineTick.h"
#include "haptics/safety/ForceLimits.h"

namespace palpate
{
namespace
{

/// 0.2 N to the right of 0, nothing on its left.
LineWorld ramp()
{
  LineWorld world;
  world.places = { { -0.1, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.1, -0.02, 0.0 } };
  return world;
}

/// A wheel at one place, and its commands tick by tick.
struct Wheel
{
  LineWorld world = ramp();
  SafetyLimits limits;
  LineTickInput input;
  LineState state;

  Wheel() { this->limits.hand = {}; }
  double tick(double s_m)
  {
    this->input.sample.pose_D.p = Vec3(s_m, 0.01, 0.02);
    const DeviceCommand command = stepLine(this->world, this->limits, this->input, this->state);
    this->input.engage = false;
    EXPECT_EQ(command.wrench_D.force.y(), 0.0);
    EXPECT_EQ(command.wrench_D.force.z(), 0.0);
    return command.wrench_D.force.x();
  }
  double engaged(double s_m, int ticks = 1100)
  {
    this->input.engage = true;
    double force_N = 0.0;
    for (int i = 0; i < ticks; ++i)
    {
      force_N = this->tick(s_m);
    }
    return force_N;
  }
};

TEST(LineTick, NothingPushesBeforeSomebodyEngages)
{
  Wheel wheel;
  for (int i = 0; i < 3000; ++i)
  {
    ASSERT_EQ(wheel.tick(0.05), 0.0);
  }
  EXPECT_EQ(wheel.state.engage, EngageState::Safe);
}

TEST(LineTick, TheForceOfTheLineComesOverTheEngageRamp)
{
  Wheel wheel;
  EXPECT_NEAR(wheel.engaged(0.05, 500), smoothstep(0.5) * 0.2, 1e-12);
  EXPECT_NEAR(wheel.engaged(0.05), 0.2, 1e-12);
}

TEST(LineTick, ItBeginsFromASmallForceOnly)
{
  Wheel wheel;
  wheel.limits.engageBelow_N = 0.1;
  EXPECT_EQ(wheel.engaged(0.05), 0.0);
  EXPECT_EQ(wheel.state.engage, EngageState::Armed);
  EXPECT_EQ(wheel.tick(-0.05), 0.0); // there is none there
  EXPECT_EQ(wheel.state.engage, EngageState::Engaged);
}

TEST(LineTick, NoForceIsLargerThanTheLimitNorRisesFaster)
{
  Wheel wheel;
  wheel.limits.maxForce_N = 1.5;
  wheel.limits.maxRise_N_per_s = 100.0;
  EXPECT_EQ(wheel.engaged(-0.05), 0.0);
  double last_N = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    const double force_N = std::fabs(wheel.tick(0.15)); // 50 mm beyond the stop: 10 N
    EXPECT_LE(force_N, last_N + 0.1 + 1e-12);
    last_N = force_N;
  }
  EXPECT_NEAR(last_N, 1.5, 1e-12);
}

TEST(LineTick, ALostDeviceOrANumberThatIsNoneEndsTheForceInThatTick)
{
  for (const bool lost : { true, false })
  {
    Wheel wheel;
    ASSERT_GT(wheel.engaged(0.05), 0.1);
    wheel.input.status = lost ? DeviceStatus::Lost : DeviceStatus::Ok;
    EXPECT_EQ(wheel.tick(lost ? 0.05 : std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ(wheel.state.fault, lost ? Fault::DeviceLost : Fault::NonFiniteSample);
    wheel.input.status = DeviceStatus::Ok;
    for (int i = 0; i < 100; ++i)
    {
      ASSERT_EQ(wheel.tick(0.05), 0.0); // until somebody engages again
    }
    EXPECT_GT(wheel.engaged(0.05), 0.1);
  }
}

TEST(LineTick, LetGoOfWhatMustBeHeldTheForceIsGoneWithinItsRamp)
{
  Wheel wheel;
  wheel.limits.deadMan = { 1, false };
  wheel.input.sample.buttons = 1;
  ASSERT_GT(wheel.engaged(0.05), 0.1);
  wheel.input.sample.buttons = 0;
  double force_N = 1.0;
  for (int i = 0; i < 50; ++i) // 50 ms
  {
    force_N = wheel.tick(0.05);
  }
  EXPECT_NEAR(force_N, 0.0, 1e-12);
}

TEST(LineTick, AWheelThatRunsAwayUnderForceLosesIt)
{
  Wheel wheel;
  wheel.limits.hand = handLimits(0.05, 5.0); // 1 m/s
  ASSERT_GT(wheel.engaged(0.01), 0.1);
  double force_N = 1.0;
  for (int i = 0; i < 40; ++i)
  {
    force_N = wheel.tick(0.01 + 2e-3 * i); // 2 m/s
  }
  EXPECT_EQ(wheel.state.fault, Fault::VelocityCut);
  EXPECT_NEAR(force_N, 0.0, 1e-12);
}

} // namespace
} // namespace palpate
