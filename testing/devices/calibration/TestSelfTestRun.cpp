// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestRun.h"
#include "devices/calibration/SelfTestText.h"

namespace palpate
{
namespace
{

std::unique_ptr<HapticDevice> simulated(const std::string& name)
{
  DeviceOptions options;
  options.hand = "light";
  options.stroke.points_D = { Vec3::Zero() };
  return makeDevice(name, options).device;
}

TEST(SelfTestRun, ASimulatedHandDoesWhatItIsAskedTo)
{
  SelfTestRun run;
  ASSERT_EQ(run.start(simulated("simulated-joystick"), { 1e-3, true, {}, false, {} }), "");
  constexpr int longest_ticks = 100'000;
  for (int tick = 0; tick < longest_ticks && run.state().verdict == SelfTestVerdict::None; ++tick)
  {
    run.step(1);
  }
  EXPECT_EQ(run.state().verdict, SelfTestVerdict::Passed) << resultOf(run.plan(), run.state());
  run.stop();
  const auto found = calibrationFrom(run.plan(), run.state(), run.device(), "2026-01-31");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->device, "simulated-joystick");
  EXPECT_EQ(found->refusal(), "");
}

TEST(SelfTestRun, StoppedOnItsOwnThreadItEndsWithoutAResult)
{
  SelfTestRun run;
  ASSERT_EQ(run.start(simulated("simulated-premium")), "");
  EXPECT_TRUE(run.running());
  while (run.state().stage_s == 0.0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // it has begun
  }
  run.stop();
  EXPECT_FALSE(run.running());
  EXPECT_EQ(run.state().verdict, SelfTestVerdict::Aborted);
  EXPECT_EQ(run.state().reason, SelfTestReason::Stopped);
}

TEST(SelfTestRun, ADeviceWithoutForceIsNotEvenOpened)
{
  SelfTestRun run;
  EXPECT_NE(run.start(std::make_unique<FedDevice>()).find("no force"), std::string::npos);
  EXPECT_FALSE(run.running());
}

} // namespace
} // namespace palpate
