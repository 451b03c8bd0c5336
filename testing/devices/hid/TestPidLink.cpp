// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the link to a device, and its reaction to a device that does not keep up.
#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"
#include "testing/support/Eventually.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using test::FakeHidBus;
using test::FakePort;
using Rig = test::PidRig;

// Virtual sticks report each millisecond; four effects are armed again every 100 ms.
TEST(PidLink, ReportsHowManyReportsComeHowManyGoAndWhatIsArmedAgain)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const int opening = rig.stick().outputs;
  rig.command.wrench_D.force.x() = 1.0;
  rig.run(3000);
  const LinkReport report = rig.device.linkReport();
  EXPECT_NEAR(report.inputRate_Hz, 1000.0, 10.0);
  EXPECT_NEAR(static_cast<double>(report.inputs), 3000.0, 10.0);
  EXPECT_NEAR(static_cast<double>(report.restarts), 4 * 30, 8);
  EXPECT_EQ(report.outputs, static_cast<std::uint64_t>(rig.stick().outputs - opening));
  EXPECT_EQ(report.strange + report.outOfRange + report.stalls + report.losses, 0U);
  EXPECT_TRUE(report.attached);
}

TEST(PidLink, ShortForeignAndImpossibleReportsAreCountedAndChangeNothing)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(5);
  const Vec3 before_D = rig.sample.pose_D.p;
  rig.stick().show({ 0x01, 1, 2, 3 });
  rig.stick().show({ 0x77, 1, 2, 3, 4, 5 });
  ASSERT_TRUE(rig.device.link().readPass(0));
  EXPECT_EQ(rig.device.linkReport().strange, 2U);
  EXPECT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_EQ(rig.sample.pose_D.p, before_D);
  rig.stick().show({ 0x01, 0x00, 0x80, 0, 0, 0 }); // -32768 where -32767 is the least
  ASSERT_TRUE(rig.device.link().readPass(0));
  EXPECT_EQ(rig.device.linkReport().outOfRange, 1U);
  EXPECT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_EQ(rig.sample.pose_D.p.x(), -rig.scale().halfTravel_m);
}

// A state: paused, actuators enabled, safety switch, override switch, power from bit 0 on, then the block's byte.
TEST(PidLink, ItsSafetySwitchIsTheGripAndNoReportOfTheHandForgetsIt)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const std::uint8_t id = test::plainLayout().stateId;
  rig.run(5);
  EXPECT_FALSE(rig.sample.grip);
  rig.stick().show({ id, 0b10110, 0 });
  ASSERT_TRUE(rig.device.link().readPass(0));
  ASSERT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_TRUE(rig.sample.grip);
  rig.run(5);
  EXPECT_TRUE(rig.sample.grip);
  rig.stick().show({ id, 0b10010, 0 });
  ASSERT_TRUE(rig.device.link().readPass(0));
  ASSERT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_FALSE(rig.sample.grip);
}

TEST(PidLink, ADeviceThatSaysItGivesNoForceNowIsBelieved)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const std::uint8_t id = test::plainLayout().stateId;
  rig.run(5);
  // A switch that was never on says nothing.
  for (const auto& [state, said] : { std::pair<std::uint8_t, std::string>{ 0b00010, "no power" }, { 0b10010, "" },
         { 0b10011, "paused" }, { 0b11010, "" }, { 0b10010, "switch" }, { 0b11010, "" } })
  {
    rig.stick().show({ id, state, 0 });
    ASSERT_TRUE(rig.device.link().readPass(0));
    const std::string message = rig.device.linkReport().message;
    EXPECT_TRUE(said.empty() ? message.empty() : message.find(said) != std::string::npos) << message;
  }
  rig.run(5);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
}

TEST(PidLink, AFeatureThatDoesNotComeInTimeIsSaidWithTheNameAndNothingStaysOpen)
{
  Rig rig(test::plainLayout());
  rig.port.featureTimesOut = true;
  const std::string problem = rig.device.open();
  EXPECT_TRUE(test::says(problem, { "\"plain stick\"", "device", "Connection" })) << problem;
  EXPECT_EQ(rig.port.opened, rig.port.closed);
  rig.port.featureTimesOut = false;
  EXPECT_EQ(rig.device.open(), "");
}

TEST(PidLink, WhatKeepsItFromOpeningAgainAfterALossIsSaidAndItComesBackWhenThatIsOver)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.port.present = false;
  rig.run(600);
  rig.port.present = true;
  rig.port.device = std::make_shared<test::VirtualPidDevice>(test::plainLayout());
  for (const auto& [set, said] : { std::pair<std::function<void(bool)>, std::string>{
                                     [&](bool on) { rig.port.openProblem = on ? "busy" : ""; }, "busy" },
         { [&](bool on) { rig.port.featureTimesOut = on; }, "timed out" } })
  {
    set(true);
    rig.run(600);
    EXPECT_EQ(rig.status, DeviceStatus::Lost);
    EXPECT_NE(rig.device.linkReport().message.find(said), std::string::npos);
    set(false);
  }
  rig.run(1100);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
}

