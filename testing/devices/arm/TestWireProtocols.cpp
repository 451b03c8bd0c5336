// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of each wire are those that its facts say, by hand.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/arm/kit/Kits.h"
#include "devices/arm/protocol/FalconWire.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "devices/arm/protocol/WireNumbers.h"
#include "devices/arm/protocol/WoodenHapticsWire.h"

namespace palpate
{
namespace
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

std::string hexOf(const WireBytes& bytes)
{
  std::string hex;
  for (const std::uint8_t byte : bytes)
  {
    constexpr const char* digits = "0123456789abcdef";
    hex += digits[byte >> 4];
    hex += digits[byte & 15];
  }
  return hex;
}

std::string textOf(const WireBytes& bytes)
{
  return { bytes.begin(), bytes.end() };
}

WireBytes encoded(const WireProtocol& wire, const WireOrder& order)
{
  WireBytes bytes{ 1, 2, 3 };
  wire.encode(order, bytes);
  return bytes;
}

WireBytes bytesOf(const std::string& text)
{
  return { text.begin(), text.end() };
}

TEST(WoodenHapticsWire, SendsMilliamperesAndTheCountersThatAreSet)
{
  const WoodenHapticsWire wire({ 0.1, 0.2, 0.5 }, true);
  WireOrder order;
  order.motor_Nm = { 0.015, -0.06, 1.0 }; // 150, -300, 2000 mA
  EXPECT_EQ(hexOf(encoded(wire, order)), "9600d4fed0070000000000000000");
  order.counters = { { 0, 0, 6000, 0, 0, 0 } };
  EXPECT_EQ(hexOf(encoded(wire, order)), "0000000000000100000000007017") << "without current";
}

TEST(WoodenHapticsWire, SendsNoCurrentForWhatIsNoNumberAndAtMostTwoAmperes)
{
  const WoodenHapticsWire wire({ 0.1, 0.2, 0.5 }, true);
  WireOrder order;
  order.motor_Nm = { notANumber, 1e300, -std::numeric_limits<double>::infinity() };
  EXPECT_EQ(hexOf(encoded(wire, order)), "0000d00700000000000000000000");
}

TEST(WoodenHapticsWire, TellsCountsTheGripAndTheButtonOfCalibration)
{
  const WoodenHapticsWire wire({ 1.0, 1.0, 1.0 }, true);
  WireBytes report;
  for (const int word : { -1, 32767, -32768, 10123, 5, 6, 1 })
  {
    put16(report, static_cast<std::int16_t>(word));
  }
  const std::optional<WireReading> reading = wire.decode(report);
  ASSERT_TRUE(reading);
  const std::array<double, 6> counts{ -1, 32767, -32768, 123, 5, 6 };
  EXPECT_EQ(reading->encoder, counts);
  EXPECT_TRUE(reading->grip && reading->calibrated && reading->homed);
  const WoodenHapticsWire ofJoints({ 1.0, 1.0, 1.0 }, false);
  EXPECT_EQ(ofJoints.decode(report)->encoder[3], 10123.0) << "the fourth counter is that of a joint";
  EXPECT_FALSE(ofJoints.decode(report)->grip);
  report.pop_back();
  EXPECT_FALSE(wire.decode(report));
}

TEST(FalconWire, SendsMotorsAndKeepsHoming)
{
  const FalconWire wire;
  EXPECT_EQ(textOf(encoded(wire, {})), "<AAAAAAAAAAAADA>");
  WireOrder order;
  order.joint_Nm = { -0.1, 0.1, -0.4096 }; // 1000, -1000, 4096
  EXPECT_EQ(textOf(encoded(wire, order)), "<IODAIBMPAAABDA>");
  order.joint_Nm = { notANumber, 1.0, -1.0 };
  EXPECT_EQ(textOf(encoded(wire, order)), "<AAAAAAAPAAABDA>") << "-4096 and 4096 at most";
}

TEST(FalconWire, TellsCountsButtonsAndWhetherAllThreeMotorsAreHomed)
{
  const FalconWire wire;
  std::optional<WireReading> reading = wire.decode(bytesOf("<IODAIBMPAAABFA>"));
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->encoder, (std::array<double, 6>{ 1000, -1000, 4096, 0, 0, 0 }));
  EXPECT_EQ(reading->buttons, 5U);
  EXPECT_FALSE(reading->homed);
  std::string homed = "<AAAAAAAAAAAAAA>";
  for (int motors = 0; motors < 8; ++motors)
  {
    homed[13] = static_cast<char>(0x41 + (motors << 4));
    reading = wire.decode(bytesOf(homed));
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->homed, motors == 7) << motors;
  }
}

