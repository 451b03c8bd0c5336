// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in a virtual machine of its own (README.md): hidapi and the kernel are the real ones, the joystick is not. Times
// of the device are those of its firmware's clock; where a person's computer is waited for there is slack.
#include <cmath>

#include <gtest/gtest.h>

#include "devices/hid/HidapiBus.h"
#include "devices/io/HidDiscovery.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "testing/vm/OtherProgram.h"
#include "testing/vm/Pushing.h"
#include "testing/vm/Servo.h"
#include "testing/vm/UhidDevice.h"

namespace palpate
{
namespace
{

using test::OtherProgram;
using test::Pushing;
using test::Servo;
using test::UhidDevice;
using test::VirtualPidDevice;
using test::waitUntil;

TEST(Uhid, EveryLayoutIsFoundAsAForceFeedbackDeviceWithTheDescriptorItHas)
{
  const std::shared_ptr<HidBus> bus = systemHidBus();
  for (const test::PidLayout& layout : test::allLayouts())
  {
    UhidDevice device(layout, "layout " + layout.name);
    device.plug();
    const HidEntry entry = test::waitForEntry(*bus, device.serial());
    EXPECT_EQ(entry.name, layout.name);
    EXPECT_EQ(bus->descriptor(entry).value, test::descriptorOf(layout)) << layout.name;
    const std::vector<FoundHid> found = findHidDevices(*bus);
    ASSERT_EQ(found.size(), 1u) << layout.name;
    EXPECT_EQ(found[0].problem, "") << layout.name;
    EXPECT_EQ(found[0].entry.serial, device.serial());
  }
}

TEST(Uhid, OneLookAtTheDeviceShowsTheNewestPlaceOfTheHandNotTheOldestReport)
{
  UhidDevice device(test::plainLayout(), "newest");
  device.plug();
  PidDeviceOptions options = Servo::firmwareOptions();
  options.threads = false;
  Servo servo(device.serial(), options);
  ASSERT_EQ(servo.device.open(), "");
  const auto moveTo = [&](double x)
  {
    device.alone([x](VirtualPidDevice& stick) { stick.position = { x, 0.0 }; });
    const std::int64_t from_ms = device.time_ms();
    EXPECT_TRUE(waitUntil([&] { return device.time_ms() >= from_ms + 10; }));
  };
  moveTo(-0.5);
  moveTo(0.5);
  EXPECT_TRUE(servo.device.link().readPass(0));
  servo.run(1);
  EXPECT_NEAR(
    servo.sample.pose_D.p.x(), 0.5 * servo.options.output.scale.halfTravel_m, servo.device.info().resolution_m.value);
  EXPECT_GE(servo.device.link().report().inputs, 20u);
}

TEST(Uhid, TheForceOfTheCommandReachesTheFirmwareOnEveryLayout)
{
  for (const test::PidLayout& layout : test::allLayouts())
  {
    UhidDevice device(layout, "force " + layout.name);
    device.plug();
    Servo servo(device.serial());
    ASSERT_EQ(servo.device.open(), "") << layout.name;
    servo.command.wrench_D.force = { 1.0, 0.0, 0.0 };
    const double wanted = 1.0 / servo.options.output.scale.maxForce_N;
    const double step = 1.0 / static_cast<double>(layout.magnitude.max) + M_PI / static_cast<double>(layout.wholeTurn);
    EXPECT_TRUE(servo.runUntil([&] { return std::fabs(device.forceX() - wanted) <= step; })) << layout.name;
    servo.device.close();
    const auto emptied = [](VirtualPidDevice& stick) { return stick.effectsUsed() == 0; };
    EXPECT_TRUE(waitUntil([&] { return device.alone(emptied); })) << layout.name;
    // The rest is the spring to the centre that it had when it was plugged in, if it had one.
    EXPECT_TRUE(layout.habits.wakesCentred || device.forceX() == 0.0) << layout.name;
    EXPECT_EQ(device.badReports(), 0) << layout.name;
  }
}

// Stiffness K, push f: the hand rests f / K inside the wall.
void requireFourWalls(const test::PidLayout& layout)
{
  UhidDevice device(layout, "walls");
  device.plug();
  Servo servo(device.serial());
  ASSERT_EQ(servo.device.open(), "");
  const PidScale& scale = servo.options.output.scale;
  const double half_m = scale.halfTravel_m, K = scale.springStiffness_N_per_m;
  servo.command.wallCount = 4;
  servo.command.walls = { { { Vec3::UnitX(), -0.3 * half_m, K }, { -Vec3::UnitX(), -0.5 * half_m, K },
    { Vec3::UnitY(), -0.2 * half_m, K }, { -Vec3::UnitY(), -0.2 * half_m, K } } };
  servo.run(servo.options.output.rampUp_ms + 200);
  struct Push
  {
    VirtualPidDevice::Axes push, rest;
  };
  const double inside = 0.5 / VirtualPidDevice::springGain;
  // HID's y has the other direction, and these two walls are alike.
  for (const Push& push : { Push{ { 0.5, 0.0 }, { 0.5 + inside, 0.0 } }, Push{ { -0.5, 0.0 }, { -0.3 - inside, 0.0 } },
         Push{ { 0.0, 0.5 }, { 0.0, 0.2 + inside } }, Push{ { 0.0, -0.5 }, { 0.0, -0.2 - inside } } })
  {
    const std::size_t axis = push.push[0] != 0.0 ? 0 : 1;
    device.alone([&](VirtualPidDevice& stick) { stick.push = push.push; });
    const auto rests = [&](VirtualPidDevice& stick)
    { return std::fabs(stick.position[axis] - push.rest[axis]) < 0.01 && std::fabs(stick.velocity[axis]) < 0.01; };
    EXPECT_TRUE(servo.runUntil([&] { return device.alone(rests); })) << push.push[0] << " " << push.push[1];
  }
  EXPECT_EQ(device.badReports(), 0);
}

TEST(Uhid, TheHandRestsAgainstEachOfFourWallsThatTheDeviceHolds)
{
  requireFourWalls(test::plainLayout());
}

// Its walls count from the settings that follow them, with a sign that those bring.
TEST(Uhid, TheHandRestsAgainstEachOfFourWallsOnADeviceWithTheHabitsOfAnOpenBoard)
{
  requireFourWalls(test::openBoardLayout());
}

// A stop of all switches it off.
TEST(Uhid, ForceIsBackAfterTheServoWasSilentOnADeviceWithTheHabitsOfAnOpenBoard)
{
  UhidDevice device(test::openBoardLayout(), "silence");
  device.plug();
  Servo servo(device.serial());
  ASSERT_EQ(servo.device.open(), "");
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  ASSERT_TRUE(servo.runUntil([&] { return device.forceX() > 0.3; }));
  ASSERT_TRUE(waitUntil([&] { return device.forceX() == 0.0; }));
  EXPECT_TRUE(servo.runUntil([&] { return device.forceX() > 0.3; })) << servo.device.linkReport().lostFor;
  EXPECT_EQ(device.badReports(), 0);
}

TEST(Uhid, AProgramThatIsKilledLeavesNoForceAfterAQuarterSecond)
{
  UhidDevice device(test::plainLayout(), "killed");
  device.plug();
  OtherProgram program({ "--push", device.serial() });
  ASSERT_TRUE(waitUntil([&] { return device.forceX() > 0.3; }));
  program.kill();
  const std::int64_t killed_ms = device.time_ms();
  EXPECT_TRUE(waitUntil([&] { return device.effectsPlaying() == 0; }));
  EXPECT_LE(device.time_ms() - killed_ms, test::expired_ms());
  EXPECT_EQ(device.forceX(), 0.0);
}

TEST(Uhid, AFirmwareThatTakesNothingAnyMoreLeavesTheServoAloneAndItsForceEnds)
{
  Pushing<UhidDevice> rig("deaf");
  ASSERT_TRUE(rig.begin());
  rig.device.stalls = true;
  const std::int64_t from_ms = rig.device.time_ms();
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.device.effectsPlaying() == 0; }));
  EXPECT_LE(rig.device.time_ms() - from_ms, test::expired_ms());
  EXPECT_EQ(rig.device.forceX(), 0.0);
  rig.servo.run(500);
  EXPECT_LT(rig.device.time_ms() - from_ms, 5000); // which a single call that waited for the device would take
}

