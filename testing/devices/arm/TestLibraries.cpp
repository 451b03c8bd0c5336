// SPDX-License-Identifier: GPL-3.0-or-later
// Arms behind a vendor's library, against libraries that are made up.
#include <cerrno>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/FakeSys.h"
#include "testing/devices/arm/LibraryRig.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Eventually.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

TEST(ForceDimension, IsAbsentWithoutHarmAndWhatItMissesIsNamed)
{
  const std::vector<ArmKit> none{ forceDimensionKit("libnone.so.9"), openHapticsKit("libnone.so.9") };
  for (const ArmKit& kit : none)
  {
    EXPECT_TRUE(kit.bus->devices().empty());
    EXPECT_THAT(kit.bus->open({}).problem, testing::HasSubstr("libnone.so.9 cannot be loaded"));
  }
  const std::vector<ArmKit> old{ forceDimensionKit(PALPATE_FAKE_OLD_DHD) };
  EXPECT_THAT(
    old[0].bus->open({}).problem, testing::HasSubstr("has no function dhdSetWatchdog: install a newer version"));
}

TEST(ForceDimension, ExchangesForceForPlaceTurnVelocityAndButtonsAndSetsTheWatchdogFirst)
{
  test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 1.0, -2.0, 3.0 }, 5);
  rig.command.wrench_D.torque = { 0.1, 0.2, 0.3 };
  rig.run(2);
  const auto force = test::fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce");
  EXPECT_EQ(Vec3(force(0), force(1), force(2)), Vec3(1.0, -2.0, 3.0));
  EXPECT_EQ(Vec3(force(3), force(4), force(5)), Vec3(Vec3::Zero())) << "it renders no torque";
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeWatchdog")(), 20);
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeUnwatched")(), 0) << "the watchdog comes first";
  EXPECT_EQ(rig.sample.pose_D.p, Vec3(0.01, 0.02, -0.03));
  EXPECT_LT((rig.sample.pose_D.q * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(rig.sample.velocity_D.linear.x(), 0.1);
  EXPECT_EQ(rig.sample.buttons, 3U);
  rig.device.close();
  EXPECT_EQ(force(2), 0.0);
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeOpened")(), 0);
}

TEST(ForceDimension, ThatReportsAnErrorIsLostWithItsText)
{
  test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 1.0, 0.0, 0.0 }, 5);
  const auto fail = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeFail");
  fail(1);
  rig.run(2);
  EXPECT_GE(rig.lostTicks, 1);
  EXPECT_EQ(rig.device.linkReport().lostFor, "the vendor's library reports an error: made-up failure");
  EXPECT_EQ(test::fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce")(0), 0.0);
  EXPECT_THAT(rig.kit.bus->open(rig.found[0].entry).problem, testing::HasSubstr("made-up failure"));
  fail(0);
}

/// Calls of the vendor's library that fail, by the fake library's numbers.
enum Call
{
  None = 0,
  Watchdog = 1,
  Enable = 2,
  Push = 3,
  Velocity = 4,
};

TEST(ForceDimension, WhoseWatchdogOrForceCannotBeSwitchedOnIsNotOpened)
{
  const auto failAt = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeFailAt");
  for (const Call call : { Watchdog, Enable })
  {
    test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
    failAt(call);
    EXPECT_THAT(rig.device.open(), testing::EndsWith("the vendor's library reports an error: made-up failure"));
    EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeEnabled")(), 0) << call;
    EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeOpened")(), 0) << call;
    EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_DHD, "fakeUnwatched")(), 0) << call;
    failAt(None);
  }
}

TEST(ForceDimension, WhoseForceOrVelocityFailsIsLostWithoutForce)
{
  const auto failAt = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeFailAt");
  const auto force = test::fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce");
  for (const Call call : { Push, Velocity })
  {
    test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 1.0, 0.0, 0.0 }, 5);
    ASSERT_EQ(force(0), 1.0);
    failAt(call);
    rig.run(2);
    EXPECT_GE(rig.lostTicks, 1) << call;
    EXPECT_EQ(rig.device.linkReport().lostFor, "the vendor's library reports an error: made-up failure") << call;
    EXPECT_EQ(force(0), 0.0) << call;
    failAt(None);
  }
}