TEST(FalconWire, FindsThePacketBehindTheRestOfAnother)
{
  const FalconWire wire;
  const std::string packet = "<AAAAAAAAAAAAAA>", before = "AAA><AA";
  const WireFrame frame = wire.frame(bytesOf(before + packet));
  EXPECT_EQ(frame.skip, before.size());
  EXPECT_EQ(frame.length, packet.size());
  EXPECT_EQ(wire.frame(bytesOf(packet.substr(0, 15))).length, 0U);
  for (const std::size_t at : { 1U, 12U, 13U })
  {
    std::string wrong = packet;
    wrong[at] = '@';
    EXPECT_FALSE(wire.decode(bytesOf(wrong))) << at;
  }
}

TEST(TwoDiyWire, SendsTorquesAndItsOff)
{
  const TwoDiyWire wire(boardOf(twoDiyArm()));
  WireOrder order;
  EXPECT_EQ(hexOf(encoded(wire, order)), "02050000000000000000");
  order.joint_Nm = { 0.05, -0.02, 7.0 };
  EXPECT_EQ(hexOf(encoded(wire, order)), "0205cdcc4c3d0ad7a3bc");
  order.joint_Nm = { notANumber, 5.0, 0.0 };
  WireBytes limited{ 2, 5, 0, 0, 0, 0 };
  putFloat(limited, 0.123F);
  EXPECT_EQ(hexOf(encoded(wire, order)), hexOf(limited));
}

TEST(TwoDiyWire, SetsTheBoardUpBeforeAnythingElse)
{
  TwoDiyWire::Setup setup = boardOf(twoDiyArm());
  setup.motorTurned = { 1, 0 };
  // set-up, device 5; motors on ports 1 and 2, the first turned round; encoders likewise, none turned; no sensor, no
  // PWM; 180 degrees (0x43340000), 13824 counts (0x46580000), 0 degrees, 13824 counts.
  EXPECT_EQ(hexOf(TwoDiyWire(setup).greeting()), "01050301000300000000"
                                                 "00003443"
                                                 "00005846"
                                                 "00000000"
                                                 "00005846");
}

TEST(TwoDiyWire, SendsTheTorqueOfMotorsBehindGearsOneOfThemReversed)
{
  TwoDiyWire::Setup setup = boardOf(twoDiyArm());
  setup.gear = { 2.0, -4.0 };
  WireOrder order;
  order.joint_Nm = { 0.1, 0.08, 0.0 };
  // 0.05 and -0.02 N m
  EXPECT_EQ(hexOf(encoded(TwoDiyWire(setup), order)), "0205cdcc4c3d0ad7a3bc");
}

TEST(TwoDiyWire, TellsDegreesAndRefusesWhatIsNone)
{
  const TwoDiyWire wire(boardOf(twoDiyArm()));
  WireBytes answer{ 5 };
  putFloat(answer, 140.25F);
  putFloat(answer, -40.5F);
  const std::optional<WireReading> reading = wire.decode(answer);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->encoder[0], 140.25);
  EXPECT_EQ(reading->encoder[1], -40.5);
  WireBytes other{ 5 };
  putFloat(other, std::numeric_limits<float>::quiet_NaN());
  putFloat(other, 0.0F);
  EXPECT_FALSE(wire.decode(other));
  answer[0] = 3;
  EXPECT_FALSE(wire.decode(answer)) << "another device";
  EXPECT_EQ(wire.frame(answer).length, 0U);
}

} // namespace
} // namespace palpate
