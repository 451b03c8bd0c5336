// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain of a WoodenHaptics arm, against a model of its firmware and mechanics.
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/kit/WoodenHapticsFile.h"
#include "devices/calibration/CalibrationFiles.h"
#include "testing/devices/arm/WoodenHapticsRig.h"
#include "testing/support/Random.h"
#include <gmock/gmock.h>

namespace palpate
{
namespace
{

using test::WoodenHapticsRig;

/// The largest distance between the tip and the position by its counters: half a count in each of three joints.
constexpr double oneCount_m = 3e-4;

TEST(WoodenHaptics, IsFoundWithItsOwnersFileAndRefusedByNameWithout)
{
  WoodenHapticsRig rig;
  std::vector<FoundArm> found = findArms({ rig.kit });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "woodenhaptics-1234-0006-7");
  EXPECT_EQ(found[0].problem, "");
  const std::vector<ArmKit> without{ woodenHapticsKit(rig.bus, rig.folder.file("none.json")) };
  found = findArms(without);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].problem, testing::HasSubstr("none.json: it is missing"));
  EXPECT_EQ(rig.model->orders, 0) << "looking tells an arm nothing";
}

TEST(WoodenHaptics, GivesNoHandAndNoForceBeforeItsCountersAreSetInItsPose)
{
  WoodenHapticsRig rig;
  rig.command.wrench_D.force = Vec3(0.0, 0.0, -1.0);
  ASSERT_EQ(rig.device.open(), "");
  rig.run(100);
  EXPECT_EQ(rig.status, DeviceStatus::Waiting);
  ASSERT_TRUE(rig.device.step());
  EXPECT_THAT(rig.device.linkReport().message, testing::HasSubstr("calibration pose"));
  EXPECT_EQ(rig.model->force_N().norm(), 0.0);
  EXPECT_EQ(rig.model->setOrders, 0);
  rig.device.stepDone("");
  rig.run(50);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_FALSE(rig.device.step());
  EXPECT_EQ(rig.model->setOrders, 1);
  EXPECT_NEAR((rig.sample.pose_D.p - rig.model->tip_m()).norm(), 0.0, oneCount_m);
}

TEST(WoodenHaptics, SetsItsCountersWhenItsOwnButtonIsPressed)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.device.open(), "");
  rig.run(10);
  rig.model->pressed = true;
  rig.run(50);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.model->setOrders, 1);
}

TEST(WoodenHaptics, AppliesTheForceThatIsAskedToHalfAStepOfItsCurrentsEverywhere)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  rig.command = {};
  rig.run(5); // a person lets go of all force first
  test::Random random(5);
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 at_m = 0.05 * random.direction() + Vec3(0.0, 0.0, 0.02);
    ASSERT_TRUE(rig.model->lead(at_m));
    rig.command.wrench_D.force = 2.0 * random.direction();
    rig.run(4);
    EXPECT_NEAR((rig.sample.pose_D.p - at_m).norm(), 0.0, oneCount_m) << at_m.transpose();
    // The Jacobian is that of the counted place: a count turns a force of 2 N by less than 1e-2.
    const double counted_N = 2.0 * 1e-2;
    EXPECT_LE((rig.model->force_N() - rig.command.wrench_D.force).norm(), rig.model->halfStep_N() + counted_N);
  }
}

/// Poses at one end of one joint, where the others keep the arm far from singular.
struct JointEnd
{
  int joint;
  double end_deg;   ///< of the arm of 2015
  double range_deg; ///< of that joint
  Vec3 pose_deg;    ///< its own joint at the end
};

