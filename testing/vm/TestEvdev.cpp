// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's own force feedback: its evdev, its uinput and its driver of Logitech's wheels are the real ones. Runs in
// a virtual machine of its own (README.md); times are those of the devices' clocks.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "devices/evdev/EvdevDiscovery.h"
#include "devices/hid/HidapiBus.h"
#include "testing/vm/EventServo.h"
#include "testing/vm/LogitechWheel.h"
#include "testing/vm/OtherProgram.h"
#include "testing/vm/Pushing.h"
#include "testing/vm/UinputStick.h"

namespace palpate
{
namespace
{

using test::EventServo;
using test::OtherProgram;
using test::UinputStick;
using test::UsbWheel;
using test::VirtualDriver;
using test::waitUntil;

constexpr std::uint16_t logitech = 0x046D, g29 = 0xC24F;

TEST(Evdev, AStickThatAProgramMadeUpIsFoundWithAllThatItsDriverOffers)
{
  UinputStick stick(0x0101);
  const std::shared_ptr<EvdevBus> bus = systemEvdevBus();
  static_cast<void>(test::waitForEventDevice(*bus, UinputStick::vendor, 0x0101));
  const std::vector<FoundEvdev> found = findEvdevDevices(*bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "evdev-1209-0101");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].entry.name, "Palpate test stick");
  EXPECT_EQ(found[0].kind.pushes.deviceClass, DeviceClass::Joystick2D);
  EXPECT_TRUE(promised(found[0].kind.pushes).offersWalls());
  EXPECT_EQ(found[0].kind.buttons.size(), 3u);
}

TEST(Evdev, EachAxisIsPushedTheWayAndAsHardAsTheCommandSays)
{
  UinputStick stick(0x0102);
  EventServo servo(UinputStick::vendor, 0x0102);
  ASSERT_EQ(servo.device.open(), "");
  EXPECT_EQ(stick.alone([](VirtualDriver& driver) { return driver.gain; }), 0xFFFF);
  EXPECT_EQ(stick.alone([](VirtualDriver& driver) { return driver.autocentre; }), 0);
  const double most_N = servo.options.output.scale.maxForce_N;
  for (const Vec3& force : { Vec3(1.0, 0.0, 0.0), Vec3(-2.0, 0.0, 0.0), Vec3(0.0, 1.5, 0.0), Vec3(0.0, -2.5, 0.0),
         Vec3(-0.5, 0.7, 0.0), Vec3(0.0, 0.0, 0.0) })
  {
    servo.command.wrench_D.force = force;
    // The axis y of an event device points towards the person.
    const auto reached = [&]
    {
      const VirtualDriver::Axes now = stick.force();
      return std::fabs(now[0] - force.x() / most_N) <= VirtualDriver::rounding &&
             std::fabs(now[1] + force.y() / most_N) <= VirtualDriver::rounding;
    };
    EXPECT_TRUE(servo.runUntil(reached)) << force.transpose();
  }
}

TEST(Evdev, AForceGoesOnWhileItIsGivenAndIsNothingAfterClosing)
{
  UinputStick stick(0x0103);
  EventServo servo(UinputStick::vendor, 0x0103);
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return stick.force()[0] > 0.3; }));
  const std::int64_t from_ms = stick.time_ms();
  EXPECT_TRUE(servo.runUntil([&] { return stick.time_ms() > from_ms + 1000; }, 30000));
  EXPECT_NEAR(stick.force()[0], 0.4, VirtualDriver::rounding);
  EXPECT_GT(servo.device.linkReport().restarts, 8u);
  servo.device.close();
  EXPECT_EQ(stick.force()[0], 0.0);
  EXPECT_EQ(stick.alone([](VirtualDriver& driver) { return driver.held(); }), 0);
}

TEST(Evdev, WithoutCommandsTheForceEndsAndWithThemItComesBack)
{
  UinputStick stick(0x0104);
  EventServo servo(UinputStick::vendor, 0x0104);
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return stick.force()[0] > 0.3; }));
  EXPECT_TRUE(waitUntil([&] { return stick.playing() == 0; }));
  EXPECT_TRUE(servo.runUntil([&] { return stick.force()[0] > 0.3; }));
}

