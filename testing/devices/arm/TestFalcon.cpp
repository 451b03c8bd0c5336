// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain of a Novint Falcon, against a model of its chip, loader, firmware and mechanics.
#include <fstream>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/devices/arm/FalconRig.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

using test::FalconRig;

/// The largest displacement of the tip for one count: 0.036 degrees of an arm of 60 mm, and the farthest that legs
/// stretch it.
constexpr double falconCount_m = 2e-4;

constexpr double largestOff_rad = 2e-7; ///< the library that the table was printed by computes in floats

std::vector<std::uint8_t> writeFirmware(const std::string& file)
{
  std::vector<std::uint8_t> bytes(1000);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{ 3 });
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), 1000);
  return bytes;
}

TEST(FalconModel, HasTheAnglesOfTheTableOfFacts)
{
  const auto expect = [](const Vec3& tip_m, const Vec3& angles)
  { EXPECT_LT((test::FalconModel::anglesAt(tip_m) - angles).norm(), largestOff_rad) << tip_m.transpose(); };
  expect({ 0.0, 0.0, 0.12 }, { 0.417448223, 0.417448223, 0.417448223 });
  expect({ 0.03, 0.0, 0.12 }, { 0.587671638, 0.140990555, 0.702454150 });
  expect({ -0.02, 0.025, 0.10 }, { -0.193459839, 0.546293020, 0.300572366 });
  expect({ 0.01, -0.03, 0.15 }, { 1.159459472, 0.747636735, 0.763572991 });
}

TEST(Falcon, IsUsedAtOnceWhereItsFirmwareRunsAndGivesNoForceBeforeAllItsMotorsAreHomed)
{
  FalconRig falcon;
  ASSERT_EQ(falcon.rig.device.open(), "");
  for (std::size_t homed = 0; homed < 3; ++homed)
  {
    ask(falcon.rig, { 0.0, 0.0, 2.0 });
    EXPECT_EQ(falcon.rig.status, DeviceStatus::Waiting) << "places mean nothing";
    EXPECT_EQ(falcon.model->motor, (std::array<int, 3>{ 0, 0, 0 })) << homed;
    EXPECT_TRUE(falcon.model->homing);
    ASSERT_TRUE(falcon.rig.device.step());
    EXPECT_THAT(falcon.rig.device.step()->sentence, testing::HasSubstr("then push it in"));
    EXPECT_EQ(falcon.rig.device.step()->button, "") << "it says by itself when it is homed";
    falcon.model->homed[homed] = true;
  }
  ask(falcon.rig, { 0.0, 0.0, 2.0 });
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Ok);
  EXPECT_FALSE(falcon.rig.device.step());
  EXPECT_NEAR(falcon.model->force_N().z(), 2.0, falcon.model->step_N() + 0.02);
  falcon.model->homed[1] = false;
  falcon.rig.run(3);
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Waiting);
  EXPECT_EQ(falcon.model->force_N().norm(), 0.0) << "a motor that forgets its zero";
  EXPECT_EQ(falcon.rig.lostTicks, 1) << "the session ends the force";
  EXPECT_EQ(falcon.rig.device.linkReport().endedFor, "the arm no longer knows its position");
  falcon.model->homed[1] = true;
  falcon.rig.run(50);
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Ok);
  EXPECT_EQ(falcon.model->force_N().norm(), 0.0) << "only a person brings the force back";
  ask(falcon.rig, { 0.0, 0.0, 2.0 });
  EXPECT_NEAR(falcon.model->force_N().z(), 2.0, falcon.model->step_N() + 0.02);
}

TEST(Falcon, IsRefusedWhereNoGuardCanHoldItsLink)
{
  FalconRig falcon;
  falcon.loader->canBeHeld = false;
  EXPECT_THAT(falcon.rig.device.open(), testing::HasSubstr("without it this device gives no force"));
  falcon.home();
  ask(falcon.rig, { 0.0, 0.0, 2.0 });
  EXPECT_NE(falcon.rig.status, DeviceStatus::Ok);
  EXPECT_EQ(falcon.model->motor, (std::array<int, 3>{ 0, 0, 0 }));
}

