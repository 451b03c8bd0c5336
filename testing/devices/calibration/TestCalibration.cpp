// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/common/UserFolder.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

namespace fs = std::filesystem;

/// The driver's y counts motion to the left, and its x motion up; the motors are as they should be but x is reversed.
Calibration example()
{
  Calibration c{ "pid-1209-ffb0-17", "17", "2026-01-31", 2, {} };
  c.axes[0] = { 1, -1, -0.06, 0.04, 0, -1, 0.002, 0.5 };
  c.axes[1] = { 0, 1, -0.03, 0.03, 1, 1, 1.0 / 3.0, 0.0 };
  c.held = HeldProof::Felt;
  return c;
}

/// A folder of its own for each test, not there yet.
class CalibrationFiles : public testing::Test
{
protected:
  [[nodiscard]] std::string folder() const { return this->folder_.string(); }
  [[nodiscard]] std::string file() const { return calibrationFile(this->folder(), "pid-1209-ffb0-17", "17"); }
  [[nodiscard]] KeptCalibration load() const { return loadCalibration(this->folder(), "pid-1209-ffb0-17", "17"); }
  void write(const std::string& text) const
  {
    fs::create_directories(this->folder_);
    std::ofstream(this->file(), std::ios::binary) << text;
  }

private:
  const test::TemporaryFolder temporary_;
  const fs::path folder_ = this->temporary_.path() / "calibration";
};

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(Calibration, ComesBackFromItsTextToTheLastBit)
{
  test::Random random(test::testSeed(511));
  for (std::size_t run = 0; run < test::testCount(200); ++run)
  {
    Calibration c = example();
    c.axes[0].low_m = -random.uniform(1e-9, 1.0);
    c.axes[1].response_m_per_N = random.uniform(0.0, 1e-3);
    const auto parsed = parseCalibration(writeCalibration(c));
    ASSERT_TRUE(parsed.value) << parsed.problem;
    EXPECT_EQ(*parsed.value, c);
  }
}

TEST(Calibration, EveryProofIsKeptAndReadAgain)
{
  for (int proof = 0; proof <= static_cast<int>(HeldProof::NoLimit); ++proof)
  {
    Calibration c = example();
    c.held = static_cast<HeldProof>(proof);
    const auto parsed = parseCalibration(writeCalibration(c));
    ASSERT_TRUE(parsed.value) << parsed.problem;
    EXPECT_EQ(parsed.value->held, c.held);
  }
}

TEST(Calibration, EachWayOfBeingWrongIsNamed)
{
  const std::string good = writeCalibration(example());
  ASSERT_TRUE(parseCalibration(good).value);
  const std::vector<std::pair<std::string, std::string>> bad = {
    { "", "not a calibration" },
    { replaced(good, "calibration 2", "calibration 3"), "version" },
    { replaced(good, "calibration 2", "calibration 1"), "convention for directions" },
    { replaced(good, "held felt", "held hot"), "line 7" },
    { replaced(good, "held felt\n", ""), "line 7" },
    { replaced(good, "low -0.06", "low nan"), "line 5" },
    { replaced(good, "low -0.06", "low -inf"), "line 5" },
    { replaced(good, "low -0.06", "low 1e999"), "line 5" },
    { replaced(good, "low -0.06", "low 0.04"), "no range" },
    { replaced(good, "low -0.06", "low -1e9"), "outside the lengths" },
    { replaced(good, "strength 0.5", "strength -0.5"), "strength" },
    { replaced(good, "sensor y-", "sensor x-"), "share a sensor" },
    { replaced(good, "motor x-", "motor y-"), "share a sensor or a motor" },
    { replaced(good, "motor x-", "motor z-"), "axis that the device lacks" },
    { replaced(good, "motor x-", "motor x"), "line 5" },
    { replaced(good, "axis y", "axis z"), "line 6" },
    { replaced(good, "2026-01-31", "yesterday"), "date" },
    { replaced(good, "serial 17", "serial " + std::string(300, '1')), "line 3" },
    { replaced(good, "serial 17", "serial 1\a7"), "line 3" },
    { good + "end\n", "line 9" },
    { good + std::string(5000, ' '), "longer than any" },
  };
  for (const auto& [text, reason] : bad)
  {
    const auto parsed = parseCalibration(text);
    EXPECT_FALSE(parsed.value) << text;
    EXPECT_NE(parsed.problem.find(reason), std::string::npos) << reason << " is not in: " << parsed.problem;
  }
}

