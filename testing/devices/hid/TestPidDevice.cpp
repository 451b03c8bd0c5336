// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using test::FakeHidBus;
using test::FakePort;
using test::PidLayout;
using Rig = test::PidRig;
using test::VirtualPidDevice;

TEST(PidDevice, ShowsTheHandInMetresOnEveryLayoutToOneStep)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    Rig rig(layout);
    ASSERT_EQ(rig.device.open(), "") << layout.name;
    rig.stick().position = { 0.25, -0.5 };
    rig.stick().buttons = 0x81;
    rig.run(5);
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    // One step is the range divided by its numbers; y is turned round: HID's points towards the person.
    const double step_m = rig.device.info().resolution_m.value;
    EXPECT_NEAR(step_m, 2 * 0.05 / static_cast<double>(layout.axis.max - layout.axis.min), 1e-12) << layout.name;
    EXPECT_NEAR(rig.sample.pose_D.p.x(), 0.25 * 0.05, step_m) << layout.name;
    EXPECT_NEAR(rig.sample.pose_D.p.y(), 0.5 * 0.05, step_m) << layout.name;
    EXPECT_EQ(rig.sample.buttons, 0x81u);
    EXPECT_EQ(rig.device.info().deviceClass, DeviceClass::Joystick2D);
    EXPECT_EQ(rig.stick().badReports, 0) << layout.name;
  }
}

// The force of a coefficient of 1; half as stiff a wall is a coefficient of a half, a stiffer one would be cut.
TEST(PidDevice, SaysHowStiffAndHowHardItsWallsAreWhereItHoldsAny)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  for (const PidLayout& layout : test::allLayouts())
  {
    Rig rig(layout);
    const DeviceInfo& info = rig.device.info();
    if (!info.abilities.holdsWalls)
    {
      EXPECT_EQ(info.heldStiffness_N_per_m.value, unlimited) << layout.name;
      continue;
    }
    EXPECT_EQ(info.heldForce_N.value, rig.scale().maxForce_N) << layout.name;
    for (const double share : { 0.5, 1.0 })
    {
      DeviceCommand command;
      command.walls[0] = { Vec3::UnitX(), 0.0, share * info.heldStiffness_N_per_m.value };
      command.wallCount = 1;
      const WallPlan plan = planWalls(command, rig.scale(), { true, true, true }, 1.0);
      EXPECT_DOUBLE_EQ(plan.springs[0].negativeCoefficient, share) << layout.name;
    }
  }
}

TEST(PidDevice, GivesTheForceOfTheCommandOnEveryLayout)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    Rig rig(layout);
    ASSERT_EQ(rig.device.open(), "");
    rig.command.wrench_D.force = { 1.0, -2.0, 0.0 };
    rig.run(30);
    const double step_N =
      5.0 * (1.0 / static_cast<double>(layout.magnitude.max) + M_PI / static_cast<double>(layout.wholeTurn));
    EXPECT_NEAR(rig.stick().force()[0] * 5.0, 1.0, step_N) << layout.name;
    EXPECT_NEAR(rig.stick().force()[1] * 5.0, 2.0, step_N) << layout.name;
    EXPECT_EQ(rig.stick().badReports, 0) << layout.name;
    rig.command = {};
    rig.run(10);
    EXPECT_EQ(rig.stick().force()[0], 0.0) << layout.name;
    EXPECT_EQ(rig.stick().force()[1], 0.0) << layout.name;
  }
}

TEST(PidDevice, AWheelIsNeverAskedForTheAxisItDoesNotHave)
{
  Rig rig(test::wheelLayout());
  EXPECT_EQ(rig.device.info().deviceClass, DeviceClass::Wheel1D);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 1.0, 2.0, 0.0 };
  rig.run(30);
  EXPECT_NEAR(rig.stick().force()[0], 0.2, 1e-3);
  EXPECT_NEAR(rig.stick().force()[1], 0.0, 1e-12); // the cosine of a right angle
  EXPECT_EQ(rig.stick().effectsUsed(), 4);         // a force, a spring, a damper, a shake
  EXPECT_EQ(rig.stick().badReports, 0);
}