TEST(ForceDimension, WhoseErrorHasNoTextIsRefusedAllTheSame)
{
  const auto fail = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeFail");
  const auto silent = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeSilent");
  test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
  fail(1);
  silent(1);
  EXPECT_THAT(rig.device.open(), testing::EndsWith("does not open the device: no reason is given"));
  silent(0);
  fail(0);
}

int denied(const char* /*path*/, int /*mode*/)
{
  errno = EACCES;
  return -1;
}

int granted(const char* /*path*/, int /*mode*/)
{
  return 0;
}

/// The last device that a computer with that kit alone lists.
KnownDevice listedBy(const ArmKit& kit)
{
  DeviceOptions options;
  options.hid = std::make_shared<test::FakeHidBus>();
  options.arms = std::make_shared<const std::vector<ArmKit>>(1, kit);
  return knownDevices(options).back();
}

TEST(VendorsLibraries, ThatAreMissingAreToldOfWhereAnArmOfTheirsIsPluggedIn)
{
  const test::FakeSys sys;
  sys.plugUsb("1451", "0402", 7);
  sys.plugUsb("0301", "2988", 8);
  const KnownDevice dhd = listedBy(forceDimensionKit("libnone.so.9", sys.path(), granted));
  EXPECT_EQ(dhd.name, "dhd-1451-0402");
  EXPECT_THAT(dhd.problem, testing::HasSubstr("libnone.so.9 cannot be loaded: install the vendor's software"));
  const KnownDevice hd = listedBy(openHapticsKit("libnone.so.9", sys.path()));
  EXPECT_EQ(hd.name, "openhaptics-0301-2988");
  EXPECT_THAT(hd.problem, testing::HasSubstr("libnone.so.9 cannot be loaded: install the vendor's software"));
}

TEST(ForceDimension, ThatItsLibraryDoesNotSeeIsListedWithTheReason)
{
  const test::FakeSys sys;
  sys.plugUsb("1451", "0402", 7);
  const auto count = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeCount");
  for (const int seen : { 0, -1 })
  {
    count(seen);
    const ArmKit unseen = forceDimensionKit(PALPATE_FAKE_DHD, sys.path(), granted);
    EXPECT_EQ(listedBy(unseen).name, "dhd-1451-0402") << seen;
    EXPECT_THAT(listedBy(unseen).problem, testing::HasSubstr("the vendor's library does not see the device")) << seen;
    EXPECT_THAT(unseen.bus->open(unseen.bus->devices().at(0)).problem, testing::HasSubstr("does not see")) << seen;
    const KnownDevice locked = listedBy(forceDimensionKit(PALPATE_FAKE_DHD, sys.path(), denied));
    EXPECT_THAT(locked.problem, testing::HasSubstr("no permission to use /dev/bus/usb/001/007")) << seen;
  }
  count(1);
  const KnownDevice seen = listedBy(forceDimensionKit(PALPATE_FAKE_DHD, sys.path(), denied));
  EXPECT_EQ(seen.problem, "") << "the library has its own ways to an arm";
}

/// A device with its own threads, and a servo that asks it for a force, but for none now and then: so a force comes
/// back after a loss.
class AskingServo
{
public:
  AskingServo(const test::LibraryRig& rig, const Vec3& force_N)
    : device("arm", rig.kit.bus, rig.found[0].entry, rig.kit.setup), force_N_(force_N)
  {
    this->device.prove();
  }
  /// Goes on asking until that holds.
  template<class Condition>
  [[nodiscard]] bool until(Condition condition)
  {
    return test::eventually(
      [&]
      {
        DeviceCommand command;
        command.wrench_D.force = ++this->ticks_ % 16 == 0 ? Vec3(Vec3::Zero()) : this->force_N_;
        this->status_ = this->device.read(1e-3 * this->ticks_, this->sample_);
        this->device.write(command);
        return condition();
      });
  }
  [[nodiscard]] bool isStatus(DeviceStatus status)
  {
    return this->until([&] { return this->status_ == status; });
  }

  ArmDevice device;

private:
  Vec3 force_N_;
  DeviceSample sample_;
  DeviceStatus status_ = DeviceStatus::Waiting;
  int ticks_ = 0;
};