TEST(Falcon, WhoseFirmwareWasLoadedHasNoHandWithoutAGuard)
{
  const test::TemporaryFolder folder;
  FalconRig falcon;
  falcon.loader->runs = false;
  falcon.loader->canBeHeld = false;
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.rig.run(5);
  const std::string file = folder.file("firmware.bin");
  writeFirmware(file);
  falcon.rig.device.stepDone(file);
  falcon.rig.run(500);
  falcon.home();
  ask(falcon.rig, { 0.0, 0.0, 2.0 });
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Waiting);
  ASSERT_TRUE(falcon.rig.device.step());
  const DeviceStep step = *falcon.rig.device.step();
  EXPECT_THAT(step.sentence, testing::HasSubstr("without it this device gives no force"));
  EXPECT_THAT(step.sentence, testing::Not(testing::HasSubstr("firmware"))) << "it was loaded";
  EXPECT_FALSE(step.wantsFile);
  EXPECT_EQ(step.button, "");
  EXPECT_EQ(falcon.model->motor, (std::array<int, 3>{ 0, 0, 0 }));
}

// A chip that has nothing says so every 16 ms; each of 100 greetings is waited for 20 ms, and for the look that ends
// them.
TEST(Falcon, WaitsForAMuteLoaderAsLongAsItsGreetingsTake)
{
  FalconRig falcon;
  falcon.loader->runs = false;
  falcon.loader->greets = false;
  const test::TemporaryFolder folder;
  writeFirmware(folder.file("firmware.bin"));
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.rig.run(10);
  falcon.rig.device.stepDone(folder.file("firmware.bin"));
  const std::int64_t from_ns = falcon.time.now_ns();
  falcon.rig.run(50);
  const double took_ms = static_cast<double>(falcon.time.now_ns() - from_ns) / perMs_ns;
  EXPECT_GE(took_ms, 100 * 20.0);
  EXPECT_LE(took_ms, 100 * (20.0 + 16.0) + 100.0);
}

// Each look at a chip that has nothing takes a millisecond.
TEST(Falcon, IsAskedForNothingBesideItsAnswersButAfterOneThatIsMissing)
{
  FalconRig falcon;
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.home();
  const auto passes = [&falcon](int count)
  {
    const int before = falcon.loader->emptyReads;
    for (int i = 0; i < count; ++i)
    {
      falcon.rig.tick();
      falcon.rig.pass();
    }
    return falcon.loader->emptyReads - before;
  };
  EXPECT_EQ(passes(100), 0);
  falcon.model->silentFor = 1;
  const int waited = passes(1);
  EXPECT_GT(waited, 0) << "for the answer";
  EXPECT_EQ(passes(1), 1) << "it may still come";
  EXPECT_EQ(passes(100), 0);
}

TEST(Falcon, AppliesTheForceThatIsAskedToAStepOfItsNumbersInItsWorkSpace)
{
  FalconRig falcon;
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.home();
  ask(falcon.rig, Vec3::Zero());
  test::Random random(7);
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 from_m = 0.035 * random.direction();
    const Vec3 at_m = from_m + Vec3(0.0, 0.0, 0.125);
    falcon.model->place(test::FalconModel::anglesAt(at_m));
    falcon.rig.command.wrench_D.force = random.direction();
    falcon.rig.run(4);
    ASSERT_EQ(falcon.rig.status, DeviceStatus::Ok);
    EXPECT_LT((falcon.rig.sample.pose_D.p - from_m).norm(), falconCount_m) << "from the middle of its work space";
    // The Jacobian is that of the counted place: a count turns a force by less than 1 in 100.
    EXPECT_LT((falcon.model->force_N() - falcon.rig.command.wrench_D.force).norm(), falcon.model->step_N() + 0.01)
      << at_m.transpose();
  }
}

TEST(Falcon, IsLoadedFromTheFileThatAPersonChooses)
{
  FalconRig falcon;
  falcon.loader->runs = false;
  const test::TemporaryFolder folder;
  const std::string file = folder.file("firmware.bin");
  const std::vector<std::uint8_t> bytes = writeFirmware(file);
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.rig.run(20);
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Waiting);
  std::optional<DeviceStep> step = falcon.rig.device.step();
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->wantsFile);
  EXPECT_EQ(falcon.rig.device.linkReport().message, step->sentence);
  falcon.rig.device.stepDone(file);
  falcon.rig.run(50);
  EXPECT_EQ(falcon.loader->loaded, bytes);
  ASSERT_FALSE(falcon.loader->pieces.empty());
  EXPECT_EQ(falcon.loader->pieces.front(), 62U);
  EXPECT_EQ(falcon.loader->pieces.back(), 1000U % 62U);
  falcon.home();
  ask(falcon.rig, { 0.0, 1.0, 0.0 });
  EXPECT_EQ(falcon.rig.status, DeviceStatus::Ok);
  EXPECT_NEAR(falcon.model->force_N().y(), 1.0, falcon.model->step_N() + 0.01);
}

