// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "devices/line/LineRun.h"

namespace palpate
{
namespace
{

/// A wheel in a light hand that holds still where it is led, without friction.
std::unique_ptr<HapticDevice> wheelLedTo(double s_m)
{
  DeviceModel smooth = *deviceModel("simulated-joystick");
  smooth.friction_N = smooth.encoderStep_m = 0.0;
  return std::make_unique<SimulatedDevice>(smooth, *handModel("light"), HandPath{ { Vec3(s_m, 0, 0) } });
}

LineWorld detents()
{
  LineWorld world;
  world.places = { { -0.04, 0.0, 0.0 }, { 0.04, 0.0, 0.0 } };
  world.detentEvery_m = 0.02;
  world.detent_N = 0.5; // 50 N/m
  world.stop_N_per_m = 100.0;
  return world;
}

/// Where the hand rests after three seconds.
double rest_m(double led_m, const LineWorld& world)
{
  LineRun run;
  EXPECT_EQ(run.start(wheelLedTo(led_m), world, {}, { 1e-3, true, {} }), "");
  run.step(100);
  EXPECT_EQ(run.state().force_N, 0.0); // nobody has engaged
  run.engage();
  run.step(3000);
  return run.state().s_m;
}

// The hand's spring K to where it is led, the detent's k to its middle: they balance at (K h + k d) / (K + k).
TEST(LineRun, AHandRestsWhereItsSpringAndTheDetentBalance)
{
  const double K = handModel("light")->stiffness_N_per_m, k = 2.0 * 0.5 / 0.02;
  for (const double detent_m : { -0.02, 0.0, 0.02 })
  {
    for (const double off_m : { -0.004, 0.003 })
    {
      const double led_m = detent_m + off_m;
      EXPECT_NEAR(rest_m(led_m, detents()), (K * led_m + k * detent_m) / (K + k), 1e-6);
    }
  }
}

TEST(LineRun, AHandBeyondAStopRestsWhereBothSpringsBalance)
{
  const double K = handModel("light")->stiffness_N_per_m;
  LineWorld world = detents();
  world.detent_N = 0.0;
  const double led_m = 0.043; // 0.3 N of a small force to begin with
  EXPECT_NEAR(rest_m(led_m, world), (K * led_m + world.stop_N_per_m * 0.04) / (K + world.stop_N_per_m), 1e-6);
}

TEST(LineRun, AWorldStifferThanTheDeviceHoldsIsRefusedByNumber)
{
  LineWorld world = detents();
  world.detent_N = 1000.0;
  LineRun run;
  EXPECT_NE(run.start(wheelLedTo(0.0), world).find("rendered stably"), std::string::npos);
  EXPECT_FALSE(run.running());
}

TEST(LineRun, ADeviceWithoutForceIsRefused)
{
  LineRun run;
  EXPECT_NE(run.start(std::make_unique<FedDevice>(), detents()).find("no force"), std::string::npos);
}

TEST(LineRun, OnItsOwnThreadItEndsWithoutForce)
{
  LineRun run;
  ASSERT_EQ(run.start(wheelLedTo(0.003), detents()), "");
  run.engage();
  run.stop();
  EXPECT_FALSE(run.running());
  EXPECT_EQ(run.state().force_N, 0.0);
}

} // namespace
} // namespace palpate