TEST(ForceDimension, WhoseCallBlocksLosesTheDeviceForTheServoWithoutWaiting)
{
  const test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
  const auto hold = test::fakeFunction<void(int)>(PALPATE_FAKE_DHD, "fakeHold");
  AskingServo servo(rig, Vec3::Zero());
  ASSERT_EQ(servo.device.open(), "");
  EXPECT_TRUE(servo.isStatus(DeviceStatus::Ok));
  hold(1);
  EXPECT_TRUE(servo.isStatus(DeviceStatus::Lost)) << "although the call does not return before it is let go";
  EXPECT_TRUE(test::eventually([&] { return servo.device.linkReport().message == "the link to the device hangs"; }));
  hold(0);
  EXPECT_TRUE(servo.isStatus(DeviceStatus::Ok)) << "the servo latches the fault, not the device";
  servo.device.close();
}

/// A force is asked for until the vendor's library has had it: on a busy machine its calls come too late at times.
bool pushesOnce(test::LibraryRig& rig, const Vec3& force_N)
{
  const auto push = test::fakeFunction<double(int)>(PALPATE_FAKE_HD, "fakeLastPush");
  return test::eventually(
    [&]
    {
      ask(rig, force_N, 5);
      return Vec3(push(0), push(1), push(2)) == force_N;
    });
}

class OpenHapticsRates : public testing::TestWithParam<int>
{
};

TEST_P(OpenHapticsRates, ExchangesInTheVendorsCallsAtTheirRate)
{
  const auto rate = test::fakeFunction<void(int)>(PALPATE_FAKE_HD, "fakeRate");
  rate(GetParam());
  test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
  EXPECT_EQ(rig.device.info().pacing, Pacing::Callback);
  ASSERT_EQ(rig.device.open(), "");
  const Vec3 force_N(1.0, -2.0, 1e-4 * GetParam());
  EXPECT_TRUE(pushesOnce(rig, force_N));
  EXPECT_LT((rig.sample.pose_D.p - Vec3(0.01, 0.02, -0.03)).norm(), 1e-15);
  EXPECT_LT((rig.sample.pose_D.q * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(rig.sample.velocity_D.linear.x(), 0.1, 1e-15);
  EXPECT_EQ(rig.sample.buttons, 2U);
  const auto calls = test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeCalls");
  const int before = calls();
  const std::uint64_t answers = rig.device.link().answers() + 20;
  EXPECT_TRUE(test::eventually(
    [&]
    {
      rig.run(1);
      return rig.device.link().answers() >= answers;
    }));
  EXPECT_GE(calls() - before, 19) << "each answer waits for a call, of which the last may not be counted yet";
  rig.device.close();
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeOutput")(), 0);
  rate(1000);
}

INSTANTIATE_TEST_SUITE_P(Each, OpenHapticsRates, testing::Values(500, 1000, 4000));

TEST(OpenHaptics, ThatMissesAFunctionIsNotOpenedAndTheFunctionIsNamed)
{
  DeviceOptions options;
  options.hid = std::make_shared<test::FakeHidBus>();
  options.arms =
    std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ openHapticsKit(PALPATE_FAKE_OLD_HD) });
  const std::string missing = "has no function hdUnschedule: install a newer version";
  const KnownDevice listed = knownDevices(options).back();
  EXPECT_EQ(listed.name, "openhaptics-0301-2988");
  EXPECT_THAT(listed.problem, testing::HasSubstr(missing));
  const MadeDevice made = makeDevice(listed.name, options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_THAT(made.device->open(), testing::HasSubstr(missing));
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_OLD_HD, "fakeOpened")(), 0);
}