// Force fades to none over the last 5 % of a joint's range.
TEST(WoodenHaptics, GivesNoForcePastTheEndsOfItsJointsAndAllOfItBeforeThem)
{
  constexpr double rad_per_deg = std::numbers::pi / 180.0;
  const std::array<JointEnd, 6> ends{ { { 0, 100.0, 200.0, { 100.0, 0.0, 90.0 } },
    { 0, -100.0, 200.0, { -100.0, 0.0, 90.0 } }, { 1, 80.0, 160.0, { 0.0, 80.0, 10.0 } },
    { 1, -80.0, 160.0, { 0.0, -80.0, 150.0 } }, { 2, 170.0, 180.0, { 0.0, -60.0, 170.0 } },
    { 2, -10.0, 180.0, { 0.0, 60.0, -10.0 } } } };
  for (const JointEnd& end : ends)
  {
    WoodenHapticsRig rig;
    ASSERT_EQ(rig.open(), "");
    const Vec3 outward_deg = (end.end_deg < 0.0 ? -1.0 : 1.0) * Vec3::Unit(end.joint);
    rig.model->place(rad_per_deg * (end.pose_deg - 0.06 * end.range_deg * outward_deg));
    ask(rig, { 0.0, 0.7, 0.0 });
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    // The Jacobian is that of the counted place: a count turns a force by less than 1 in 100.
    EXPECT_LE((rig.model->force_N() - Vec3(0.0, 0.7, 0.0)).norm(), rig.model->halfStep_N() + 0.7 * 1e-2)
      << "joint " << end.joint << " before " << end.end_deg;
    rig.model->place(rad_per_deg * (end.pose_deg + 0.5 * outward_deg));
    rig.run(5);
    EXPECT_EQ(rig.status, DeviceStatus::Ok) << "it is read there";
    EXPECT_NEAR((rig.sample.pose_D.p - rig.model->tip_m()).norm(), 0.0, oneCount_m);
    EXPECT_EQ(rig.model->force_N().norm(), 0.0) << "joint " << end.joint << " past " << end.end_deg;
  }
}

TEST(WoodenHaptics, FollowsItsCountersWhereTheyWrap)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  // 16 turns of the column's capstan are 32 000 counts and one turn of the body; twice that wraps the counter.
  const Vec3 from = rig.model->joints_rad();
  for (int i = 1; i <= 1000; ++i)
  {
    rig.model->place(from + 4e-3 * std::numbers::pi * i * Vec3::UnitX());
    rig.run(1);
  }
  rig.run(3);
  EXPECT_NEAR((rig.sample.pose_D.p - rig.model->tip_m()).norm(), 0.0, oneCount_m);
}

TEST(WoodenHaptics, IsLimitedToOneNewtonUntilItIsProven)
{
  WoodenHapticsRig rig(false);
  ASSERT_EQ(rig.open(), "");
  EXPECT_EQ(rig.device.info().maxForce_N.value, 1.0);
  ask(rig, Vec3(0.0, 3.0, 0.0), 10);
  EXPECT_NEAR((rig.model->force_N() - Vec3(0.0, 1.0, 0.0)).norm(), 0.0, rig.model->halfStep_N() + 1e-2);
}

// The watchdog of its firmware lasts half a second, at which it looks once a period of its reports.
TEST(WoodenHaptics, HasNoForceHalfASecondAndOneReportAfterTheLastOrderOfAProgramThatStops)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  int silent_ms = 0;
  for (const int orders = rig.model->orders; rig.model->force_N().norm() > 0.0 && silent_ms < 1000; ++silent_ms)
  {
    rig.bus->advance(1);
    ASSERT_EQ(rig.model->orders, orders);
  }
  using test::WoodenHapticsModel;
  EXPECT_LE(silent_ms, WoodenHapticsModel::watchdog_ms + WoodenHapticsModel::period_ms);
  EXPECT_GE(silent_ms, WoodenHapticsModel::watchdog_ms - WoodenHapticsModel::period_ms) << "the exchange took one";
  EXPECT_EQ(rig.model->wentOffAfter_ms, WoodenHapticsModel::watchdog_ms + WoodenHapticsModel::period_ms);
}

/// Kinds of faults of the link.
struct Fault
{
  const char* name;
  void (*happen)(WoodenHapticsRig& rig);
  const char* sentence;
};

class WoodenHapticsFaults : public testing::TestWithParam<Fault>
{
};

