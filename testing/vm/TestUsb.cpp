// SPDX-License-Identifier: GPL-3.0-or-later
// What only a bus shows: writes that wait. Runs in a virtual machine of its own (README.md).
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "testing/vm/Servo.h"
#include "testing/vm/UsbDevice.h"

namespace palpate
{
namespace
{

using test::Servo;
using test::UsbDevice;
using test::VirtualPidDevice;
using test::waitUntil;

double forceX(UsbDevice& device)
{
  return device.alone([](VirtualPidDevice& stick) { return stick.force()[0]; });
}

int badReports(UsbDevice& device)
{
  return device.alone([](VirtualPidDevice& stick) { return stick.badReports; });
}

TEST(Usb, ForceReachesADeviceOnTheBusAndUnpluggedItIsLostAndFoundAgain)
{
  UsbDevice device(test::plainLayout(), "usb");
  device.plug();
  Servo servo(device.serial());
  EXPECT_NE(servo.entry.name.find("plain"), std::string::npos);
  EXPECT_EQ(servo.bus->descriptor(servo.entry).bytes, test::descriptorOf(device.layout()));
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  EXPECT_TRUE(servo.runUntil([&] { return std::fabs(forceX(device) - 0.4) < 1e-3; }));
  const int before = badReports(device); // of the kernel's own driver, which tries the device out first
  servo.run(500);
  EXPECT_EQ(badReports(device), before);
  device.unplug();
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Lost; }));
  device.plug();
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Ok; }));
  servo.run(200);
  EXPECT_EQ(forceX(device), 0.0);
}

TEST(Usb, ADeviceWhoseOutputStallsIsAFaultIsToldToStopAndPushesNoLongerWhileTheServoGoesOn)
{
  UsbDevice device(test::plainLayout(), "stalled");
  device.plug();
  Servo servo(device.serial());
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return forceX(device) > 0.3; }));
  device.stalls = true;
  const std::int64_t from_ms = device.time_ms();
  bool lost = false;
  const auto isLost = [&] { return lost = lost || servo.status == DeviceStatus::Lost; };
  const auto atRest = [](VirtualPidDevice& stick) { return stick.effectsPlaying() == 0; };
  EXPECT_TRUE(servo.runUntil([&] { return static_cast<void>(isLost()), device.alone(atRest); }));
  EXPECT_LE(device.time_ms() - from_ms, 250);
  EXPECT_TRUE(servo.runUntil(isLost, 2000)); // long before the kernel gives up
  std::cout << "lost after at most " << device.time_ms() - from_ms << " ms, ";
  EXPECT_TRUE(servo.runUntil([&] { return device.refusedStops > 0; }, 15000));
  std::cout << "told to stop after " << device.time_ms() - from_ms << " ms\n";
  // A call that waited for the device would take 5 s.
  EXPECT_LT(servo.longestTick, std::chrono::seconds(1));
  device.stalls = false;
  EXPECT_TRUE(servo.runUntil([&] { return servo.device.link().report().attached; }, 20000));
}

} // namespace
} // namespace palpate