TEST(OpenHaptics, WithoutALicenceIsNotOpenedAndSaysSo)
{
  const auto fail = test::fakeFunction<void(std::uint32_t)>(PALPATE_FAKE_HD, "fakeFail");
  test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
  fail(0x0600);
  EXPECT_THAT(rig.device.open(), testing::EndsWith("does not open the device: there is no licence"));
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeOpened")(), 0) << "it is given back";
  fail(0);
  EXPECT_EQ(test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeOutput")(), 0);
}

TEST(OpenHaptics, WhoseCallBlocksLosesTheDeviceForTheServoWithoutWaitingAndPushesNoMoreWhenItGoesOn)
{
  const auto hold = test::fakeFunction<void(int)>(PALPATE_FAKE_HD, "fakeHold");
  const auto isHeld = test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeIsHeld");
  const auto pushes = test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakePushes");
  const test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
  AskingServo servo(rig, { 0.0, 0.0, 1.0 });
  ASSERT_EQ(servo.device.open(), "");
  const int first = pushes();
  ASSERT_TRUE(servo.until([&] { return pushes() > first; }));
  hold(1);
  ASSERT_TRUE(servo.until([&] { return isHeld() != 0; }));
  const int before = pushes();
  EXPECT_TRUE(servo.isStatus(DeviceStatus::Lost)) << "although the call does not return before it is let go";
  const auto why = [&] { return servo.device.linkReport().lostFor; };
  EXPECT_TRUE(servo.until([&] { return !why().empty(); }));
  EXPECT_EQ(why(), "the vendor's scheduler does not call back");
  hold(0);
  EXPECT_TRUE(test::eventually([&] { return servo.device.linkReport().attached; })) << "it is found again";
  EXPECT_EQ(pushes(), before) << "the order of before is not given any more";
  EXPECT_TRUE(servo.isStatus(DeviceStatus::Ok));
  servo.device.close();
}

TEST(OpenHaptics, EndsAForceThatNobodyAsksForAgainAlthoughTheVendorsSchedulerGoesOn)
{
  test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_TRUE(pushesOnce(rig, { 0.0, 0.0, 2.5 }));
  const auto force = test::fakeFunction<double(int)>(PALPATE_FAKE_HD, "fakeForce");
  const auto calls = test::fakeFunction<int()>(PALPATE_FAKE_HD, "fakeCalls");
  const int before = calls();
  EXPECT_TRUE(test::eventually([&] { return force(2) == 0.0; })) << "the exchange hangs";
  EXPECT_TRUE(test::eventually([&] { return calls() > before; }));
}

TEST(OpenHaptics, IsNobodysFirstChoiceWithoutAPlug)
{
  const test::TemporaryFolder sys;
  DeviceOptions options;
  options.hid = std::make_shared<test::FakeHidBus>();
  options.arms = std::make_shared<const std::vector<ArmKit>>(
    std::vector<ArmKit>{ openHapticsKit(PALPATE_FAKE_HD, sys.path().string()) });
  EXPECT_EQ(knownDevices(options).back().name, "openhaptics-0301-2988") << "it may be on Ethernet";
  EXPECT_EQ(preferredDevice(knownDevices(options)), "mouse");
  const std::filesystem::path plug = sys.path() / "bus/usb/devices/1-1";
  std::filesystem::create_directories(plug);
  std::ofstream(plug / "idVendor") << "0301\n";
  std::ofstream(plug / "idProduct") << "2988\n";
  EXPECT_EQ(preferredDevice(knownDevices(options)), "openhaptics-0301-2988");
}

TEST(OpenHaptics, WhoseSchedulerStopsOrReportsAnErrorIsLost)
{
  const auto rate = test::fakeFunction<void(int)>(PALPATE_FAKE_HD, "fakeRate");
  const auto fail = test::fakeFunction<void(std::uint32_t)>(PALPATE_FAKE_HD, "fakeFail");
  {
    test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 1.0, 0.0, 0.0 }, 5);
    rate(0);
    rig.run(6);
    EXPECT_GE(rig.lostTicks, 1);
    EXPECT_EQ(rig.device.linkReport().lostFor, "the vendor's scheduler does not call back");
    rate(1000);
  }
  test::LibraryRig rig(openHapticsKit(PALPATE_FAKE_HD));
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 1.0, 0.0, 0.0 }, 5);
  fail(0x0201);
  rig.run(5);
  EXPECT_THAT(rig.device.linkReport().lostFor, testing::Not(testing::HasSubstr("the force was beyond the largest")));
  fail(0x0302);
  EXPECT_TRUE(test::eventually(
    [&]
    {
      rig.run(5);
      return rig.device.linkReport().lostFor == "the vendor's library reports: the link to the device is lost";
    }));
  EXPECT_GE(rig.lostTicks, 1);
  fail(0);
}

} // namespace
} // namespace palpate