TEST(Calibration, NoPartOfItPassesForTheWhole)
{
  const std::string good = writeCalibration(example());
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    EXPECT_FALSE(parseCalibration(good.substr(0, length)).value) << length;
  }
}

TEST(Calibration, TheFolderIsThatOfThePersonsSettings)
{
  EXPECT_EQ(userCalibrationFolder("/settings", "/me"), "/settings/palpate/calibration");
  EXPECT_EQ(userCalibrationFolder(nullptr, "/me"), "/me/.config/palpate/calibration");
  EXPECT_EQ(userCalibrationFolder("relative", "/me"), "/me/.config/palpate/calibration"); // must be ignored, says XDG
  EXPECT_EQ(userCalibrationFolder("", nullptr), "");
  EXPECT_EQ(userFolder(nullptr, "/me", "arms"), "/me/.config/palpate/arms");
}

TEST(Calibration, DevicesThatDifferInOddCharactersOnlyHaveFilesOfTheirOwn)
{
  const std::string one = calibrationFile("f", "pid", "a/b"), other = calibrationFile("f", "pid", "a:b");
  EXPECT_NE(one, other);
  EXPECT_EQ(fs::path(one).parent_path(), "f");
  EXPECT_EQ(fs::path(calibrationFile("f", "../..", "..")).parent_path(), "f");
}

TEST_F(CalibrationFiles, NothingIsKnownOfADeviceThatWasNeverChecked)
{
  const KeptCalibration kept = this->load();
  EXPECT_FALSE(kept.value);
  EXPECT_EQ(kept.problem, "");
}

TEST_F(CalibrationFiles, WhatWasKeptIsFoundAgainAndLeavesNothingElseBehind)
{
  ASSERT_EQ(saveCalibration(this->folder(), example()), "");
  EXPECT_EQ(this->load().value, example());
  EXPECT_EQ(std::distance(fs::directory_iterator(this->folder()), fs::directory_iterator()), 1);
}

TEST_F(CalibrationFiles, ADamagedFileGivesTheOneBeforeItAndSaysSo)
{
  ASSERT_EQ(saveCalibration(this->folder(), example()), "");
  Calibration second = example(), unfelt = example();
  ASSERT_EQ(unfelt.held, HeldProof::Felt);
  unfelt.held = HeldProof::Unfelt; // the damaged file may have proved less of the walls
  second.date = "2026-02-01";
  ASSERT_EQ(saveCalibration(this->folder(), second), "");
  this->write("palpate calib");
  const KeptCalibration kept = this->load();
  EXPECT_EQ(kept.value, unfelt);
  EXPECT_NE(kept.problem.find(this->file()), std::string::npos) << kept.problem;
  EXPECT_NE(kept.problem.find("previous calibration is used"), std::string::npos) << kept.problem;

  // A new one takes the place of the damaged one, not of the good one.
  ASSERT_EQ(saveCalibration(this->folder(), second), "");
  EXPECT_EQ(this->load().value, second);
  this->write("");
  EXPECT_EQ(this->load().value, unfelt);
}

TEST_F(CalibrationFiles, ACheckThatFeelsAFaultEndsTheTrustThatWasKept)
{
  ASSERT_EQ(saveCalibration(this->folder(), example()), "");
  const auto takeBack = [&](HeldProof proof)
  { return takeBackTrust(this->folder(), example().device, example().serial, proof); };
  ASSERT_EQ(takeBack(HeldProof::Unfelt), ""); // it ended before it felt anything
  EXPECT_EQ(this->load().value, example());
  ASSERT_EQ(takeBack(HeldProof::WrongWay), "");
  Calibration doubted = example();
  doubted.held = HeldProof::WrongWay;
  EXPECT_EQ(this->load().value, doubted);
  this->write("");
  EXPECT_NE(this->load().value->held, HeldProof::Felt);
}

TEST_F(CalibrationFiles, WithoutAnOlderOneADamagedFileIsNamedWithItsReason)
{
  this->write(replaced(writeCalibration(example()), "low -0.06", "low nan"));
  const KeptCalibration kept = this->load();
  EXPECT_FALSE(kept.value);
  EXPECT_EQ(kept.problem, this->file() + ": line 5 is damaged or not as expected");
}

