// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/evdev/EvdevDiscovery.h"
#include "testing/devices/evdev/FakeEvdevBus.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate
{
namespace
{

using test::FakeEvdevBus;
using test::FakeEvdevPort;
using test::FakeHidBus;
using test::FakePort;
using test::stickTraits;
using test::traitsWith;
using test::wheelTraits;

constexpr std::uint16_t logitech = 0x046D, g29 = 0xC24F;

/// A joystick with one axis of eight bits and nothing else.
const std::vector<std::uint8_t> plainStick{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x30, 0x15, 0x00, 0x25, 0x7F,
  0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0xC0 };

TEST(EvdevDiscovery, NamesWhatADriverPushesAndSaysWhatCannotBeUsedAndWhy)
{
  FakeEvdevBus bus;
  bus.plug(wheelTraits(), "", logitech, g29).behindPlug = { plainStick };
  bus.plug(stickTraits(), "42").openProblem = "no permission";
  bus.plug(traitsWith({ ABS_X, ABS_Y }, { BTN_SOUTH }, { FF_RUMBLE, FF_PERIODIC, FF_SINE, FF_GAIN }), "pad");
  bus.plug(traitsWith({ ABS_X, ABS_Y }, { BTN_TRIGGER }, {}), "old");
  bus.plug(traitsWith({ ABS_THROTTLE, ABS_WHEEL }, { BTN_GEAR_UP }, {}), "still");
  const std::vector<FoundEvdev> found = findEvdevDevices(bus);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found[0].name, "evdev-046d-c24f");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].kind.pushes.deviceClass, DeviceClass::Wheel1D);
  EXPECT_EQ(found[0].kind.pushes.sensedAxes, 1u);
  EXPECT_EQ(found[1].name, "evdev-046d-c281-42");
  EXPECT_EQ(found[1].problem, "no permission");
  EXPECT_EQ(found[1].kind.pushes.deviceClass, DeviceClass::Joystick2D);
  EXPECT_NE(found[2].problem.find("vibration only"), std::string::npos);
  EXPECT_NE(found[3].problem.find("no force"), std::string::npos);
  EXPECT_NE(found[4].problem.find("no force"), std::string::npos);
  EXPECT_EQ(found[4].kind.axes[0], ABS_WHEEL);
}

TEST(EvdevDiscovery, LeavesOutMiceKeyboardsAndTablets)
{
  FakeEvdevBus bus;
  bus.plug(traitsWith({}, { KEY_A }, {}), "keyboard");
  bus.plug(traitsWith({}, { BTN_LEFT, BTN_RIGHT }, {}), "mouse");
  bus.plug(traitsWith({ ABS_X, ABS_Y }, { BTN_TOUCH, BTN_TOOL_PEN }, { FF_CONSTANT }), "tablet");
  EXPECT_TRUE(findEvdevDevices(bus).empty());
}

// Whatever the kernel's own driver offers of it: two that drive one device undo each other's effects.
TEST(EvdevDiscovery, ADeviceThatSpeaksPidAnywhereBehindItsPlugIsNotOffered)
{
  FakeEvdevBus bus;
  FakeEvdevPort& stick = bus.plug(stickTraits());
  ASSERT_EQ(findEvdevDevices(bus).size(), 1u);
  stick.behindPlug = { plainStick, test::descriptorOf(test::plainLayout()) };
  EXPECT_TRUE(findEvdevDevices(bus).empty());
  stick.behindPlug = { test::descriptorOf(test::driverManagedLayout()) };
  EXPECT_TRUE(findEvdevDevices(bus).empty());
  EXPECT_EQ(stick.opened, 1);
}

TEST(EvdevDiscovery, TwoThatNothingTellsApartHaveNamesOfTheirOwnAndKnowOfEachOther)
{
  FakeEvdevBus bus;
  bus.plug(wheelTraits(), "", logitech, g29);
  bus.plug(stickTraits(), "7");
  bus.plug(wheelTraits(), "", logitech, g29);
  const std::vector<FoundEvdev> found = findEvdevDevices(bus);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[2].name, "evdev-046d-c24f-2");
  EXPECT_TRUE(found[0].hasTwin);
  EXPECT_FALSE(found[1].hasTwin);
  EXPECT_TRUE(found[2].hasTwin);
}

// hid-logitech's wheel is a joystick without force to whoever looks through HID.
TEST(EvdevFactory, ListsADeviceOnceAndMakesItByItsName)
{
  const auto hid = std::make_shared<FakeHidBus>();
  const auto events = std::make_shared<FakeEvdevBus>();
  DeviceOptions options;
  options.hid = hid;
  FakePort& wheel = hid->plug(test::plainLayout(), "");
  wheel.entry.vendor = logitech;
  wheel.entry.product = g29;
  wheel.descriptor = plainStick;
  EXPECT_EQ(knownDevices(options).back().name, "hid-046d-c24f");
  options.evdev = events;
  events->plug(wheelTraits(), "", logitech, g29).behindPlug = { plainStick };
  const std::vector<KnownDevice> known = knownDevices(options);
  for (const KnownDevice& device : known)
  {
    EXPECT_NE(device.name, "hid-046d-c24f");
  }
  EXPECT_EQ(known.back().name, "evdev-046d-c24f");
  EXPECT_EQ(known.back().problem, "");
  EXPECT_EQ(known.back().info.deviceClass, DeviceClass::Wheel1D);
  EXPECT_FALSE(known.back().info.offersWalls);
  const MadeDevice made = makeDevice("evdev-046d-c24f", options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_EQ(made.device->open(), "");
}

} // namespace
} // namespace palpate
