// SPDX-License-Identifier: GPL-3.0-or-later
// A device that goes and comes back: its last command, the program that throws it away, and the place of the hand then.
#include <future>

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

/// A device under force that cannot be opened again once it is lost.
struct UnderForce : Rig
{
  UnderForce() : Rig(test::plainLayout())
  {
    EXPECT_EQ(this->device.open(), "");
    this->command.wrench_D.force = { 2.0, 0.0, 0.0 };
    this->run(50);
    EXPECT_GT(this->stick().force()[0], 0.3);
    this->port.openProblem = "busy";
    this->command.wrench_D.force = { 2.5, 0.0, 0.0 };
    this->device.write(this->command); // for the next pass
  }
};

// The write that fails, one more that fails on the same connection, then the other connection.
TEST(PidLoss, ADeviceThatIsLostForWhatItDoesNotTakeIsToldToStopOverEitherConnection)
{
  for (const int failing : { 1, 2 })
  {
    UnderForce rig;
    rig.port.writesThatFail = failing;
    rig.pass();
    EXPECT_FALSE(rig.device.linkReport().attached);
    EXPECT_EQ(rig.stick().stopAlls, 1 + 1) << failing; // once when it was opened
    EXPECT_EQ(rig.stick().force()[0], 0.0) << failing;
  }
}

TEST(PidLoss, ADeviceThatTellsNothingAnyMoreIsToldToStop)
{
  UnderForce rig;
  rig.port.readFails = true;
  rig.pass();
  EXPECT_FALSE(rig.device.linkReport().attached);
  EXPECT_EQ(rig.stick().stopAlls, 1 + 1);
  EXPECT_EQ(rig.stick().force()[0], 0.0);
}

/// A device under force whose writes really hang; a pass that hangs stays on a thread of its own.
struct Hanging
{
  Hanging()
  {
    EXPECT_EQ(this->device.open(), "");
    this->command.wrench_D.force.x() = 2.0;
    for (int ms = 0; ms < 50; ++ms)
    {
      this->device.write(this->command);
      this->bus->advance(1);
      static_cast<void>(this->device.link().readPass(0));
      static_cast<void>(this->device.link().writePass());
    }
    EXPECT_GT(this->stick().force()[0], 0.3);
    EXPECT_EQ(this->device.read(0.0, this->sample), DeviceStatus::Ok);
  }
  ~Hanging() { this->bus->release(this->port); }

  test::VirtualPidDevice& stick() { return *this->port.device; }
  /// Lets a pass run until it hangs, with so many writes in all.
  template<class Pass>
  std::future<bool> hang(int writes, Pass pass)
  {
    this->bus->alone([this] { return this->port.stalls = true; });
    std::future<bool> hanging = std::async(std::launch::async, pass);
    const auto hangs = [&] { return this->bus->alone([this] { return this->port.hanging; }) == writes; };
    EXPECT_TRUE(test::eventually(hangs));
    return hanging;
  }
  std::future<bool> hangingRead(int writes)
  {
    return this->hang(writes, [this] { return this->device.link().readPass(0); });
  }
  std::future<bool> hangingWrite(int writes)
  {
    return this->hang(writes, [this] { return this->device.link().writePass(); });
  }

  std::shared_ptr<FakeHidBus> bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::plainLayout());
  PidDevice device{ "pid", bus, port.entry, test::virtualOptions(*bus) };
  DeviceCommand command;
  DeviceSample sample;
};

TEST(PidLoss, TheServoKnowsThatTheForcesWereTakenAwayWhileTheOrderToStopHangs)
{
  Hanging rig;
  ASSERT_TRUE(rig.stick().take(HidReportKind::Output, std::vector<std::uint8_t>{ 0x1C, 2 })); // somebody disables it
  ASSERT_TRUE(rig.device.link().readPass(0));
  const std::future<bool> writer = rig.hangingWrite(1);
  EXPECT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Lost);
  rig.bus->release(rig.port);
}

TEST(PidLoss, TheServoKnowsThatNothingIsReadAnyMoreWhileTheOrderToStopHangs)
{
  Hanging rig;
  rig.port.readFails = true;
  const std::future<bool> reader = rig.hangingRead(1);
  EXPECT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Lost);
  rig.bus->release(rig.port);
}

// A write may take 50 ms. A hung write ends afterwards, and then the device says that its effects have stopped.
TEST(PidLoss, ADeviceThatWasToldToStopBecauseAWriteHungIsNotSaidToBeTakenByAnotherProgram)
{
  Hanging rig;
  rig.command.wrench_D.force.x() = 2.5;
  rig.device.write(rig.command);
  std::future<bool> writer = rig.hangingWrite(1);
  rig.bus->advance(51);
  std::future<bool> reader = rig.hangingRead(2);
  rig.bus->release(rig.port);
  EXPECT_TRUE(writer.get());
  EXPECT_TRUE(reader.get());
  ASSERT_TRUE(rig.device.linkReport().attached);
  ASSERT_TRUE(rig.device.link().readPass(0));
  EXPECT_TRUE(rig.device.link().writePass());
  const LinkReport report = rig.device.linkReport();
  EXPECT_FALSE(report.attached);
  EXPECT_NE(report.message.find("too late"), std::string::npos) << report.message;
}

// The order would stop the one that was found meanwhile: it is the same device, behind another connection.
TEST(PidLoss, NoDeviceIsFoundAgainWhileTheOrderToStopIsOnItsWay)
{
  Hanging rig;
  rig.port.readFails = true;
  std::future<bool> reader = rig.hangingRead(1);
  EXPECT_FALSE(rig.device.link().writePass());
  EXPECT_EQ(rig.port.opened, 2);
  rig.bus->release(rig.port);
  EXPECT_FALSE(reader.get());
  EXPECT_FALSE(rig.device.link().writePass());
  EXPECT_TRUE(rig.device.linkReport().attached);
}