TEST(Evdev, WallsThatTheDriverHoldsStopTheHand)
{
  UinputStick stick(0x0105);
  EventServo servo(UinputStick::vendor, 0x0105);
  ASSERT_EQ(servo.device.open(), "");
  const PidScale& scale = servo.options.output.scale;
  servo.command.wallCount = 2;
  servo.command.walls[0] = { Vec3::UnitX(), -0.3 * scale.halfTravel_m, scale.springStiffness_N_per_m };
  servo.command.walls[1] = { -Vec3::UnitX(), -0.5 * scale.halfTravel_m, scale.springStiffness_N_per_m };
  servo.run(servo.options.output.rampUp_ms + 200);
  const double inside = 0.4 / VirtualDriver::springGain;
  for (const double push : { 0.4, -0.4 })
  {
    stick.alone([&](VirtualDriver& driver) { driver.push = { push, 0.0 }; });
    const double rest = push > 0.0 ? 0.5 + inside : -0.3 - inside;
    const auto rests = [&](VirtualDriver& driver) { return std::fabs(driver.position[0] - rest) < 0.01; };
    EXPECT_TRUE(servo.runUntil([&] { return stick.alone(rests); })) << push;
  }
}

TEST(Evdev, AProgramThatIsKilledLeavesNoForce)
{
  UinputStick stick(0x0106);
  OtherProgram program({ "--push-evdev", "262" }); // 0x0106
  ASSERT_TRUE(waitUntil([&] { return stick.force()[0] > 0.3; }));
  program.kill();
  const std::int64_t killed_ms = stick.time_ms();
  EXPECT_TRUE(waitUntil([&] { return stick.playing() == 0; }));
  EXPECT_LE(stick.time_ms() - killed_ms, test::expired_ms());
  EXPECT_EQ(stick.force()[0], 0.0);
  EXPECT_TRUE(waitUntil([&] { return stick.alone([](VirtualDriver& driver) { return driver.held(); }) == 0; }));
}

TEST(Evdev, ADriverThatHangsIsAFaultAndItsForceEndsByItself)
{
  UinputStick stick(0x0107);
  EventServo servo(UinputStick::vendor, 0x0107);
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return stick.force()[0] > 0.3; }));
  stick.hangs = true;
  const std::int64_t from_ms = stick.time_ms();
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Lost; }));
  EXPECT_TRUE(servo.runUntil([&] { return stick.playing() == 0; }));
  EXPECT_LE(stick.time_ms() - from_ms, test::expired_ms());
  stick.hangs = false;
  EXPECT_TRUE(servo.runUntil([&] { return servo.device.linkReport().stalls > 0; }));
}

TEST(Evdev, AStickThatIsUnpluggedIsLostAndFoundAgainWithoutForce)
{
  auto stick = std::make_unique<UinputStick>(0x0108);
  EventServo servo(UinputStick::vendor, 0x0108);
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return stick->force()[0] > 0.3; }));
  stick.reset();
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Lost; }));
  stick = std::make_unique<UinputStick>(0x0108);
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Ok; }));
  servo.run(200);
  EXPECT_EQ(stick->force()[0], 0.0);
}

/// A G29, plugged in once the kernel has let go of the last one: nothing tells one from another.
class EvdevWheel : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto isG29 = [](const HidEntry& entry) { return entry.vendor == logitech && entry.product == g29; };
    const auto gone = [&]
    {
      const std::vector<HidEntry> all = systemEvdevBus()->devices();
      return std::none_of(all.begin(), all.end(), isG29);
    };
    ASSERT_TRUE(waitUntil(gone));
    this->wheel.plug();
  }
  UsbWheel wheel;
};