TEST(PidDevice, ASignalIsFeltOnceAndEndsByItself)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.command.signal = Signal::Oscillation;
  double strongest = 0.0;
  int shaken = 0;
  for (int ms = 0; ms < 600; ++ms)
  {
    rig.run(1);
    strongest = std::max(strongest, std::fabs(rig.stick().force()[0]));
    shaken += rig.stick().force()[0] != 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(strongest, 0.3, 0.01);
  const int duration_ms = rig.options.output.duration_ms;
  EXPECT_NEAR(shaken, duration_ms, 0.2 * duration_ms); // less the passages through zero
  EXPECT_EQ(rig.stick().force()[0], 0.0);
}

TEST(PidDevice, HoldsFourWallsWhileTheHostOnlyRestartsThem)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const double half_m = rig.scale().halfTravel_m, K = rig.scale().springStiffness_N_per_m;
  rig.command.wallCount = 4;
  rig.command.walls = { { { Vec3::UnitX(), -0.3 * half_m, K }, { -Vec3::UnitX(), -0.5 * half_m, K },
    { Vec3::UnitY(), -0.2 * half_m, K }, { -Vec3::UnitY(), -0.2 * half_m, K } } };
  rig.run(1500); // the ramp
  const int outputs = rig.stick().outputs, conditions = rig.stick().conditions;
  rig.stick().push = { 0.5, 0.0 };
  rig.run(2000);
  EXPECT_NEAR(rig.stick().position[0], 0.5 + 0.5 / VirtualPidDevice::springGain, 1e-3);
  EXPECT_EQ(rig.stick().conditions, conditions);
  // Four effects restarted every 100 ms, each a report of 1 ms.
  EXPECT_NEAR(rig.stick().outputs - outputs, 4 * 20, 8);
  EXPECT_EQ(rig.stick().badReports, 0);
}

TEST(PidDevice, ClosesWallsItselfWhereTheDeviceCannot)
{
  Rig rig(test::adapterLayout());
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_FALSE(rig.device.abilitiesNow().holdsWalls);
  const double half_m = rig.scale().halfTravel_m;
  rig.command.wallCount = 1;
  rig.command.walls[0] = { -Vec3::UnitX(), 0.0, 40.0 };
  rig.stick().push = { 0.2, 0.0 };
  rig.run(4000);
  // At rest the spring of 40 N/m balances a fifth of 5 N.
  EXPECT_NEAR(rig.stick().position[0] * half_m, 0.2 * 5.0 / 40.0, 0.05 * half_m);
}

TEST(PidDevice, WhatTheDeviceHoldsRisesSlowlyOnceForceIsAskedFor)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.stick().position = { -0.8, 0.0 };
  rig.stick().push = { -1.0, 0.0 }; // to stay there
  rig.run(50);
  rig.command.wallCount = 1;
  rig.command.walls[0] = { Vec3::UnitX(), 0.0, rig.scale().springStiffness_N_per_m };
  double before = 0.0;
  for (int ms = 0; ms < 1200; ms += 20)
  {
    rig.run(20);
    const double force = rig.stick().force()[0];
    // The steepest rise of 3 s^2 - 2 s^3 is 1.5 a second; updates come every 16 ms.
    EXPECT_LE(force - before, 0.6 * 1.5 * 0.040) << ms;
    before = force;
  }
  EXPECT_NEAR(before, 0.6, 0.01);
}

TEST(PidDevice, ForceStopsWhenTheServoFallsSilentAndOldForceDoesNotComeBack)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(100);
  EXPECT_GT(rig.stick().force()[0], 0.3);
  for (int ms = 0; ms < 40; ++ms)
  {
    rig.pass();
  }
  EXPECT_EQ(rig.stick().force()[0], 0.0);
  EXPECT_EQ(rig.stick().stopAlls, 1 + 1); // once when it was opened
  rig.command = {};
  for (int ms = 0; ms < 100; ++ms)
  {
    rig.run(1);
    EXPECT_EQ(rig.stick().force()[0], 0.0);
  }
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(20);
  EXPECT_GT(rig.stick().force()[0], 0.3);
}

TEST(PidDevice, AProgramThatDiesLeavesNoForceAfterAQuarterSecond)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.command.wallCount = 1;
  rig.command.walls[0] = { Vec3::UnitX(), 0.05, rig.scale().springStiffness_N_per_m };
  rig.run(1500);
  EXPECT_GT(rig.stick().force()[0], 0.3);
  rig.bus->advance(250); // nobody writes any more
  EXPECT_EQ(rig.stick().effectsPlaying(), 0);
  EXPECT_EQ(rig.stick().force()[0], 0.0);
}