TEST_F(CalibrationFiles, ACopyOfAnotherDevicesFileIsNotTaken)
{
  this->write(replaced(writeCalibration(example()), "serial 17", "serial 18"));
  const KeptCalibration kept = this->load();
  EXPECT_FALSE(kept.value);
  EXPECT_NE(kept.problem.find("another device"), std::string::npos) << kept.problem;
}

TEST_F(CalibrationFiles, OneThatCannotBeWrittenLeavesTheOldOne)
{
  ASSERT_EQ(saveCalibration(this->folder(), example()), "");
  fs::create_directories(this->file() + ".part"); // no file can have that name now
  Calibration second = example();
  second.date = "2026-02-01";
  const std::string problem = saveCalibration(this->folder(), second);
  EXPECT_NE(problem.find(this->file()), std::string::npos) << problem;
  EXPECT_EQ(this->load().value, example());
}

TEST_F(CalibrationFiles, OneThatCannotBeIsNotKept)
{
  Calibration c = example();
  c.axes[0].high_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(saveCalibration(this->folder(), c), "");
  EXPECT_FALSE(fs::exists(this->folder()));
}

/// Remembers each command and shows the pose that it is set to.
class Notebook final : public HapticDevice
{
public:
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override
  {
    this->info_.offersWalls = this->info_.abilities.holdsWalls = this->info_.abilities.viscous = true;
    return {};
  }
  void close() noexcept override {}
  /// Of a device that is gone nothing is known.
  [[nodiscard]] DeviceStatus read(double, DeviceSample& sample) noexcept override
  {
    sample = this->status == DeviceStatus::Ok ? this->shown : sample;
    return this->status;
  }
  void write(const DeviceCommand& command) noexcept override { this->told = command; }

  void describe(DeviceClass deviceClass) { this->info_.deviceClass = deviceClass; }

  DeviceStatus status = DeviceStatus::Ok;
  DeviceSample shown;
  DeviceCommand told;

private:
  DeviceInfo info_;
};

/// That device, calibrated.
struct CalibratedNotebook
{
  CalibratedNotebook() : CalibratedNotebook(std::make_unique<Notebook>()) {}
  explicit CalibratedNotebook(std::unique_ptr<Notebook> notebook)
    : raw(*notebook), device(std::move(notebook), example())
  {
  }

  /// The sample of the raw hand at one place.
  DeviceSample readThere()
  {
    this->raw.shown.pose_D.p = Vec3(0.02, -0.06, 0.001);
    this->raw.shown.velocity_D.linear = Vec3(1.0, 2.0, 3.0);
    DeviceSample sample;
    EXPECT_EQ(this->device.read(0.0, sample), DeviceStatus::Ok);
    return sample;
  }

  Notebook& raw;
  CalibratedDevice device;
};

TEST(CalibratedDevice, ShowsRightAsXAndPushesWhereAForcePoints)
{
  CalibratedNotebook rig;
  // The driver's y at its low end, -0.06, is the right end: half of the range of 0.1 m from the middle.
  const DeviceSample sample = rig.readThere();
  EXPECT_LT((sample.pose_D.p - Vec3(0.05, 0.02, 0.001)).norm(), 1e-15);
  EXPECT_EQ(sample.velocity_D.linear, Vec3(-2.0, 1.0, 3.0));

  DeviceCommand command;
  command.wrench_D.force = Vec3(1.0, 2.0, 3.0);
  rig.device.write(command);
  EXPECT_EQ(rig.raw.told.wrench_D.force, Vec3(-1.0, 2.0, 3.0));
}

// A host that closes a wall for the device does so along the driver's axes of measurement; its motors push.
TEST(CalibratedDevice, AForceForAWallThatTheHostClosesPushesWhereTheWallDoes)
{
  CalibratedNotebook rig;
  test::Random random(test::testSeed(513));
  for (std::size_t run = 0; run < test::testCount(100); ++run)
  {
    DeviceCommand command;
    const Vec3 push_D = random.direction();
    command.wallCount = 1;
    command.walls[0] = { push_D, 0.0, 100.0 };
    command.wrench_D.force = push_D; // the same as a force of the tick, which is known to be right
    rig.device.write(command);
    EXPECT_LT((rig.raw.told.wallMotors * rig.raw.told.walls[0].normal_D - rig.raw.told.wrench_D.force).norm(), 1e-15);
  }
}