TEST_P(WoodenHapticsFaults, EndTheForceWithinTwentyMilliseconds)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  ASSERT_GT(rig.model->force_N().norm(), 1.9);
  GetParam().happen(rig);
  rig.run(20);
  const bool hears = rig.port.present && !rig.model->frozen && rig.port.writesThatFail == 0;
  EXPECT_TRUE(!hears || rig.model->force_N().norm() == 0.0) << "what hears is told";
  EXPECT_GE(rig.lostTicks, 1) << "the servo is told of it, also of a device that is found again at once";
  EXPECT_NE(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.device.linkReport().lostFor, GetParam().sentence);
  rig.run(test::WoodenHapticsModel::watchdog_ms);
  EXPECT_TRUE(!rig.port.present || rig.model->force_N().norm() == 0.0) << "and its own watchdog ends the rest";
}

INSTANTIATE_TEST_SUITE_P(Each, WoodenHapticsFaults,
  testing::Values(
    Fault{ "Unplugged", [](WoodenHapticsRig& rig) { rig.port.present = false; }, "the cable was unplugged" },
    Fault{ "Frozen", [](WoodenHapticsRig& rig) { rig.model->frozen = true; }, "the device does not answer" },
    Fault{ "Silent", [](WoodenHapticsRig& rig) { rig.model->silentFor = 1000; }, "the device does not answer" },
    Fault{ "HalfMessages", [](WoodenHapticsRig& rig) { rig.model->cutAnswers = 1000; },
      "the device answers with something else than its protocol has" },
    Fault{ "WrongAnswers", [](WoodenHapticsRig& rig) { rig.model->wrongAnswers = 1000; },
      "the device answers with something else than its protocol has" },
    Fault{ "FailingWrites", [](WoodenHapticsRig& rig) { rig.port.writesThatFail = 1000; },
      "the device rejects force commands: Input/output error" }),
  [](const auto& one) { return one.param.name; });

TEST(WoodenHaptics, IsToldNoForceAtEachStepOfAnExchangeThatIsUnplugged)
{
  for (int calls = 0; calls < 6; ++calls)
  {
    WoodenHapticsRig rig;
    ASSERT_EQ(rig.open(), "");
    ask(rig, Vec3(0.0, 2.0, 0.0));
    rig.port.callsUntilUnplugged = calls;
    rig.run(20);
    EXPECT_EQ(rig.status, DeviceStatus::Lost) << calls;
    EXPECT_THAT(rig.device.linkReport().lostFor, testing::HasSubstr("unplugged")) << calls;
  }
}

TEST(WoodenHaptics, OneAnswerThatIsMissingCostsOneMomentOfForceAndNoMore)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  rig.model->wrongAnswers = 1;
  rig.tick();
  rig.pass(); // the wrong answer
  rig.pass();
  EXPECT_EQ(rig.model->force_N().norm(), 0.0) << "no force while it is doubted";
  rig.run(5);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_GT(rig.model->force_N().norm(), 1.9);
}

TEST(WoodenHaptics, ComesBackWithoutForceAndWithItsCountersUnset)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  rig.port.present = false;
  rig.run(600);
  rig.port.present = true;
  rig.run(1200);
  EXPECT_TRUE(rig.device.linkReport().attached);
  EXPECT_EQ(rig.status, DeviceStatus::Waiting);
  rig.device.stepDone("");
  rig.run(50);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.model->force_N().norm(), 0.0) << "only a person brings it back";
  ask(rig, Vec3(0.0, 2.0, 0.0), 5);
  EXPECT_GT(rig.model->force_N().norm(), 1.9);
}

TEST(WoodenHaptics, GivesNoForceWhileTheServoIsSilentAndForCommandsThatAreNoNumbers)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  for (int i = 0; i < 25; ++i)
  {
    rig.pass();
  }
  EXPECT_EQ(rig.model->force_N().norm(), 0.0);
  rig.run(5);
  EXPECT_GT(rig.model->force_N().norm(), 1.9);
  rig.command.wrench_D.force.x() = std::nan("");
  rig.run(5);
  EXPECT_EQ(rig.model->force_N().norm(), 0.0);
}

TEST(WoodenHaptics, IsLeftWithoutForce)
{
  WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  ask(rig, Vec3(0.0, 2.0, 0.0));
  rig.device.close();
  EXPECT_EQ(rig.model->force_N().norm(), 0.0);
}

