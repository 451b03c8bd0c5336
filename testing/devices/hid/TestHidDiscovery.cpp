// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>

#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/hid/HidapiBus.h"
#include "devices/io/HidDiscovery.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using test::FakeHidBus;
using test::FakePort;

TEST(HidDiscovery, NamesWhatIsPluggedInAndSaysWhatCannotBeUsedAndWhy)
{
  FakeHidBus bus;
  bus.plug(test::plainLayout(), "7");
  bus.plug(test::driverManagedLayout(), "8");
  bus.plug(test::hobbyLayout(), "9").openProblem = "no permission";
  FakePort& mouse = bus.plug(test::plainLayout(), "10");
  mouse.descriptor = { 0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x30, 0x75, 0x08, 0x95, 0x01, 0x81, 0x06, 0xC0 };
  const std::vector<FoundHid> found = findHidDevices(bus);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].name, "pid-1209-ffb0-7");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_NE(found[1].problem.find("driver-managed"), std::string::npos);
  EXPECT_EQ(found[2].problem, "no permission");
}

// The number of bytes and the place of the fault are for whoever writes the firmware.
TEST(HidDiscovery, AStickWhoseDescriptorIsCutIsListedWithTheReason)
{
  FakeHidBus bus;
  FakePort& cut = bus.plug(test::plainLayout(), "7");
  cut.descriptor.resize(cut.descriptor.size() / 2);
  const std::vector<FoundHid> found = findHidDevices(bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "hid-1209-ffb0-7");
  EXPECT_NE(found[0].problem.find("report descriptor of " + std::to_string(cut.descriptor.size()) + " bytes, at byte"),
    std::string::npos)
    << found[0].problem;
  EXPECT_EQ(cut.opened, 0);
}

TEST(HidDiscovery, AJoystickWithoutForceIsListedAndAKeyboardIsNotHoweverBrokenItIs)
{
  FakeHidBus bus;
  const auto described = [&](std::uint8_t purpose)
  {
    return std::vector<std::uint8_t>{ 0x05, 0x01, 0x09, purpose, 0xA1, 0x01, 0x09, 0x30, 0x15, 0x00, 0x25, 0x7F, 0x75,
      0x08, 0x95, 0x01, 0x81, 0x02, 0xC0 };
  };
  bus.plug(test::plainLayout(), "7").descriptor = described(0x04);
  std::vector<std::uint8_t> keyboard = described(0x06);
  bus.plug(test::plainLayout(), "8").descriptor = keyboard;
  keyboard.pop_back();
  bus.plug(test::plainLayout(), "9").descriptor = keyboard;
  const std::vector<FoundHid> found = findHidDevices(bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].entry.serial, "7");
  EXPECT_TRUE(test::says(found[0].problem, { "no force", "USB PID class" }));
}

TEST(HidDiscovery, AStickWithoutADescriptorIsListedWhereTheSystemSaysWhatItIs)
{
  FakeHidBus bus;
  for (const HidUsage usage : { 0x010004u, 0x010006u })
  {
    FakePort& port = bus.plug(test::plainLayout(), std::to_string(usage));
    port.entry.usage = usage;
    port.descriptorProblem = "cannot be read";
  }
  const std::vector<FoundHid> found = findHidDevices(bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(test::says(found[0].problem, { "report", "descriptor", "device" }));
}

TEST(HidDiscovery, TwoAlikeWithoutSerialNumbersGetNamesOfTheirOwn)
{
  FakeHidBus bus;
  bus.plug(test::plainLayout(), "");
  bus.plug(test::plainLayout(), "");
  const std::vector<FoundHid> found = findHidDevices(bus);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "pid-1209-ffb0");
  EXPECT_EQ(found[1].name, "pid-1209-ffb0-2");
}

TEST(HidDiscovery, TheFactoryListsAndMakesThem)
{
  auto bus = std::make_shared<FakeHidBus>();
  bus->plug(test::plainLayout(), "7");
  bus->plug(test::driverManagedLayout(), "8");
  DeviceOptions options;
  options.hid = bus;
  const std::vector<KnownDevice> known = knownDevices(options);
  ASSERT_GE(known.size(), 2u);
  const KnownDevice &usable = known[known.size() - 2], &refused = known.back();
  EXPECT_EQ(usable.name, "pid-1209-ffb0-7");
  EXPECT_EQ(usable.problem, "");
  EXPECT_EQ(usable.info.deviceClass, DeviceClass::Joystick2D);
  EXPECT_EQ(usable.info.serial, "7");
  EXPECT_FALSE(usable.info.maxForce_N.known);
  EXPECT_NE(refused.problem.find("driver-managed"), std::string::npos);
  const MadeDevice made = makeDevice("pid-1209-ffb0-8", options);
  ASSERT_NE(made.device, nullptr);
  EXPECT_NE(made.device->open().find("driver-managed"), std::string::npos);
  bus->plug(test::plainLayout(), "9").descriptor.resize(100);
  const MadeDevice broken = makeDevice("hid-1209-ffb0-9", options);
  ASSERT_NE(broken.device, nullptr);
  EXPECT_FALSE(broken.device->info().rendersForce);
  EXPECT_NE(broken.device->open().find("report descriptor of 100 bytes"), std::string::npos);
  const MadeDevice unknown = makeDevice("pid-0000-0000", options);
  EXPECT_NE(unknown.problem.find("pid-1209-ffb0-7"), std::string::npos);
}

TEST(HidapiBus, WhyADeviceCannotBeOpenedComesWithTheCure)
{
  EXPECT_TRUE(
    test::says(openProblem("/dev/hidraw0", EACCES), { "devices/udev/70-palpate.rules", "/etc/udev/rules.d/" }));
  EXPECT_NE(openProblem("/dev/hidraw0", EBUSY).find("close the other program"), std::string::npos);
  EXPECT_NE(openProblem("/dev/hidraw0", ENODEV).find("plug the device in again"), std::string::npos);
  EXPECT_NE(openProblem("/dev/hidraw0", EIO).find("/dev/hidraw0"), std::string::npos);
}

TEST(HidapiBus, ADeviceThatIsNotThereIsAnAnswer)
{
  const std::shared_ptr<HidBus> bus = systemHidBus();
  const HidEntry gone{ "/dev/hidraw4095", 1, 2, "", "" };
  EXPECT_NE(bus->descriptor(gone).problem, "");
  const HidBus::Opened opened = bus->open(gone);
  EXPECT_EQ(opened.value, nullptr);
  EXPECT_NE(opened.problem.find("/dev/hidraw4095"), std::string::npos);
  static_cast<void>(bus->devices()); // whatever is plugged in here
}

} // namespace
} // namespace palpate
