// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/hid/pid/PidWalls.h"
#include "devices/io/HidDiscovery.h"
#include "testing/devices/hid/FakeHidBus.h"
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

/// The calibration of a stick is there, and one more is plugged in.
class CalibratedTwins : public CalibratedFactory
{
protected:
  void plugBoth(const std::string& serial)
  {
    auto bus = std::make_shared<test::FakeHidBus>();
    this->options.hid = bus;
    bus->plug(test::plainLayout(), serial);
    Calibration c{ findHidDevices(*bus).front().name, serial, "2026-01-31", 2, {} };
    c.axes[0] = { 0, -1, -0.03, 0.03, 0, -1, 0.0, 0.0 };
    c.axes[1] = { 1, 1, -0.03, 0.03, 1, 1, 0.0, 0.0 };
    ASSERT_EQ(saveCalibration(this->options.calibrationFolder, c), "");
    this->alone = makeDevice(c.device, this->options);
    bus->plug(test::plainLayout(), serial);
    this->together = makeDevice(c.device, this->options);
    this->known = knownDevices(this->options);
    applyCalibrations(this->known, this->options.calibrationFolder);
  }
  MadeDevice alone, together;
  std::vector<KnownDevice> known;
};

TEST_F(CalibratedTwins, UsesWhatIsKnownOfAStickOnlyWhereNoneIsPluggedInThatNothingTellsApart)
{
  for (const std::string serial : { "", "7" })
  {
    this->plugBoth(serial);
    ASSERT_NE(this->alone.device, nullptr);
    ASSERT_NE(this->together.device, nullptr);
    EXPECT_EQ(this->alone.device->info().workspaceRadius_m.value, 0.03);
    EXPECT_EQ(this->alone.warning, "");
    EXPECT_EQ(this->together.device->info().workspaceRadius_m.value, PidScale().halfTravel_m);
    EXPECT_EQ(this->together.warning, twinNote);
    EXPECT_TRUE(this->known.back().hasTwin);
    const KnownDevice& first = this->known[this->known.size() - 2];
    EXPECT_TRUE(first.hasTwin);
    EXPECT_EQ(first.info.workspaceRadius_m.value, PidScale().halfTravel_m);
  }
}

TEST_F(CalibratedFactory, OneOfAnotherSerialNumberIsNoTwin)
{
  auto bus = std::make_shared<test::FakeHidBus>();
  bus->plug(test::plainLayout(), "7");
  bus->plug(test::plainLayout(), "8");
  this->options.hid = bus;
  EXPECT_FALSE(knownDevices(this->options).back().hasTwin);
}

} // namespace
} // namespace palpate
