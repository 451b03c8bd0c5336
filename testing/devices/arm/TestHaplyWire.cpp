// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the service and the link that carries them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/arm/ServiceLine.h"
#include "devices/arm/link/WebSocketLink.h"
#include "devices/arm/protocol/HaplyServiceWire.h"
#include "testing/devices/arm/FakeService.h"
#include "testing/support/Eventually.h"

namespace palpate
{
namespace
{

using test::FakeService;

TEST(WebSocketLink, SaysThatTheProgramAtTheOtherEndHasLetGo)
{
  FakeService service;
  const LoopbackSocket socket = openLoopbackSocket(service.port(), 1000);
  ASSERT_NE(socket.link, nullptr) << socket.problem;
  WireBytes bytes(65536);
  ASSERT_GT(socket.link->receive(bytes, 10000), 0) << "the inventory";
  FakeService::Says says;
  says.answer = FakeService::Says::Answer::Closes;
  service.say(says);
  const std::string order = "{\"inverse3\":[{\"commands\":{}}]}";
  ASSERT_TRUE(socket.link->send({ reinterpret_cast<const std::uint8_t*>(order.data()), order.size() }));
  EXPECT_EQ(socket.link->receive(bytes, 10000), -1);
  EXPECT_THAT(socket.link->gone(), testing::HasSubstr("does not hold the connection"));
  EXPECT_FALSE(socket.link->send({ bytes.data(), 1 }));
  EXPECT_THAT(socket.link->unsent(), testing::HasSubstr("does not hold the connection"));
}

// The layouts differ: a wireless grip's values stand below "state", a wired one's beside its name.
TEST(HaplyServiceWire, TellsTurnAndButtonOfAGripWithAndWithoutAState)
{
  const HaplyServiceWire wire("049D", true);
  const std::string arm =
    R"("inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.0,"y":0.0,"z":0.0}},"status":{}}])";
  const std::string values = R"("button":true,"orientation":{"w":0.0,"x":1.0,"y":0.0,"z":0.0})";
  for (const std::string& grip : { "{" + values + "}", R"({"state":{)" + values + "}}" })
  {
    const std::string text = "{" + arm + R"(,"verse_grip":[)" + grip + "]}";
    const auto reading = wire.decode({ reinterpret_cast<const std::uint8_t*>(text.data()), text.size() });
    ASSERT_TRUE(reading && reading->pose_D) << text;
    EXPECT_EQ(reading->buttons, 1U) << text;
    EXPECT_EQ(reading->pose_D->q.coeffs(), Quat(0.0, 1.0, 0.0, 0.0).coeffs()) << text;
  }
}

TEST(HaplyServiceWire, TakesNoReadingFromAMessageOfOthersAndPassesItOver)
{
  const HaplyServiceWire wire("049D", true, Vec3::Zero(), "7");
  const auto bytes = [](const std::string& text)
  { return std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()); };
  for (const std::string& other : FakeService::messagesOfOthers())
  {
    EXPECT_FALSE(wire.decode(bytes(other))) << other;
    EXPECT_TRUE(wire.isOthers(bytes(other))) << other;
  }
  const std::string own = FakeService::stateOf("049D", 7, Vec3::UnitX());
  EXPECT_TRUE(wire.decode(bytes(own)));
  EXPECT_FALSE(wire.isOthers(bytes(own)));
  // A state of this device that makes no sense, and half a message, are wrong answers.
  for (const std::string wrong : { R"({"inverse3":[{"device_id":"049D","state":{}}]})", "{\"inverse3\":[" })
  {
    EXPECT_FALSE(wire.decode(bytes(wrong))) << wrong;
    EXPECT_FALSE(wire.isOthers(bytes(wrong))) << wrong;
  }
  EXPECT_EQ(haplySession(own), "7");
  EXPECT_EQ(haplySession("{}"), "");
  const HaplyServiceWire unknown("049D", true);
  EXPECT_TRUE(unknown.decode(bytes(own))) << "a service that names no session at first";
  const std::string unnamed = R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0,"y":0,"z":0}}}]})";
  EXPECT_TRUE(wire.decode(bytes(unnamed))) << "or names it no more";
}

/// A channel that has another message whenever it is looked at, for a million looks.
class FloodedLink final : public ByteLink
{
public:
  explicit FloodedLink(int& looks) : looks_(looks) {}
  bool send(std::span<const std::uint8_t> /*bytes*/) noexcept override { return true; }
  int receive(std::span<std::uint8_t> bytes, int /*timeout_ms*/) noexcept override
  {
    bytes[0] = ' ';
    return ++this->looks_ < 1000000 ? 1 : 0;
  }
  std::string error() const override { return ""; }
  bool keepsBorders() const noexcept override { return true; }

private:
  int& looks_;
};

TEST(ServiceLine, GoesOnToTheForceDuringAFloodOfEvents)
{
  FakeService service;
  LoopbackSocket states = openLoopbackSocket(service.port(), 1000);
  ASSERT_NE(states.link, nullptr) << states.problem;
  auto wire = std::make_unique<WireLine>(
    std::move(states.link), std::make_shared<HaplyServiceWire>("049D", true, Vec3(Vec3::Zero()), ""));
  int looks = 0;
  ServiceLine line(std::move(wire), std::make_unique<FloodedLink>(looks), [](std::string_view) { return ""; });
  WireOrder order;
  order.wrench_D.force = { 0.0, 0.0, 1.0 };
  static_cast<void>(line.exchange(order, 1000));
  EXPECT_LT(looks, 1000) << "an exchange looks at a bounded number of events";
  EXPECT_TRUE(test::eventually([&] { return service.force_N() == Vec3(0.0, 0.0, 1.0); }));
}

TEST(HaplyServiceWire, TellsTheVersionWhateverStandsAroundIt)
{
  EXPECT_EQ(haplyHasVector("{\"version\":\"3.1.4\"}"), std::optional(false));
  EXPECT_EQ(haplyHasVector("v3.5"), std::optional(true));
  EXPECT_EQ(haplyHasVector("{\"name\":\"service\",\"version\":\"3.10.2\"}"), std::optional(true));
  EXPECT_EQ(haplyHasVector("4.0.0"), std::optional(true));
  EXPECT_EQ(haplyHasVector(R"({"api":"3.0","version":"3.5.1"})"), std::optional(true));
  EXPECT_EQ(haplyHasVector(R"({"api":"3.5","version":"3.1.4"})"), std::optional(false));
  EXPECT_EQ(haplyHasVector("2.9.0"), std::optional(false));
  EXPECT_EQ(haplyHasVector("no version"), std::nullopt);
  EXPECT_EQ(haplyHasVector(""), std::nullopt);
}

} // namespace
} // namespace palpate