TEST(CalibratedDevice, LeavesWallsToADeviceOnlyWhereTheyWereFelt)
{
  for (const HeldProof proof : { HeldProof::Unfelt, HeldProof::Felt, HeldProof::WrongWay })
  {
    Calibration c = example();
    c.held = proof;
    CalibratedDevice device(std::make_unique<Notebook>(), c);
    EXPECT_FALSE(Notebook().info().closesWalls());
    ASSERT_EQ(device.open(), "");
    EXPECT_EQ(device.info().closesWalls(), proof == HeldProof::Felt);
  }
}

TEST(CalibratedDevice, OneAxisMakesAWheelOfAStick)
{
  Calibration c{ "pid-1209-ffb0-17", "17", "2026-01-31", 1, {} };
  c.axes[0] = { 0, 1, -0.05, 0.05, 1, -1, 0.002, 0.5 }; // its motor calls itself y
  ASSERT_EQ(c.refusal(), "");
  auto notebook = std::make_unique<Notebook>();
  notebook->describe(DeviceClass::Joystick2D);
  Notebook& raw = *notebook;
  CalibratedDevice device(std::move(notebook), c);
  EXPECT_EQ(device.info().deviceClass, DeviceClass::Wheel1D);
  raw.shown.pose_D.p = Vec3(0.01, 0.02, 0.0);
  DeviceSample sample;
  ASSERT_EQ(device.read(0.0, sample), DeviceStatus::Ok);
  EXPECT_EQ(sample.pose_D.p, Vec3(0.01, 0.0, 0.0));
  DeviceCommand command;
  command.wrench_D.force = Vec3(2.0, 3.0, 4.0);
  device.write(command);
  EXPECT_EQ(raw.told.wrench_D.force, Vec3(0.0, -2.0, 0.0));
}

TEST(CalibratedDevice, AHandStaysWhereItWasSeenLastWhileTheDeviceIsGone)
{
  CalibratedNotebook rig;
  const DeviceSample last = rig.readThere();
  DeviceSample sample = last;
  rig.raw.status = DeviceStatus::Lost;
  for (int tick = 0; tick < 3; ++tick)
  {
    EXPECT_EQ(rig.device.read(1e-3 * tick, sample), DeviceStatus::Lost);
    EXPECT_EQ(sample.pose_D.p, last.pose_D.p);
    EXPECT_EQ(sample.velocity_D.linear, last.velocity_D.linear);
  }
}

TEST(CalibratedDevice, AWallThatTheDeviceHoldsStandsWhereItStoodForTheHand)
{
  CalibratedNotebook rig;
  test::Random random(test::testSeed(512));
  for (std::size_t run = 0; run < test::testCount(100); ++run)
  {
    DeviceCommand command;
    command.wallCount = 1;
    command.walls[0] = { random.direction(), random.uniform(-0.05, 0.05), 100.0 };
    rig.device.write(command);
    rig.raw.shown.pose_D.p = random.direction() * 0.05;
    DeviceSample sample;
    ASSERT_EQ(rig.device.read(0.0, sample), DeviceStatus::Ok);
    const DeviceWall& seen = command.walls[0];
    const DeviceWall& told = rig.raw.told.walls[0];
    EXPECT_NEAR(told.normal_D.dot(rig.raw.shown.pose_D.p) - told.offset_m,
      seen.normal_D.dot(sample.pose_D.p) - seen.offset_m, 1e-15);
  }
}

TEST(CalibratedDevice, ItsWorkspaceIsTheLargestBallBetweenItsEnds)
{
  const CalibratedDevice device(std::make_unique<Notebook>(), example());
  EXPECT_EQ(device.info().workspaceRadius_m.value, 0.03); // y goes from -0.03 to 0.03, x has 0.1
  EXPECT_TRUE(device.info().workspaceRadius_m.known);
}

TEST(CalibratedDevice, SaysWhatItsDeviceLearntWhenItWasOpened)
{
  CalibratedDevice device(std::make_unique<Notebook>(), example());
  EXPECT_FALSE(device.info().abilities.holdsWalls);
  ASSERT_EQ(device.open(), "");
  EXPECT_TRUE(device.info().abilities.holdsWalls);
  EXPECT_EQ(device.info().workspaceRadius_m.value, 0.03);
}

} // namespace
} // namespace palpate