/// A check of a device along its first axes, as it passes.
Calibration checkOf(const std::string& name, const std::string& serial, int axes)
{
  Calibration check{ name, serial, "2026-01-31", axes, {} };
  for (int i = 0; i < axes; ++i)
  {
    check.axes[static_cast<std::size_t>(i)] = { i, 1, -0.1, 0.1, i, 1, 0.01, 0.0 };
  }
  return check;
}

TEST(WoodenHaptics, GivesAllOfItsForceOnceItsCheckWasKeptForItsNumber)
{
  WoodenHapticsRig rig;
  DeviceOptions options;
  options.hid = rig.bus;
  options.arms = std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ rig.kit });
  options.calibrationFolder = rig.folder.path();
  const std::string name = "woodenhaptics-1234-0006-7";
  MadeDevice made = makeDevice(name, options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_EQ(made.device->info().maxForce_N.value, 1.0);
  ASSERT_EQ(saveCalibration(options.calibrationFolder, checkOf(name, "7", 3)), "");
  made = makeDevice(name, options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_EQ(made.device->info().maxForce_N.value, 5.0) << "of the owner's file";
  EXPECT_EQ(made.device->info().pacing, Pacing::Device);
}

/// Its options, and a check along its first axes that was kept.
struct KeptCheck
{
  KeptCheck(const WoodenHapticsRig& rig, const std::string& serial, int axes)
    : name("woodenhaptics-1234-0006" + (serial.empty() ? "" : "-" + serial))
  {
    this->options.hid = rig.bus;
    this->options.arms = std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ rig.kit });
    this->options.calibrationFolder = rig.folder.path();
    this->kept = checkOf(this->name, serial, axes);
    EXPECT_EQ(saveCalibration(this->options.calibrationFolder, this->kept), "");
  }
  [[nodiscard]] double largest_N() const
  {
    const MadeDevice made = makeDevice(this->name, this->options);
    EXPECT_NE(made.device, nullptr) << made.problem;
    return made.device != nullptr ? made.device->info().maxForce_N.value : 0.0;
  }

  std::string name;
  DeviceOptions options;
  Calibration kept;
};

TEST(WoodenHaptics, WithoutANumberIsProvenByACheckOfThisSessionAlone)
{
  WoodenHapticsRig rig;
  rig.port.entry.serial.clear();
  KeptCheck check(rig, "", 3);
  EXPECT_EQ(check.largest_N(), 1.0) << "the file may be that of another arm";
  check.options.felt = check.kept;
  EXPECT_EQ(check.largest_N(), 5.0);
  check.options.felt->device = "woodenhaptics-16c0-0486";
  EXPECT_EQ(check.largest_N(), 1.0);
}

TEST(WoodenHaptics, IsProvenByPushesAlongAllOfItsAxes)
{
  const WoodenHapticsRig rig;
  EXPECT_EQ(KeptCheck(rig, "7", 2).largest_N(), 1.0);
  EXPECT_EQ(KeptCheck(rig, "7", 3).largest_N(), 5.0);
}

TEST(WoodenHaptics, WithoutItsOwnersFileSaysSoWhereItIsListedAndWhenItIsOpened)
{
  const WoodenHapticsRig rig;
  DeviceOptions options;
  options.hid = rig.bus;
  options.arms = std::make_shared<const std::vector<ArmKit>>(
    std::vector<ArmKit>{ woodenHapticsKit(rig.bus, rig.folder.file("none.json")) });
  EXPECT_THAT(knownDevices(options).back().problem, testing::HasSubstr("none.json: it is missing"));
  const MadeDevice made = makeDevice("woodenhaptics-1234-0006-7", options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_THAT(made.device->open(), testing::HasSubstr("none.json: it is missing"));
}

TEST(WoodenHaptics, OfWhichTwoCannotBeToldApartKeepsItsLimit)
{
  WoodenHapticsRig rig;
  rig.bus->plug(std::make_shared<test::WoodenHapticsModel>(), WoodenHapticsRig::plugOf());
  DeviceOptions options;
  options.hid = rig.bus;
  options.arms = std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ rig.kit });
  options.calibrationFolder = rig.folder.path();
  int twins = 0;
  for (const KnownDevice& known : knownDevices(options))
  {
    if (!known.name.starts_with("woodenhaptics"))
    {
      continue;
    }
    ++twins;
    EXPECT_TRUE(known.hasTwin) << known.name;
    const Calibration kept = checkOf(known.name, "7", 3);
    ASSERT_EQ(saveCalibration(options.calibrationFolder, kept), "");
    for (const bool feltNow : { false, true })
    {
      options.felt = feltNow ? std::optional(kept) : std::nullopt;
      const MadeDevice made = makeDevice(known.name, options);
      ASSERT_NE(made.device, nullptr) << made.problem;
      EXPECT_EQ(made.device->info().maxForce_N.value, 1.0) << "the check may be that of the other arm";
      EXPECT_EQ(made.warning, twinNote);
    }
  }
  EXPECT_EQ(twins, 2);
}

