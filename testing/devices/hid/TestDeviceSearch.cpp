// SPDX-License-Identifier: GPL-3.0-or-later
// A device that was lost is found again, and no other is taken for it.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using test::FakeHidBus;
using test::FakePort;
using Rig = test::PidRig;
using test::VirtualPidDevice;

TEST(DeviceSearch, OfTwoAlikeTheSerialNumberDecidesAndWithoutOneThePlace)
{
  FakeHidBus bus;
  FakePort& first = bus.plug(test::plainLayout(), "A");
  FakePort& second = bus.plug(test::plainLayout(), "B");
  HidEntry moved = second.entry;
  moved.path = "gone";
  EXPECT_EQ(DeviceSearch(moved).first(bus).entry->path, second.entry.path);
  first.entry.serial = second.entry.serial = "";
  HidEntry there = first.entry;
  EXPECT_EQ(DeviceSearch(there).first(bus).entry->path, first.entry.path);
  there.path = "gone";
  EXPECT_NE(DeviceSearch(there).first(bus).problem.find("cannot be distinguished"), std::string::npos);
}

/// Two sticks that look alike, one of them under force, the other somebody else's.
struct Twins : Rig
{
  explicit Twins(const std::string& serial)
    : Rig(test::plainLayout(), serial), other(this->bus->plug(test::plainLayout(), serial))
  {
    EXPECT_EQ(this->device.open(), "");
    this->command.wrench_D.force = { 2.0, 0.0, 0.0 };
    this->run(50);
    this->port.present = false;
    this->run(1000);
  }
  /// It was not reset, got no effects, was not even opened.
  void expectTheOtherUntouched() const
  {
    EXPECT_EQ(this->other.opened, 0);
    EXPECT_EQ(this->other.device->outputs, 0);
  }
  FakePort& other;
};

TEST(DeviceSearch, AStickThatIsUnpluggedDoesNotTakeItsTwin)
{
  for (const std::string serial : { "", "0001" })
  {
    Twins rig(serial);
    EXPECT_EQ(rig.status, DeviceStatus::Lost);
    rig.expectTheOtherUntouched();
    EXPECT_TRUE(test::says(rig.device.link().report().message, { "not attached" }));
    rig.port.present = true;
    rig.port.entry.path = "elsewhere";
    rig.run(1000);
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    rig.expectTheOtherUntouched();
  }
}

TEST(DeviceSearch, ATwinThatIsUnpluggedTooAndComesBackFirstIsNotTaken)
{
  Twins rig("");
  rig.other.present = false;
  rig.run(1000);
  std::swap(rig.other.entry.path, rig.port.entry.path);
  rig.other.present = true;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  rig.expectTheOtherUntouched();
  EXPECT_NE(rig.device.link().report().message.find("choose the device again"), std::string::npos);
}

TEST(DeviceSearch, ATwinThatCameWhileTheStickWasInUseIsNotTakenEither)
{
  Rig rig(test::plainLayout(), "");
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  const FakePort& late = rig.bus->plug(test::plainLayout(), "");
  rig.run(50);
  rig.port.present = false;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  EXPECT_EQ(late.opened, 0);
}

/// A stick that has just been found again after a loss.
struct FoundAgain : Rig
{
  explicit FoundAgain(const std::string& serial) : Rig(test::plainLayout(), serial)
  {
    EXPECT_EQ(this->device.open(), "");
    this->run(50);
    this->bounce("bounced");
    EXPECT_TRUE(this->runUntilFound());
  }
  void bounce(const std::string& path)
  {
    this->port.present = false;
    this->run(5);
    this->port.entry.path = path;
    this->port.device = std::make_shared<VirtualPidDevice>(test::plainLayout());
    this->port.present = true;
  }
  /// Looked for each half a second.
  bool runUntilFound()
  {
    for (int i = 0; i < 10 && !this->device.linkReport().attached; ++i)
    {
      this->run(100);
    }
    return this->device.linkReport().attached;
  }
};

TEST(DeviceSearch, ALoosePlugThatBouncesSoonAfterItWasFoundIsFoundInItsNewPlace)
{
  for (const std::string serial : { "", "0001" })
  {
    FoundAgain rig(serial);
    rig.bounce("bounced again");
    EXPECT_FALSE(rig.device.linkReport().attached);
    EXPECT_TRUE(rig.runUntilFound()) << serial << rig.device.linkReport().message;
    rig.run(5);
    EXPECT_EQ(rig.status, DeviceStatus::Ok) << serial;
  }
}

/// A search for a lost device that is in another place before anybody looks.
struct BackBeforeTheLook
{
  explicit BackBeforeTheLook(const std::string& serial)
    : port(this->bus.plug(test::plainLayout(), serial)), search(this->port.entry)
  {
    this->search.found(this->bus, this->port.entry);
  }
  [[nodiscard]] FoundDevice look()
  {
    this->search.lost(this->bus);
    return this->search.again(this->bus);
  }
  FakeHidBus bus;
  FakePort& port;
  DeviceSearch search;
};

TEST(DeviceSearch, ASerialNumberThatNoOtherOneHadTellsALostStickThatIsBackElsewhereBeforeTheFirstLook)
{
  BackBeforeTheLook own("0001");
  own.port.entry.path = "elsewhere";
  const FoundDevice found = own.look();
  ASSERT_TRUE(found.entry) << found.problem;
  EXPECT_EQ(found.entry->path, "elsewhere");
}

TEST(DeviceSearch, ASerialNumberThatAnotherOneHadOnceTellsNothing)
{
  BackBeforeTheLook twins("0001");
  FakePort& twin = twins.bus.plug(test::plainLayout(), "0001");
  twins.search.found(twins.bus, twins.port.entry);
  twin.present = false;
  twins.search.found(twins.bus, twins.port.entry);
  twins.port.present = false;
  twin.present = true;
  EXPECT_FALSE(twins.look().entry);
}

TEST(DeviceSearch, OneWithoutASerialNumberThatIsBackElsewhereBeforeTheFirstLookIsFoundWhenItIsPluggedInAnew)
{
  BackBeforeTheLook own("");
  own.port.entry.path = "elsewhere";
  EXPECT_NE(own.look().problem.find("plug"), std::string::npos);
  own.port.present = false;
  EXPECT_FALSE(own.look().entry);
  own.port.present = true;
  EXPECT_TRUE(own.look().entry);
}

// Such as one that has keys as well: the parts come and go together.
TEST(DeviceSearch, AnotherPartOfTheSamePlugIsNoTwin)
{
  Rig rig(test::plainLayout(), "");
  FakePort& keys = rig.bus->plug(test::hobbyLayout(), "");
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.port.present = keys.present = false;
  rig.run(1000);
  rig.port.entry.path = "elsewhere";
  keys.entry.path = "elsewhere too";
  rig.port.present = keys.present = true;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(keys.opened, 0);
}

} // namespace
} // namespace palpate