TEST(PidDevice, ClosingLeavesTheDeviceWithoutForceAndEffects)
{
  Rig rig(test::hobbyLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  rig.device.close();
  EXPECT_EQ(rig.stick().force()[0], 0.0);
  EXPECT_EQ(rig.stick().effectsUsed(), 0);
  EXPECT_EQ(rig.port.opened, 2); // one for the order to stop
  EXPECT_EQ(rig.port.closed, 2);
}

TEST(PidDevice, UnpluggedAndPluggedInAgainItGivesForceOnlyAfterARest)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  rig.port.present = false;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  EXPECT_TRUE(test::says(rig.device.link().report().message, { "not attached" }));
  rig.port.present = true;
  rig.port.entry.path = "elsewhere";
  rig.port.device = std::make_shared<VirtualPidDevice>(test::plainLayout()); // it forgot everything
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_TRUE(test::says(rig.device.link().report().message, { "unplugged" })); // no more that it is not there
  EXPECT_EQ(rig.stick().force()[0], 0.0); // still asked for, but nobody has engaged again
  rig.command = {};
  rig.run(5);
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(20);
  EXPECT_NEAR(rig.stick().force()[0], 0.4, 1e-3);
}

TEST(PidDevice, AnotherProgramThatResetsTheDeviceIsNoticed)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  const std::vector<std::uint8_t> disable{ 0x1C, 2 };
  ASSERT_TRUE(rig.stick().take(HidReportKind::Output, disable));
  rig.run(50);
  EXPECT_GE(rig.lostTicks, 1);
  EXPECT_TRUE(rig.stick().actuators);
  EXPECT_EQ(rig.stick().force()[0], 0.0);
  EXPECT_NE(rig.device.link().report().message.find("another program"), std::string::npos);
}

TEST(PidDevice, NoPermissionBusyAndABrokenDescriptorAreSaidWithTheName)
{
  for (const std::string problem : { "no permission", "busy" })
  {
    Rig rig(test::plainLayout());
    rig.port.openProblem = problem;
    EXPECT_NE(rig.device.open().find("\"plain stick\": " + problem), std::string::npos);
  }
  Rig cut(test::plainLayout());
  cut.port.descriptor.resize(cut.port.descriptor.size() / 2);
  EXPECT_NE(cut.device.open().find("report descriptor of"), std::string::npos);
  Rig managed(test::driverManagedLayout());
  EXPECT_NE(managed.device.open().find("driver-managed pool"), std::string::npos);
}

TEST(PidDevice, UnpluggingAtAnyStepOfOpeningIsAnAnswerAndNothingStaysOpen)
{
  bool opened = false;
  int steps = 0;
  for (; !opened; ++steps)
  {
    auto rig = std::make_unique<Rig>(test::plainLayout());
    rig->port.callsUntilUnplugged = steps;
    const std::string problem = rig->device.open();
    opened = problem.empty();
    EXPECT_TRUE(opened || problem.find("plain stick") != std::string::npos) << problem;
    EXPECT_TRUE(opened || rig->port.opened == rig->port.closed) << steps;
    ASSERT_LT(steps, 200);
  }
  EXPECT_GT(steps, 20);
}

TEST(PidDevice, AFullPoolLeavesTheForceAndSaysWhatIsMissing)
{
  PidLayout small = test::plainLayout();
  small.slots = 2;
  Rig two(small);
  EXPECT_EQ(two.device.open(), "");
  EXPECT_EQ(two.device.abilitiesNow(), (DeviceAbilities{ 2, false, false, false }));
  small.slots = 1;
  Rig one(small);
  EXPECT_NE(one.device.open().find("full"), std::string::npos);
}

TEST(PidDevice, ShortAndForeignInputIsCountedAndChangesNothing)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const ReportDescriptor descriptor = parseReportDescriptor(rig.port.descriptor);
  const PidInput input(descriptor);
  EXPECT_FALSE(input.hand(std::vector<std::uint8_t>{ 0x01, 1, 2, 3 }));
  EXPECT_FALSE(input.hand(std::vector<std::uint8_t>{ 0x77, 1, 2, 3, 4, 5 }));
  EXPECT_FALSE(input.hand({}));
  const std::optional<PidHand> beyond = input.hand(std::vector<std::uint8_t>{ 0x01, 0x00, 0x80, 0, 0, 0 });
  ASSERT_TRUE(beyond); // -32768 where -32767 is the least
  EXPECT_TRUE(beyond->outOfRange);
  EXPECT_EQ(beyond->at[0], -1.0);
}

