// SPDX-License-Identifier: GPL-3.0-or-later
// Which sensors and motors a device has is found.
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "testing/devices/calibration/SelfTested.h"

namespace palpate::test
{
namespace
{

TEST(SelfTest, ADeviceAsItShouldBeIsFoundAsItIs)
{
  const SelfTested found = run(joystick(), "light", {});
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  ASSERT_EQ(c.refusal(), "");
  EXPECT_EQ(c.axisCount, 2);
  for (int i = 0; i < 2; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const AxisCalibration& axis = c.axes[at];
    EXPECT_EQ(std::pair(axis.sensor, axis.sensorSign), std::pair(i, 1));
    EXPECT_EQ(std::pair(axis.motor, axis.motorSign), std::pair(i, 1));
    EXPECT_NEAR(axis.low_m, -joystick().travel_m, joystick().encoderStep_m); // which rounds down
    EXPECT_NEAR(axis.high_m, joystick().travel_m, joystick().encoderStep_m);
    const double step_m = joystick().encoderStep_m, hand_N_per_m = handModel("light")->stiffness_N_per_m;
    EXPECT_NEAR(axis.response_m_per_N * hand_N_per_m, 1.0, roundingError(found.state.motors[at].free[0], at, step_m));
    EXPECT_NEAR(axis.strength, 1.0, strengthError(found, at, step_m, hand_N_per_m));
  }
}

TEST(SelfTest, NoPushIsStrongerThanATenthOrLongerThanHalfASecond)
{
  for (const DeviceModel& model : deviceModels())
  {
    const SelfTested found = run(model, "light", {});
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << model.name << ": " << found.text();
    EXPECT_LE(found.largest_N, 0.1 * std::min(model.maxForce_N, 5.0) * (1.0 + 1e-12)) << model.name;
    EXPECT_GT(found.largest_N, 0.0);
    EXPECT_LE(found.longestPush_s, 0.5) << model.name;
  }
}

TEST(SelfTest, AnExactDeviceShowsTheStiffnessOfTheHandThatHoldsIt)
{
  for (const char* name : { "light", "stylus", "firm" })
  {
    const HandModel& hand = *handModel(name);
    const SelfTested found = run(*deviceModel("simulated-ideal"), name, {});
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
    const Calibration c = found.calibration();
    for (const AxisCalibration& axis : c.axes)
    {
      // The rest is the lag of the hand: it lags by b / K, a hundredth of a second of the ramp's 0.4.
      EXPECT_NEAR(axis.response_m_per_N * hand.stiffness_N_per_m, 1.0, 0.05) << name;
    }
  }
}

TEST(SelfTest, EverySwappedAndTurnedSensorIsFound)
{
  for (int signs = 0; signs < 4; ++signs)
  {
    for (const Mat3& order : { Mat3(Mat3::Identity()), swapped() })
    {
      Wiring wiring;
      wiring.sensors = order * Vec3(signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, 1.0).asDiagonal();
      const SelfTested found = run(joystick(), "light", wiring);
      ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
      const Calibration c = found.calibration();
      for (int i = 0; i < 2; ++i)
      {
        const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
        EXPECT_EQ(wiring.sensors(axis.sensor, i), axis.sensorSign); // the sensor of axis i of D, and its sign
        EXPECT_EQ(std::pair(axis.motor, axis.motorSign), std::pair(i, 1));
      }
    }
  }
}

TEST(SelfTest, EverySwappedAndTurnedMotorIsFoundWhateverTheSensorsAre)
{
  for (int signs = 0; signs < 4; ++signs)
  {
    for (const Mat3& order : { Mat3(Mat3::Identity()), swapped() })
    {
      Wiring wiring;
      wiring.motors = order * Vec3(signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, 1.0).asDiagonal();
      wiring.sensors = swapped() * Vec3(1.0, -1.0, 1.0).asDiagonal();
      const SelfTested found = run(joystick(), "light", wiring);
      ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
      const Calibration c = found.calibration();
      for (int i = 0; i < 2; ++i)
      {
        const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
        EXPECT_EQ(wiring.motors(i, axis.motor), axis.motorSign); // a positive command moves axis i of D in that
                                                                 // direction
      }
    }
  }
}

TEST(SelfTest, SwappedAxesOfThreeAreFound)
{
  Wiring wiring;
  wiring.sensors << 0, 0, -1, 1, 0, 0, 0, 1, 0;
  wiring.motors << 0, 1, 0, 0, 0, 1, -1, 0, 0;
  const SelfTested found = run(*deviceModel("simulated-premium"), "light", wiring);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  for (int i = 0; i < 3; ++i)
  {
    const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(wiring.sensors(axis.sensor, i), axis.sensorSign);
    EXPECT_EQ(wiring.motors(i, axis.motor), axis.motorSign);
  }
}

TEST(SelfTest, AMotorThatIsWeakIsSaidAndMeasuredAgainstTheDevicesOwnSpring)
{
  Wiring wiring;
  wiring.motors(1, 1) = 0.25;
  DeviceModel smooth = joystick(); // a quarter of the push would not overcome its friction
  smooth.friction_N = 0.0;
  const SelfTested found = run(smooth, "light", wiring);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  EXPECT_NEAR(c.axes[1].response_m_per_N / c.axes[0].response_m_per_N, 0.25, 0.05);
  EXPECT_NEAR(
    c.axes[0].strength, 1.0, strengthError(found, 0, smooth.encoderStep_m, handModel("light")->stiffness_N_per_m));
  EXPECT_NE(found.text().find("weak beside the strongest"), std::string::npos) << found.text();
}

TEST(SelfTest, ADeadMotorIsAFaultAndGivesNoCalibration)
{
  for (int motor = 0; motor < 2; ++motor)
  {
    Wiring wiring;
    wiring.motors(motor, motor) = 0.0;
    const SelfTested found = run(joystick(), "light", wiring);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
    EXPECT_EQ(found.state.reason, SelfTestReason::NoMotion);
    EXPECT_EQ(findMotor(found.plan, found.state, motor).motion, MotorMotion::None);
    EXPECT_EQ(findMotor(found.plan, found.state, 1 - motor).motion, MotorMotion::Clear);
    EXPECT_FALSE(calibrationFrom(found.plan, found.state, found.device, "2026-01-31"));
    EXPECT_NE(found.text().find(std::string("motor ") + "xy"[motor] + ": moves nothing"), std::string::npos);
  }
}

} // namespace
} // namespace palpate::test