TEST(PidLoss, AReadThatHasWaitedOnTheDeviceBeforeLeavesTheOneThatWasFoundAgainAlone)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.device.write(rig.command);
  rig.port.writesThatFail = 1;
  PidLink& link = rig.device.link();
  int told = 0;
  rig.port.whileReading = [&]
  {
    static_cast<void>(link.writePass());
    ASSERT_FALSE(link.report().attached);
    static_cast<void>(link.writePass());
    ASSERT_TRUE(link.report().attached);
    told = rig.stick().stopAlls;
  };
  static_cast<void>(link.readPass(0));
  EXPECT_TRUE(link.report().attached);
  EXPECT_EQ(link.report().losses, 1U);
  EXPECT_EQ(rig.stick().stopAlls, told);
}

TEST(PidLoss, TheHandIsWhereItIsFromTheFirstTickOn)
{
  Rig rig(test::plainLayout());
  rig.stick().position = { 0.5, 0.0 };
  ASSERT_EQ(rig.device.open(), "");
  ASSERT_EQ(rig.device.read(0.0, rig.sample), DeviceStatus::Ok);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), 0.5 * rig.scale().halfTravel_m, 1e-5);
}

TEST(PidLoss, WhereTheHandIsIsNotKnownBeforeTheDeviceSaysSo)
{
  Rig rig(test::adapterLayout()); // the host closes walls, at the place where the hand is
  rig.stick().position = { -0.5, 0.0 };
  rig.stick().silent = true;
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wallCount = 1;
  rig.command.walls[0] = { Vec3::UnitX(), 0.01, 40.0 }; // in front of a hand in the middle
  rig.run(1500);
  EXPECT_EQ(rig.status, DeviceStatus::Waiting);
  EXPECT_EQ(rig.lostTicks, 0);
  EXPECT_EQ(rig.stick().force()[0], 0.0);
  EXPECT_NE(rig.device.linkReport().message.find("move the handle"), std::string::npos);
  rig.stick().silent = false;
  rig.run(5);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  // Before it was opened its own spring moved it a little.
  const double truth_m = rig.stick().position[0] * rig.scale().halfTravel_m;
  EXPECT_LT(truth_m, -0.4 * rig.scale().halfTravel_m);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), truth_m, rig.device.info().resolution_m.value);
  EXPECT_EQ(rig.device.linkReport().message, "");
}

TEST(PidLoss, AHandThatMovedWhileItsDeviceWasGoneIsNotWhereItWas)
{
  Rig rig(test::plainLayout());
  rig.stick().position = { 0.2, 0.0 };
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.port.present = false;
  rig.run(100);
  rig.port.device = std::make_shared<test::VirtualPidDevice>(test::plainLayout());
  rig.stick().position = { -0.6, 0.0 };
  rig.stick().silent = true;
  rig.port.present = true;
  rig.run(1500);
  EXPECT_TRUE(rig.device.linkReport().attached);
  EXPECT_EQ(rig.status, DeviceStatus::Waiting);
  EXPECT_GT(rig.lostTicks, 0); // so the loss was latched, before
  EXPECT_TRUE(test::says(rig.device.linkReport().lostFor, { "unplugged" }));
  rig.stick().silent = false;
  rig.run(5);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), -0.6 * rig.scale().halfTravel_m, 1e-5);
}

// A write that hangs is looked for after each read: 50 ms that a write may take, and one read more.
TEST(PidLoss, NoReadWaitsSoLongThatAWriteThatHangsIsNoticedLate)
{
  auto bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::plainLayout());
  PidDevice device("pid", bus, port.entry);
  ASSERT_EQ(device.open(), "");
  EXPECT_TRUE(test::eventually([&] { return bus->advance(1), device.linkReport().inputs > 1; }));
  device.close();
  EXPECT_LE(port.longestRead_ms, 20);
}

// Two forces, a spring, a damper and a shake make five effects.
TEST(PidLoss, ADeviceThatComesBackWithoutRoomForItsWallsOrTheirViscosityStaysLost)
{
  for (const auto& [slots, lack] : { std::pair<int, std::string>{ 2, "walls" }, { 3, "viscosity" } })
  {
    Rig rig(test::plainLayout());
    ASSERT_EQ(rig.device.open(), "");
    rig.port.present = false;
    rig.run(100);
    test::PidLayout small = test::plainLayout();
    small.slots = slots;
    rig.port.device = std::make_shared<test::VirtualPidDevice>(small);
    rig.port.present = true;
    rig.run(1500);
    EXPECT_EQ(rig.status, DeviceStatus::Lost) << slots;
    EXPECT_NE(rig.device.linkReport().message.find("came back without " + lack), std::string::npos) << slots;
    EXPECT_EQ(rig.stick().effectsUsed(), 0) << slots;
    small.slots = 4; // no effect that holds a hand is missing
    rig.port.device = std::make_shared<test::VirtualPidDevice>(small);
    rig.run(1500);
    EXPECT_EQ(rig.status, DeviceStatus::Ok) << slots;
  }
}

TEST(PidLoss, WhatADeviceCanDoIsKnownOnceItIsOpen)
{
  test::PidLayout small = test::plainLayout();
  small.slots = 2; // two forces, and no slot for a spring
  Rig rig(small);
  ASSERT_TRUE(rig.device.info().abilities.holdsWalls);
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_EQ(rig.device.info().abilities, (DeviceAbilities{ 2, false, false, false }));
}

} // namespace
} // namespace palpate
