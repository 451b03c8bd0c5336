// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/evdev/EvdevInput.h"
#include "testing/devices/evdev/FakeEvdevBus.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// A stick whose events are read as they come.
struct Reading
{
  explicit Reading(const EvdevTraits& traits)
    : port(bus.plug(traits)), connection(bus.open(port.entry).value),
      input(evdevKind(traits, port.entry), *connection)
  {
  }

  /// Reads the waiting events; how many reports have ended.
  int read()
  {
    std::array<input_event, 64> events;
    const int count = this->connection->read(events, 0);
    int ended = 0;
    for (int i = 0; i < count; ++i)
    {
      ended += this->input.take(events[static_cast<std::size_t>(i)]) ? 1 : 0;
    }
    return ended;
  }

  test::FakeEvdevBus bus;
  test::FakeEvdevPort& port;
  std::unique_ptr<EvdevConnection> connection;
  EvdevInput input;
};

TEST(EvdevInput, SharesRunFromEndToEndOfWhateverRangeAnAxisHas)
{
  test::Random random(test::testSeed(3));
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    Reading stick(test::stickTraits());
    const int least = static_cast<int>(random.below(70000)) - 40000;
    const int greatest = least + 1 + static_cast<int>(random.below(70000));
    stick.port.axes[ABS_X] = { 0, least, greatest, 0, 0, 0 };
    ASSERT_EQ(stick.input.begin(), "");
    const int at = least + static_cast<int>(random.below(static_cast<std::uint32_t>(greatest - least + 1)));
    stick.port.say(EV_ABS, ABS_X, at);
    stick.port.end();
    ASSERT_EQ(stick.read(), 1);
    const double expected = -1.0 + 2.0 * (at - least) / (greatest - least);
    EXPECT_NEAR(stick.input.hand()->at[0], expected, 1e-12);
    EXPECT_NEAR(stick.input.step(), 2.0 / (greatest - least), 1e-12);
  }
}

TEST(EvdevInput, AnAxisWithoutARangeIsRefused)
{
  Reading stick(test::stickTraits());
  stick.port.axes[ABS_Y] = {};
  EXPECT_NE(stick.input.begin().find("range for the axis 1"), std::string::npos);
}

// Before a device has said anything the kernel has 0 for every axis: an end, for most.
TEST(EvdevInput, WhereTheHandIsIsNotKnownBeforeTheDeviceHasSaidSo)
{
  Reading silent(test::wheelTraits());
  silent.port.axes[ABS_X] = { 0, 0, 65535, 0, 0, 0 };
  ASSERT_EQ(silent.input.begin(), "");
  EXPECT_FALSE(silent.input.hand());
  silent.port.say(EV_KEY, BTN_TRIGGER, 1);
  silent.port.end();
  EXPECT_EQ(silent.read(), 1);
  EXPECT_FALSE(silent.input.hand());
  Reading moved(test::wheelTraits());
  moved.port.axes[ABS_X] = { 32768, 0, 65535, 0, 0, 0 };
  ASSERT_EQ(moved.input.begin(), "");
  ASSERT_TRUE(moved.input.hand());
  EXPECT_NEAR(moved.input.hand()->at[0], 0.0, 1.0 / 65535.0);
}

TEST(EvdevInput, PedalsAreNoPartOfTheHandOnAWheel)
{
  Reading wheel(test::wheelTraits());
  wheel.port.entry.product = 0xC24F;
  EvdevInput input(evdevKind(wheel.port.traits, wheel.port.entry), *wheel.connection);
  ASSERT_EQ(input.begin(), "");
  input_event pedal{};
  pedal.type = EV_ABS;
  pedal.code = ABS_Y;
  pedal.value = 20000;
  EXPECT_FALSE(input.take(pedal));
  EXPECT_FALSE(input.hand());
  pedal.code = ABS_X;
  EXPECT_FALSE(input.take(pedal));
  EXPECT_EQ(input.hand()->at[1], 0.0);
}

TEST(EvdevInput, ButtonsAreCountedInTheOrderOfTheirCodes)
{
  Reading stick(test::traitsWith({ ABS_X, ABS_Y }, { KEY_ENTER, BTN_THUMB, BTN_TRIGGER_HAPPY3 }, { FF_CONSTANT }));
  ASSERT_EQ(stick.input.begin(), "");
  stick.port.move(ABS_X, 0.1);
  stick.port.say(EV_KEY, BTN_TRIGGER_HAPPY3, 1);
  stick.port.end();
  EXPECT_EQ(stick.read(), 2);
  EXPECT_EQ(stick.input.hand()->buttons, 2u);
  stick.port.say(EV_KEY, BTN_THUMB, 1);
  stick.port.say(EV_KEY, BTN_TRIGGER_HAPPY3, 0);
  stick.port.say(EV_KEY, KEY_ENTER, 1);
  stick.port.end();
  EXPECT_EQ(stick.read(), 1);
  EXPECT_EQ(stick.input.hand()->buttons, 1u);
}

// After SYN_DROPPED everything up to the next SYN_REPORT is to be ignored and the state to be asked for
// (Documentation/input/event-codes.rst).
TEST(EvdevInput, WhatTheKernelHadToDropIsAskedFor)
{
  Reading stick(test::stickTraits());
  ASSERT_EQ(stick.input.begin(), "");
  stick.port.move(ABS_X, 0.5);
  ASSERT_EQ(stick.read(), 1);
  stick.port.say(EV_SYN, SYN_DROPPED, 0);
  stick.port.say(EV_ABS, ABS_X, -32768);
  stick.port.end();
  stick.port.axes[ABS_X].value = 32767;
  stick.port.keys.set(BTN_TOP);
  EXPECT_EQ(stick.read(), 1);
  EXPECT_NEAR(stick.input.hand()->at[0], 1.0, 1e-12);
  EXPECT_EQ(stick.input.hand()->buttons, 4u);
}

TEST(EvdevInput, APlaceBeyondTheRangeIsCutToItAndSaid)
{
  Reading stick(test::stickTraits());
  ASSERT_EQ(stick.input.begin(), "");
  for (const int beyond : { 40000, -40000, 32767 })
  {
    stick.port.say(EV_ABS, ABS_Y, beyond);
    stick.port.end();
    ASSERT_EQ(stick.read(), 1);
    EXPECT_EQ(stick.input.hand()->at[1], beyond > 0 ? 1.0 : -1.0);
    EXPECT_EQ(stick.input.hand()->outOfRange, beyond != 32767);
  }
}

// Bytes of a device are not to be trusted, whatever the kernel makes of them.
TEST(EvdevInput, AnyEventsLeaveAHandWithinItsRange)
{
  test::Random random(test::testSeed(11));
  Reading stick(test::stickTraits());
  ASSERT_EQ(stick.input.begin(), "");
  for (std::size_t i = 0; i < test::testCount(2000); ++i)
  {
    input_event event{};
    event.type = static_cast<std::uint16_t>(random.below(4) == 0 ? random.next() : random.below(6));
    event.code = static_cast<std::uint16_t>(random.below(2) == 0 ? random.next() : random.below(4));
    event.value = static_cast<std::int32_t>(random.next());
    static_cast<void>(stick.input.take(event));
    const std::optional<PidHand> hand = stick.input.hand();
    for (const std::size_t axis : { 0U, 1U })
    {
      EXPECT_TRUE(!hand || std::abs(hand->at[axis]) <= 1.0);
    }
  }
}

} // namespace
} // namespace palpate