TEST(PidLink, OfTwoAlikeWithoutSerialNumbersEachIsOpenedByItsPathAndTheOtherIsLeftAlone)
{
  auto bus = std::make_shared<FakeHidBus>();
  FakePort& first = bus->plug(test::plainLayout(), "");
  FakePort& second = bus->plug(test::plainLayout(), "");
  PidDevice device("pid", bus, second.entry, test::virtualOptions(*bus));
  ASSERT_EQ(device.open(), "");
  EXPECT_EQ(first.opened, 0);
  EXPECT_EQ(second.opened, 2); // one for the order to stop
}

/// The threads after the servo fell silent: the writer gets so many turns until the servo is back, and for so long
/// nothing of the device's answers is read. Then all is as before.
void comeBackAfterSilence(Rig& rig, int turns, int unread_ms)
{
  const auto write = [&]
  {
    if (!rig.device.link().writePass())
    {
      rig.bus->advance(1);
    }
  };
  const int stops = rig.stick().stopAlls;
  while (rig.stick().stopAlls == stops)
  {
    rig.pass();
  }
  for (int turn = 0; turn < turns; ++turn)
  {
    write();
  }
  const std::int64_t until_ns = rig.bus->time().now_ns() + unread_ms * std::int64_t{ 1000000 };
  while (rig.bus->time().now_ns() < until_ns)
  {
    rig.device.write(rig.command);
    write();
  }
  rig.run(100);
}

// The device reports each effect that the link stopped, and its reader may be late.
TEST(PidLink, ReportsOfItsOwnStopsThatAreReadLateAreNotTakenForAnotherProgram)
{
  for (const test::PidLayout& layout : { test::plainLayout(), test::openBoardLayout() })
  {
    for (int turns = 0; turns < 8; ++turns)
    {
      Rig rig(layout);
      ASSERT_EQ(rig.device.open(), "");
      rig.command.wrench_D.force.x() = 2.0;
      rig.run(200);
      comeBackAfterSilence(rig, turns, 25);
      EXPECT_EQ(rig.device.linkReport().losses, 0U) << layout.name << " after " << turns;
      EXPECT_GT(rig.stick().force()[0], 0.3) << layout.name << " after " << turns;
    }
  }
}

/// A device in real time under a force, whose output stalls: told to stop while the write still hangs.
struct Stalled
{
  Stalled()
  {
    EXPECT_EQ(this->device.open(), "");
    this->command.wrench_D.force.x() = 2.0;
    EXPECT_TRUE(test::eventually([&] { return this->tick(), this->force() > 0.3; }));
  }
  ~Stalled() { this->bus->release(this->port); }

  void tick()
  {
    this->bus->advance(1);
    this->lost = this->device.read(0.0, this->sample) == DeviceStatus::Lost || this->lost;
    this->device.write(this->command);
  }
  double force()
  {
    return this->bus->alone([this] { return this->port.device->force()[0]; });
  }
  int stops()
  {
    return this->bus->alone([this] { return this->port.device->stopAlls; });
  }
  int hanging()
  {
    return this->bus->alone([this] { return this->port.hanging; });
  }

  std::shared_ptr<FakeHidBus> bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::plainLayout());
  PidDevice device{ "pid", bus, port.entry };
  DeviceCommand command;
  DeviceSample sample;
  bool lost = false;
};

TEST(PidLink, ADeviceWhoseOutputHangsIsToldToStopBeforeTheWriteThatHangsEnds)
{
  Stalled rig;
  rig.bus->alone([&] { return rig.port.stalls = true; });
  // The write that hangs, and the order behind it.
  EXPECT_TRUE(test::eventually([&] { return rig.tick(), rig.hanging() == 2; }));
  EXPECT_TRUE(rig.lost);
  EXPECT_EQ(rig.device.linkReport().stalls, 1U);
  rig.command = {}; // as after any fault
  rig.tick();
  const int before = rig.stops();
  rig.bus->release(rig.port);
  EXPECT_TRUE(test::eventually([&] { return rig.tick(), rig.stops() > before && rig.force() == 0.0; }));
}

TEST(PidLink, TheForceOfADeviceThatTakesNothingAnyMoreEndsByItself)
{
  Stalled rig;
  rig.bus->alone([&] { return rig.port.stalls = true; });
  const int before = rig.stops();
  EXPECT_TRUE(test::eventually([&] { return rig.tick(), rig.lost && rig.force() == 0.0; }));
  EXPECT_EQ(rig.stops(), before);
}

} // namespace
} // namespace palpate