// The kernel's hid-logitech gives the orders; their meaning stands at LogitechWheel.
TEST_F(EvdevWheel, UnderTheKernelsOwnDriverIsPushedAsTheCommandSays)
{
  EventServo servo(logitech, g29);
  const std::vector<FoundEvdev> found = findEvdevDevices(*servo.bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "evdev-046d-c24f");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].kind.pushes.deviceClass, DeviceClass::Wheel1D);
  ASSERT_EQ(servo.device.open(), "");
  wheel.alone([](test::LogitechWheel& firmware) { firmware.position = 0.25; });
  ASSERT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Ok; }));
  const double quarter_m = 0.25 * servo.options.output.scale.halfTravel_m;
  EXPECT_TRUE(servo.runUntil([&] { return std::fabs(servo.sample.pose_D.p.x() - quarter_m) < 1e-5; }));
  std::cout << "its smallest step is " << servo.device.info().resolution_m.value << " m\n";
  for (const double force_N : { 1.0, -2.0, 3.0, -0.5, 0.0 })
  {
    servo.command.wrench_D.force = { force_N, 0.0, 0.0 };
    const double wanted = force_N / servo.options.output.scale.maxForce_N;
    EXPECT_TRUE(servo.runUntil([&] { return std::fabs(wheel.forceX() - wanted) <= VirtualDriver::rounding; }))
      << force_N;
  }
  wheel.alone(
    [](test::LogitechWheel& firmware)
    {
      EXPECT_FALSE(firmware.ownSpring);
      EXPECT_EQ(firmware.range_deg, 900);
      EXPECT_EQ(firmware.unknown, 0);
    });
}

TEST_F(EvdevWheel, IsLeftWithoutForceByClosingAndByTheDeathOfAProgram)
{
  {
    EventServo servo(logitech, g29);
    ASSERT_EQ(servo.device.open(), "");
    // The kernel throws away reports of the first 50 ms (usbhid_open), and without a move the wheel sends no more.
    wheel.alone([](test::LogitechWheel& firmware) { firmware.position = 0.25; });
    servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    ASSERT_TRUE(servo.runUntil([&] { return wheel.forceX() > 0.3; }));
    servo.device.close();
    EXPECT_TRUE(waitUntil([&] { return wheel.forceX() == 0.0; }));
  }
  OtherProgram program({ "--push-wheel" });
  ASSERT_TRUE(waitUntil([&] { return wheel.forceX() > 0.3; }));
  program.kill();
  const std::int64_t killed_ms = wheel.time_ms();
  EXPECT_TRUE(waitUntil([&] { return wheel.forceX() == 0.0; }));
  std::cout << "without force " << wheel.time_ms() - killed_ms << " ms after the program was killed\n";
  EXPECT_LE(wheel.time_ms() - killed_ms, test::expired_ms());
}

TEST_F(EvdevWheel, ThatAnotherProgramDrivesPastTheKernelsDriverIsNotOffered)
{
  const std::shared_ptr<EvdevBus> bus = systemEvdevBus();
  const HidEntry entry = test::waitForEventDevice(*bus, logitech, g29);
  EXPECT_EQ(bus->open(entry).problem, "");
  const std::vector<HidEntry> hid = systemHidBus()->devices();
  ASSERT_EQ(hid.size(), 1u);
  const int past = ::open(hid[0].path.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(past, 0);
  EXPECT_NE(bus->open(entry).problem.find("close that program first"), std::string::npos);
  ::close(past);
  EXPECT_EQ(bus->open(entry).problem, "");
}

// The kernel's hid-pidff drives it too; ours goes past that.
TEST(Evdev, AStickOfThePidClassIsNotOfferedHereThoughTheKernelPushesItToo)
{
  test::UsbDevice device(test::plainLayout(), "both roads");
  device.plug();
  const std::shared_ptr<EvdevBus> bus = systemEvdevBus();
  static_cast<void>(test::waitForEventDevice(*bus, device.identity().vendor, device.identity().product));
  EXPECT_TRUE(findEvdevDevices(*bus).empty());
}

} // namespace
} // namespace palpate
