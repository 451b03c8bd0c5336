// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// A folder of its own for each test, empty; the joystick's sensors are swapped.
class CalibratedFactory : public testing::Test
{
protected:
  void SetUp() override
  {
    this->options.calibrationFolder = this->folder_.path().string();
    this->options.stroke.points_D = { Vec3(0.02, -0.03, 0.0) };
  }

  DeviceOptions options;

private:
  const test::TemporaryFolder folder_;
};

TEST_F(CalibratedFactory, AppliesWhatIsKnownOfADevice)
{
  Calibration c{ "simulated-joystick", "", "2026-01-31", 2, {} };
  c.axes[0] = { 1, -1, -0.06, 0.04, 1, -1, 0.0, 0.0 };
  c.axes[1] = { 0, 1, -0.03, 0.03, 0, 1, 0.0, 0.0 };
  ASSERT_EQ(saveCalibration(this->options.calibrationFolder, c), "");
  const MadeDevice made = makeDevice("simulated-joystick", this->options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_EQ(made.warning, "");
  EXPECT_EQ(made.device->info().workspaceRadius_m.value, 0.03);
  ASSERT_EQ(made.device->open(), "");
  DeviceSample sample;
  ASSERT_EQ(made.device->read(0.0, sample), DeviceStatus::Ok);
  constexpr double encoderStep_m = 0.1 / 1024;                  // of that joystick, whose numbers are rounded down
  EXPECT_NEAR(sample.pose_D.p.x(), 0.03 - 0.01, encoderStep_m); // the middle of x is at +0.01 once it is turned round
  EXPECT_NEAR(sample.pose_D.p.y(), 0.02, encoderStep_m);
}

TEST_F(CalibratedFactory, LeavesOtherDevicesAsTheyAre)
{
  EXPECT_EQ(makeDevice("simulated-falcon", this->options).device->info().workspaceRadius_m.value, 0.04);
}

TEST_F(CalibratedFactory, GivesNoDeviceThatMayPushTheWrongWayBecauseItsFileIsDamaged)
{
  const std::string path = calibrationFile(this->options.calibrationFolder, "simulated-joystick", "");
  std::ofstream(path) << "nonsense";
  const MadeDevice made = makeDevice("simulated-joystick", this->options);
  EXPECT_EQ(made.device, nullptr);
  EXPECT_NE(made.problem.find(path), std::string::npos) << made.problem;
}

} // namespace
} // namespace palpate