TEST(WoodenHaptics, IsRefusedToASecondProgramUntilTheFirstHasEnded)
{
  WoodenHapticsRig rig;
  HidEntry& plug = rig.port.entry;
  plug.path = rig.folder.file("hidraw7"); // stands in for the device's file
  std::ofstream(plug.path).flush();
  const ArmSetup& setup = rig.kit.setup;
  ArmDevice first("first", rig.kit.bus, plug, setup, { false, &rig.bus->time() });
  ArmDevice second("second", rig.kit.bus, plug, setup, { false, &rig.bus->time() });
  ASSERT_EQ(first.open(), "");
  EXPECT_THAT(second.open(), testing::HasSubstr(plug.path + " is busy: close the other program that uses it"));
  EXPECT_EQ(rig.port.opened, 1);
  first.close();
  EXPECT_EQ(second.open(), "");
  EXPECT_THAT(first.open(), testing::HasSubstr("is busy"));
  rig.port.present = false; // until it is plugged in again
  static_cast<void>(second.link().pass());
  rig.port.present = true;
  EXPECT_EQ(first.open(), "") << "a device that was lost is free";
}

TEST(WoodenHapticsFile, SaysWhatIsWrongWithIt)
{
  const std::string good = test::WoodenHapticsModel::file();
  EXPECT_EQ(readWoodenHapticsFile(good).problem, "");
  const auto with = [&good](const std::string& what, const std::string& by)
  {
    std::string changed = good;
    changed.replace(changed.find(what), what.size(), by);
    return readWoodenHapticsFile(changed).problem;
  };
  const std::string unknownVariant = "variant: the kinematics of this variant are not known: those of 0, 1 and 2 are";
  EXPECT_EQ(with("\"length_body_b\"", "\"length_body_x\""), "length_body_b: this key is missing");
  EXPECT_EQ(with("\"cpr_encoder_a\": 2000", "\"cpr_encoder_a\": \"no\""), "cpr_encoder_a: must be a finite number");
  EXPECT_EQ(with("\"variant\": 0", "\"variant\": 3"), unknownVariant);
  EXPECT_EQ(with("\"variant\": 0", "\"variant\": 1.5"), unknownVariant);
  EXPECT_EQ(with("enc_c\": 6000", "enc_c\": 32767"), "");
  for (const char* const count : { "32768", "-32768", "1e300", "6000.5" })
  {
    EXPECT_EQ(with("enc_c\": 6000", std::string("enc_c\": ") + count),
      "calibrate_enc_c: must be a whole number from -32767 to 32767")
      << count;
  }
  EXPECT_EQ(with("motor_a\": 0.0259", "motor_a\": 0"), "joint 1: its torque constant must be above 0");
  EXPECT_EQ(with("aligned_b\": false", "aligned_b\": \"no\""), "motor_and_body_aligned_b: must be true or false");
  EXPECT_EQ(with("aligned_b\": false", "aligned_b\": 0"), "");
  EXPECT_EQ(readWoodenHapticsFile("{").problem, "not JSON: byte 2 is unexpected");
  EXPECT_EQ(readWoodenHapticsFile("7").problem, "must be an object, { ... }");
  EXPECT_EQ(readWoodenHapticsFile(std::string(100000, '[')).problem, "it has more than 64 KiB");
}

} // namespace
} // namespace palpate