TEST(Uhid, ADeviceThatDoesNotAnswerIsSaidAfterTheKernelsPatience)
{
  UhidDevice device(test::plainLayout(), "mute");
  device.plug();
  Servo servo(device.serial());
  device.stalls = true;
  const std::string problem = servo.device.open();
  EXPECT_NE(problem.find("\"plain\": the device does not report its effect types"), std::string::npos) << problem;
}

TEST(Uhid, UnpluggedItIsAFaultAndPluggedInAgainElsewhereItHasNoForceUntilItIsAskedForAnew)
{
  Pushing<UhidDevice> rig("replugged");
  ASSERT_TRUE(rig.begin());
  rig.device.unplug();
  UhidDevice another(test::plainLayout(), "another");
  another.plug(); // it may get the path that the first one had
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.servo.status == DeviceStatus::Lost; }));
  rig.device.plug();
  EXPECT_TRUE(rig.servo.runUntil([&] { return rig.servo.status == DeviceStatus::Ok; }));
  rig.servo.run(200);
  EXPECT_EQ(rig.device.forceX(), 0.0);
  rig.servo.command = {};
  rig.servo.run(20);
  EXPECT_TRUE(rig.push());
  EXPECT_EQ(another.forceX(), 0.0);
}

TEST(Uhid, ASessionWhoseDeviceWasUnpluggedStaysAtFaultUntilAPersonEngages)
{
  UhidDevice device(test::plainLayout(), "session");
  device.plug();
  const std::shared_ptr<HidBus> bus = systemHidBus();
  auto owned = std::make_unique<PidDevice>("pid", bus, test::waitForEntry(*bus, device.serial()));
  PidLink& link = owned->link();
  HapticSession session;
  ASSERT_EQ(session.start(std::move(owned)), "");
  ASSERT_TRUE(waitUntil([&] { return session.report().ticks > 50; }));
  EXPECT_NE(session.state().fault, Fault::DeviceLost);
  device.unplug();
  const auto isLost = [&]
  {
    const Fault fault = session.state().fault;
    if (fault == Fault::LateServo) // on a computer with other work the guest is late now and then, and that stays too
    {
      session.engage();
    }
    return fault == Fault::DeviceLost;
  };
  EXPECT_TRUE(waitUntil(isLost));
  device.plug();
  EXPECT_TRUE(waitUntil([&] { return link.report().attached; }));
  const std::uint64_t ticks = session.report().ticks;
  EXPECT_TRUE(waitUntil([&] { return session.report().ticks > ticks + 50; }));
  EXPECT_EQ(session.state().fault, Fault::DeviceLost);
  session.engage();
  EXPECT_TRUE(waitUntil([&] { return session.state().fault != Fault::DeviceLost; }));
  EXPECT_EQ(session.stop(), "");
}

} // namespace
} // namespace palpate