TEST(Falcon, IsLostWhenItIsUnpluggedBeforeItHasItsFirmwareAndWhileItIsLoaded)
{
  for (const bool loads : { false, true })
  {
    FalconRig falcon;
    falcon.loader->runs = false;
    const test::TemporaryFolder folder;
    writeFirmware(folder.file("firmware.bin"));
    ASSERT_EQ(falcon.rig.device.open(), "");
    falcon.rig.run(20);
    ASSERT_TRUE(falcon.rig.device.step());
    falcon.model->present = false;
    if (loads)
    {
      falcon.rig.device.stepDone(folder.file("firmware.bin"));
    }
    falcon.rig.run(20);
    EXPECT_EQ(falcon.rig.status, DeviceStatus::Lost) << loads;
    EXPECT_EQ(falcon.rig.device.linkReport().lostFor, "the cable was unplugged");
    EXPECT_FALSE(falcon.rig.device.step()) << "nothing can be done with what is not there";
  }
}

TEST(Falcon, SetsItsChipAsItsLoaderAndItsPacketsWant)
{
  FalconRig falcon;
  falcon.loader->runs = false;
  const test::TemporaryFolder folder;
  writeFirmware(folder.file("firmware.bin"));
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.loader->controls.clear();
  falcon.rig.device.stepDone(folder.file("firmware.bin"));
  falcon.rig.run(50);
  using Controls = std::vector<std::pair<int, int>>;
  const Controls expected{ { 9, 16 }, { 3, 0x4138 }, { 4, 8 }, { 2, 0 }, { 1, 0x0200 }, { 1, 0x0100 }, { 1, 0x0101 },
    { 0, 1 }, { 1, 0x0100 }, { 3, 0x15 }, { 9, 1 }, { 3, 2 }, { 0, 1 }, { 0, 2 } };
  EXPECT_EQ(falcon.loader->controls, expected);
}

/// Wrong firmware and wrong loaders, and their messages.
struct WrongLoad
{
  const char* name;
  void (*happen)(FalconRig& falcon);
  const char* says;
};

class FalconLoads : public testing::TestWithParam<WrongLoad>
{
};

TEST_P(FalconLoads, AreToldAndCanBeTriedAgain)
{
  FalconRig falcon;
  falcon.loader->runs = false;
  const test::TemporaryFolder folder;
  writeFirmware(folder.file("firmware.bin"));
  ASSERT_EQ(falcon.rig.device.open(), "");
  GetParam().happen(falcon);
  falcon.rig.device.stepDone(folder.file("firmware.bin"));
  falcon.rig.run(50);
  const std::optional<DeviceStep> step = falcon.rig.device.step();
  ASSERT_TRUE(step);
  EXPECT_THAT(step->sentence, testing::HasSubstr("firmware.bin was not loaded: "));
  EXPECT_THAT(step->sentence, testing::HasSubstr(GetParam().says));
  EXPECT_TRUE(step->wantsFile);
}

INSTANTIATE_TEST_SUITE_P(Each, FalconLoads,
  testing::Values(WrongLoad{ "Mute", [](FalconRig& falcon) { falcon.loader->greets = false; }, "does not greet" },
    WrongLoad{ "WrongEcho", [](FalconRig& falcon) { falcon.loader->wrongEchoAt = 200; },
      "echoed other bytes than those of the file at byte 186" },
    WrongLoad{ "NotItsFirmware", [](FalconRig& falcon) { falcon.loader->takesAnything = false; },
      "the file is not its firmware" }),
  [](const auto& one) { return one.param.name; });

TEST(Falcon, TakesNoFileThatIsNoFirmware)
{
  FalconRig falcon;
  falcon.loader->runs = false;
  const test::TemporaryFolder folder;
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.rig.device.stepDone(folder.file("none"));
  falcon.rig.run(10);
  EXPECT_THAT(falcon.rig.device.step()->sentence, testing::HasSubstr("none was not loaded: it cannot be read"));
  std::ofstream(folder.file("empty")).flush();
  falcon.rig.device.stepDone(folder.file("empty"));
  falcon.rig.run(10);
  EXPECT_THAT(falcon.rig.device.step()->sentence, testing::HasSubstr("its size is not that of a firmware"));
  EXPECT_TRUE(falcon.loader->loaded.empty());
}

} // namespace
} // namespace palpate
