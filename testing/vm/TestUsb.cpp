// SPDX-License-Identifier: GPL-3.0-or-later
// For the behaviour of a bus alone: writes that wait. Runs in a virtual machine of its own (README.md).
#include <cmath>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "testing/vm/Pushing.h"
#include "testing/vm/UsbDevice.h"

namespace palpate
{
namespace
{

using test::Pushing;
using test::UsbDevice;
using test::VirtualPidDevice;

TEST(Usb, ForceReachesADeviceOnTheBusAndUnpluggedItIsLostAndFoundAgain)
{
  Pushing<UsbDevice> rig("usb");
  EXPECT_NE(rig.servo.entry.name.find("plain"), std::string::npos);
  EXPECT_EQ(rig.servo.bus->descriptor(rig.servo.entry).value, test::descriptorOf(rig.device.layout()));
  ASSERT_TRUE(rig.begin());
  EXPECT_TRUE(rig.servo.runUntil([&] { return std::fabs(rig.device.forceX() - 0.4) < 1e-3; }));
  const int before = rig.device.badReports(); // of the kernel's own driver, which tries the device out first
  rig.servo.run(500);
  EXPECT_EQ(rig.device.badReports(), before);
  rig.device.unplug();
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.servo.status == DeviceStatus::Lost; }));
  rig.device.plug();
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.servo.status == DeviceStatus::Ok; }));
  rig.servo.run(200);
  EXPECT_EQ(rig.device.forceX(), 0.0);
}

TEST(Usb, ADeviceWhoseOutputStallsIsAFaultIsToldToStopAndPushesNoLongerWhileTheServoGoesOn)
{
  Pushing<UsbDevice> rig("stalled");
  ASSERT_TRUE(rig.begin());
  const int stopsBefore = rig.device.stopAlls();
  rig.device.stalls = true;
  const std::int64_t from_ms = rig.device.time_ms();
  std::int64_t lost_ms = 0, told_ms = 0, still_ms = 0; // since then
  const auto look = [&]
  {
    const auto note = [&](std::int64_t& when_ms, bool now)
    { when_ms = when_ms == 0 && now ? rig.device.time_ms() - from_ms : when_ms; };
    note(lost_ms, rig.servo.status == DeviceStatus::Lost);
    note(told_ms, rig.device.refusedStops > 0);
    note(still_ms, rig.device.effectsPlaying() == 0);
    return lost_ms > 0 && told_ms > 0 && still_ms > 0;
  };
  EXPECT_TRUE(rig.servo.runUntil(look, 15000));
  std::cout << "lost after " << lost_ms << " ms, told to stop after " << told_ms << " ms, still after " << still_ms
            << " ms\n";
  EXPECT_LE(still_ms, test::expired_ms());
  // Long before the kernel gives up: a tick that waited for the device would see nothing of it for 5 s.
  EXPECT_LE(lost_ms, 2000);
  EXPECT_LE(told_ms, 2000);
  rig.device.stalls = false;
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.device.stopAlls() > stopsBefore; }));
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.servo.device.link().report().attached; }, 20000));
}

} // namespace
} // namespace palpate
