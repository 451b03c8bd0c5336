// SPDX-License-Identifier: GPL-3.0-or-later
// The check of an arm, whose kinematics say where a push must lead.
#include <gtest/gtest.h>

#include "devices/calibration/CalibratedDevice.h"
#include "testing/devices/calibration/SelfTested.h"

namespace palpate::test
{
namespace
{

/// A device with three axes that is taken for an arm, in the hand of somebody who never moves it.
SelfTested runArm(const Wiring& wiring)
{
  const Person stays = [](const Vec3&, double, const SelfTestState&) { return Vec3(Vec3::Zero()); };
  return run(*deviceModel("simulated-ideal"), "light", wiring, stays, {}, { false, 0.0, true });
}

Mat3 turnedRound(int axis)
{
  Mat3 motors = Mat3::Identity();
  motors(axis, axis) = -1.0;
  return motors;
}

TEST(SelfTestOfArms, PassesWithPushesOfHalfANewtonAndNobodyMovesTheArmToItsEnds)
{
  const SelfTested found = runArm({});
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_NEAR(found.largest_N, 0.5, 1e-9);
  const Calibration c = found.calibration();
  EXPECT_EQ(c.refusal(), "");
  EXPECT_EQ(c.axisCount, 3);
  for (int i = 0; i < 3; ++i)
  {
    const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(axis.sensor, i);
    EXPECT_EQ(axis.motor, i);
    EXPECT_EQ(axis.sensorSign, 1);
    EXPECT_EQ(axis.motorSign, 1);
    EXPECT_EQ(axis.high_m, found.device.workspaceRadius_m.value);
    EXPECT_EQ(axis.low_m, -axis.high_m);
  }
}

TEST(SelfTestOfArms, RefusesAnArmThatIsCalledAWheelForItsOtherAxesWouldPassUnchecked)
{
  DeviceInfo arm = infoOf(*deviceModel("simulated-ideal"));
  EXPECT_EQ(SelfTestPlan::forDevice(arm, {}, true).refusal(), "");
  arm.knowsAxes = true;
  EXPECT_EQ(SelfTestPlan::forDevice(arm, {}, true).refusal(), armIsNoWheel);
  EXPECT_EQ(SelfTestPlan::forDevice(arm).refusal(), "");
  arm.deviceClass = DeviceClass::Joystick2D;
  EXPECT_EQ(asWheel(arm).deviceClass, DeviceClass::Joystick2D);
}

TEST(SelfTestOfArms, TellsAnAxisThatIsReversed)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Wiring wiring;
    wiring.motors = turnedRound(axis);
    const SelfTested found = runArm(wiring);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty);
    EXPECT_EQ(found.state.reason, SelfTestReason::Reversed) << found.text();
    EXPECT_EQ(found.calibration().axisCount, 0) << "so its force stays limited";
  }
}

TEST(SelfTestOfArms, TellsAxesThatAreMixedUp)
{
  Wiring wiring;
  wiring.motors = swapped();
  const SelfTested found = runArm(wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty);
  EXPECT_EQ(found.state.reason, SelfTestReason::Turned) << found.text();
  Wiring leaking;
  leaking.motors(1, 0) = 0.9;
  const SelfTested leaks = runArm(leaking);
  EXPECT_EQ(leaks.state.verdict, SelfTestVerdict::Faulty);
  EXPECT_EQ(leaks.state.reason, SelfTestReason::BothAxes) << leaks.text();
}

TEST(SelfTestOfArms, TellsAMotorThatMovesNothing)
{
  Wiring wiring;
  wiring.motors(2, 2) = 0.0;
  const SelfTested found = runArm(wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty);
  EXPECT_EQ(found.state.reason, SelfTestReason::NoMotion) << found.text();
}

} // namespace
} // namespace palpate::test
