// SPDX-License-Identifier: GPL-3.0-or-later
// The self-test through the kernel's driver, as it goes through a link of the PID class.
#include <gtest/gtest.h>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "testing/devices/evdev/EvdevRig.h"

namespace palpate
{
namespace
{

using test::EvdevRig;

constexpr double restingHand = 8.0, pace = 2e-3; // in half travels, the device's largest force and milliseconds

struct Outcome
{
  SelfTestPlan plan;
  SelfTestState state;
};

Outcome check(double motorSign)
{
  constexpr int longest_ms = 100'000;
  EvdevRig rig(test::stickTraits());
  EXPECT_EQ(rig.device.open(), "");
  rig.run(5);
  Outcome outcome{ SelfTestPlan::forDevice(rig.device.info()), {} };
  Vec3 hand = Vec3::Zero();
  for (int ms = 0; ms < longest_ms && outcome.state.verdict == SelfTestVerdict::None; ++ms)
  {
    const Vec3 asked = askedPlace_D(outcome.plan, outcome.state) / rig.scale().halfTravel_m;
    hand += (asked - hand).cwiseMax(-pace).cwiseMin(pace);
    const auto& at = rig.driver().position;
    rig.driver().push = { restingHand * (hand.x() - at[0]), restingHand * (-hand.y() - at[1]) };
    rig.run(1);
    rig.command = stepSelfTest(outcome.plan, rig.sample, rig.status, 1e-3, outcome.state);
    rig.command.wrench_D.force *= motorSign;
  }
  return outcome;
}

TEST(EvdevSelfTest, PassesAndFindsWhichWayEachMotorPushes)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const Outcome found = check(sign);
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << resultOf(found.plan, found.state);
    for (int axis = 0; axis < 2; ++axis)
    {
      EXPECT_EQ(findAxis(found.plan, found.state, axis).sign, 1);
      EXPECT_EQ(findMotor(found.plan, found.state, axis).sensor, axis);
      EXPECT_EQ(findMotor(found.plan, found.state, axis).sign, sign > 0.0 ? 1 : -1);
    }
  }
}

} // namespace
} // namespace palpate