// Buttons 1 and 2 before the axis, 5 and 6 behind it.
TEST(PidDevice, ButtonsInSeveralGroupsOfAReportAreAllHeard)
{
  const std::vector<std::uint8_t> bytes{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95,
    0x02, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x81, 0x02, 0x95, 0x06, 0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x25, 0x7F,
    0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x05, 0x09, 0x19, 0x05, 0x29, 0x06, 0x81,
    0x02, 0x95, 0x06, 0x81, 0x01, 0xC0 };
  const ReportDescriptor descriptor = parseReportDescriptor(bytes);
  ASSERT_EQ(descriptor.problem, "");
  const PidInput input(descriptor, 1);
  EXPECT_EQ(input.buttonCount(), 6U);
  for (std::uint8_t down = 0; down < 16; ++down)
  {
    const std::vector<std::uint8_t> report{ static_cast<std::uint8_t>(down & 3U), 64,
      static_cast<std::uint8_t>(down >> 2U) };
    const std::optional<PidHand> hand = input.hand(report);
    ASSERT_TRUE(hand);
    EXPECT_EQ(hand->buttons, (down & 3U) | (down >> 2U) << 4U);
  }
}

TEST(PidDevice, InputThatPiledUpIsReadToTheNewest)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.stick().push = { 1.0, 0.0 };
  rig.bus->advance(60); // 60 reports wait
  ASSERT_TRUE(rig.device.link().readPass(0));
  ASSERT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), rig.stick().position[0] * rig.scale().halfTravel_m, 1e-5);
}

TEST(PidDevice, AStalledWriteFailsAndIsALossInVirtualTime)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  rig.port.stalls = true;
  rig.run(6000);
  EXPECT_GE(rig.lostTicks, 1);
  EXPECT_EQ(rig.stick().effectsPlaying(), 0); // it ended by itself
}

// 5 s of servo, tick by tick in virtual time, while a write hangs for real: no tick waits, locks or allocates.
TEST(PidDevice, AWriteThatHangsDelaysNoTick)
{
  auto bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::plainLayout());
  PidDevice device("pid", bus, port.entry);
  ASSERT_EQ(device.open(), "");
  bus->alone([&] { return port.stalls = true; });
  const auto hanging = [&] { return bus->alone([&] { return port.hanging; }); };
  DeviceCommand command;
  DeviceSample sample;
  command.wrench_D.force.x() = 2.0;
  ASSERT_TRUE(test::eventually([&] { return device.write(command), hanging() > 0; }));
  int lost = 0;
  {
    const test::AllocationGuard guard;
    for (int tick = 0; tick < 5000; ++tick)
    {
      lost += device.read(1e-3 * tick, sample) == DeviceStatus::Lost ? 1 : 0;
      command.wrench_D.force.x() = 1e-3 * tick;
      device.write(command);
    }
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u);
  }
  EXPECT_GT(hanging(), 0);
  EXPECT_TRUE(test::eventually(
    [&]
    {
      device.write(command);
      lost += device.read(0.0, sample) == DeviceStatus::Lost ? 1 : 0;
      return lost > 0;
    })); // noticed after 50 ms
  bus->release(port);
}

TEST(PidDevice, ItsThreadsCarryTheHandAndTheForce)
{
  auto bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::plainLayout());
  PidDevice device("pid", bus, port.entry);
  ASSERT_EQ(device.open(), "");
  bus->alone([&] { return port.device->position[0] = 0.5; });
  DeviceCommand command;
  DeviceSample sample;
  command.wrench_D.force.x() = 1.0;
  EXPECT_TRUE(test::eventually(
    [&]
    {
      bus->advance(1);
      device.write(command);
      static_cast<void>(device.read(0.0, sample));
      return bus->alone([&] { return port.device->force()[0]; }) > 0.19 && sample.pose_D.p.x() > 0.02;
    }));
  device.close();
  EXPECT_EQ(bus->alone([&] { return port.device->effectsUsed(); }), 0);
}

} // namespace
} // namespace palpate
