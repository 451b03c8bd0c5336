// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain of an arm behind a vendor's service, against a service that is made up, on this computer.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/ArmDevice.h"
#include "devices/arm/ServiceLine.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/WebSocketLink.h"
#include "devices/arm/protocol/HaplyServiceWire.h"
#include "devices/common/LinkNotes.h"
#include "haptics/core/Fault.h"
#include "testing/devices/arm/HaplyRig.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Eventually.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::FakeService;
using test::HaplyRig;
using Answers = FakeService::Says::Answer;

TEST(HaplyService, IsListedByItsOwnNumberAndToldNothing)
{
  HaplyRig rig;
  const std::vector<ArmKit> kits{ rig.kit };
  const std::vector<FoundArm> found = findArms(kits);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].entry.serial, "049D");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(rig.service.messages(), 0);
}

TEST(HaplyService, ThatIsInstalledAndSilentIsToldOfAndOneThatIsNotThereIsNot)
{
  HaplyPorts ports{ 1, 1, 1, "/nowhere" };
  const std::vector<ArmKit> none{ haplyKit(ports) };
  EXPECT_TRUE(findArms(none).empty());
  ports.installed = "/";
  const std::vector<ArmKit> silent{ haplyKit(ports) };
  const std::vector<FoundArm> found = findArms(silent);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].problem, testing::HasSubstr("start haply-inverse-service"));
}

TEST(HaplyService, IsNamedTheProgramAndSetToIdentityAndAppliesTheForceThatIsAsked)
{
  for (const char* const version : { "3.0.1", "3.1.4", "3.4.9", "3.5.2", "3.10.0" })
  {
    HaplyRig rig;
    rig.says.version = version;
    rig.service.say(rig.says);
    ASSERT_EQ(rig.device.open(), "") << version;
    const Vec3 force_N(0.5, -1.25, 2.0);
    ask(rig, force_N, 5);
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    EXPECT_EQ(rig.service.programsName(), "Palpate");
    EXPECT_TRUE(rig.service.transformIsIdentity());
    EXPECT_EQ(rig.service.force_N(), force_N) << version;
  }
}

TEST(HaplyService, TellsPlaceVelocityTurnAndButtons)
{
  HaplyRig rig;
  rig.says.turn = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()));
  rig.says.buttons = 5;
  rig.service.say(rig.says);
  ASSERT_EQ(rig.device.open(), "");
  rig.run(5);
  EXPECT_LT((rig.sample.pose_D.p - (rig.says.position_m - Vec3(0.0, -0.12, 0.15))).norm(), 1e-12);
  EXPECT_LT(rig.sample.pose_D.q.angularDistance(rig.says.turn), 1e-9);
  EXPECT_EQ(rig.sample.velocity_D.linear, Vec3(0.0, 0.02, 0.0));
  EXPECT_EQ(rig.sample.buttons, 5U);
}

TEST(HaplyService, CountsPlacesFromTheMiddleOfTheWorkSpaceAlsoWhereTheServiceDoes)
{
  HaplyRig rig;
  rig.says.preset = "arm_front_centered";
  rig.service.say(rig.says);
  ASSERT_EQ(rig.device.open(), "");
  rig.run(5);
  EXPECT_EQ(rig.sample.pose_D.p, rig.says.position_m);
}

/// A port of this computer, and perhaps a program that takes connections there and says nothing.
class MutePort
{
public:
  explicit MutePort(bool listens) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
  {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof at;
    auto* const address = reinterpret_cast<sockaddr*>(&at);
    EXPECT_EQ(::bind(this->socket_, address, length), 0);
    EXPECT_EQ(::getsockname(this->socket_, address, &length), 0);
    EXPECT_EQ(listens ? ::listen(this->socket_, 8) : 0, 0);
    this->number = ntohs(at.sin_port);
  }
  ~MutePort() { ::close(this->socket_); }
  MutePort(const MutePort&) = delete;
  MutePort& operator=(const MutePort&) = delete;

  std::uint16_t number = 0;

private:
  int socket_;
};

TEST(HaplyService, ThatIsInstalledAndCannotBeAskedIsToldOfWithThatReason)
{
  for (const bool listens : { false, true })
  {
    const MutePort states(listens);
    const std::vector<ArmKit> kits{ haplyKit({ states.number, states.number, states.number, "/" }) };
    const std::vector<FoundArm> found = findArms(kits);
    ASSERT_EQ(found.size(), 1U);
    const auto says = [&found](const std::string& text) { return found[0].problem.find(text) != std::string::npos; };
    EXPECT_EQ(says("start haply-inverse-service"), !listens) << found[0].problem;
    EXPECT_EQ(says("does not accept a connection on port " + std::to_string(states.number)), listens);
  }
}

TEST(HaplyService, IsRefusedWhereItsChannelOfSafetyEventsDoesNotOpenButNotWhereThereIsNone)
{
  for (const bool listens : { false, true })
  {
    const FakeService service;
    const MutePort events(listens);
    const ArmKit kit = haplyKit({ service.port(), service.port(), events.number, "/nowhere" });
    ArmDevice device("haply", kit.bus, { "049D", 0, 0, "049D", "Haply inverse3" }, kit.setup, { false });
    const std::string problem = device.open();
    EXPECT_EQ(problem.find("does not open its channel of safety events") != std::string::npos, listens) << problem;
    EXPECT_EQ(problem.empty(), !listens);
    EXPECT_EQ(service.messages() > 0, !listens) << "a device that is refused is told nothing";
  }
}

TEST(HaplyService, WithADeviceThatAnotherProgramUsesIsRefused)
{
  HaplyRig rig;
  rig.says.inUse = true;
  rig.service.say(rig.says);
  EXPECT_THAT(rig.device.open(), testing::HasSubstr("another program uses this device"));
  EXPECT_EQ(rig.service.messages(), 0);
  const std::vector<ArmKit> kits{ rig.kit };
  EXPECT_THAT(findArms(kits).at(0).problem, testing::HasSubstr("another program"));
}

TEST(HaplyService, IsAwaitedUntilTheDeviceIsReadyAndCalibrated)
{
  for (const bool ready : { false, true })
  {
    HaplyRig rig;
    rig.says.ready = ready;
    rig.says.calibrated = !ready;
    rig.service.say(rig.says);
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 0.0, 0.0, 1.0 }, 5);
    EXPECT_EQ(rig.status, DeviceStatus::Waiting);
    EXPECT_EQ(rig.service.force_N().norm(), 0.0);
    ASSERT_TRUE(rig.device.step());
    rig.says.ready = rig.says.calibrated = true;
    rig.service.say(rig.says);
    ask(rig, { 0.0, 0.0, 1.0 }, 5);
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    EXPECT_EQ(rig.service.force_N(), Vec3(0.0, 0.0, 1.0));
  }
}

/// A computer with the arms of that kit and no other device.
DeviceOptions onlyOf(const ArmKit& kit)
{
  DeviceOptions options;
  options.hid = std::make_shared<test::FakeHidBus>();
  options.arms = std::make_shared<const std::vector<ArmKit>>(1, kit);
  return options;
}

TEST(HaplyService, WithADeviceThatIsNotReadyOrNotCalibratedIsListedWithThatReasonAndCanBeOpened)
{
  for (const bool calibrated : { false, true })
  {
    for (const bool ready : { false, true })
    {
      HaplyRig rig;
      rig.says.ready = ready;
      rig.says.calibrated = calibrated;
      rig.service.say(rig.says);
      const std::vector<KnownDevice> known = knownDevices(onlyOf(rig.kit));
      ASSERT_EQ(known.back().info.serial, "049D");
      EXPECT_EQ(known.back().problem, "");
      EXPECT_EQ(known.back().what.find("not calibrated: ") != std::string::npos, !calibrated) << known.back().what;
      EXPECT_EQ(known.back().what.find("not ready: ") != std::string::npos, calibrated && !ready) << known.back().what;
      EXPECT_EQ(rig.service.messages(), 0) << "a device that is listed is told nothing";
      EXPECT_EQ(rig.device.open(), "");
    }
  }
}

TEST(HaplyService, TellsByItsTypeHowLargeTheWorkSpaceIs)
{
  const std::vector<std::pair<std::string, double>> radii{ { "inverse3", 0.1 }, { "inverse3x", 0.1 },
    { "minverse", 0.04 } }; // [m], of the vendor's samples
  for (const auto& [type, radius_m] : radii)
  {
    HaplyRig rig;
    rig.says.type = type;
    rig.service.say(rig.says);
    const DeviceOptions options = onlyOf(rig.kit);
    EXPECT_EQ(knownDevices(options).back().info.workspaceRadius_m.value, radius_m) << type;
    const std::vector<FoundArm> found = findArms(*options.arms);
    EXPECT_EQ(makeDevice(found.at(0).name, options).device->info().workspaceRadius_m.value, radius_m) << type;
  }
}

TEST(HaplyService, WithASpaceThatAnotherProgramMovesOrWithoutPowerGivesNoForceAndSaysSo)
{
  HaplyRig rig;
  rig.says.keepsTransform = true;
  rig.service.say(rig.says);
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.0, 0.0, 1.0 }, 5);
  EXPECT_EQ(rig.service.force_N().norm(), 0.0);
  EXPECT_THAT(rig.device.linkReport().message, testing::HasSubstr("another program moves the space"));
  rig.says.keepsTransform = false;
  rig.says.power = false;
  rig.service.say(rig.says);
  ask(rig, { 0.0, 0.0, 1.0 }, 5);
  EXPECT_EQ(rig.service.force_N().norm(), 0.0);
  EXPECT_THAT(rig.device.linkReport().message, testing::HasSubstr("no power supply"));
}

TEST(HaplyService, ThatStopsTheArmInContactEndsTheForceUntilAPersonEngagesAgain)
{
  HaplyRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.0, 0.0, 1.0 }, 5);
  ASSERT_EQ(rig.service.force_N().z(), 1.0);
  ASSERT_EQ(rig.lostTicks, 0);
  rig.says.power = false;
  rig.service.say(rig.says);
  rig.run(3);
  EXPECT_EQ(rig.service.force_N().norm(), 0.0);
  EXPECT_EQ(rig.lostTicks, 1);
  const std::string why = rig.device.linkReport().endedFor;
  EXPECT_THAT(why, testing::HasSubstr("no power supply"));
  rig.says.power = true;
  rig.service.say(rig.says);
  rig.run(20);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.service.force_N().norm(), 0.0) << "the same force is asked for all the time";
  EXPECT_EQ(
    describeFault(Fault::DeviceLost, rig.device.linkReport()), "the force has ended: " + why + "; then engage again");
  ask(rig, { 0.0, 0.0, 1.0 }, 5);
  EXPECT_EQ(rig.service.force_N().z(), 1.0);
  EXPECT_EQ(rig.device.linkReport().endedFor, "") << "an arm that pushes again is not explained any more";
}

/// Runs until the device is lost, for 2000 messages at most. The reason; empty: it is not lost.
std::string lostFor(HaplyRig& rig)
{
  const int before = rig.service.messages();
  while (rig.lostTicks == 0 && rig.service.messages() < before + 2000)
  {
    rig.run(1);
  }
  return rig.lostTicks > 0 ? rig.device.linkReport().lostFor : "";
}

TEST(HaplyService, EndsTheForceWithTheNameOfAnEvent)
{
  const std::string safety = "device-safety-triggered", gone = "device-disconnected", busy = "device-busy";
  const std::vector<std::pair<std::string, std::string>> events{
    { "ebrake_triggered", FakeService::eventOf(safety, "049D", "ebrake_triggered") },
    { "fod_stage_changed", FakeService::eventOf(safety, "049D", "fod_stage_changed") },
    { "stall_detected", FakeService::eventOf(safety, "049D", "stall_detected") },
    { "stability_ceiling", FakeService::eventOf(safety, "049D", "stability_ceiling") },
    { safety, FakeService::eventOf(safety, "049D", "a new reason") },
    { gone, FakeService::eventOf(gone, "049D") },
    { gone, R"({"event":"device-disconnected"})" }, // which device is not said
    { busy, FakeService::eventOf(busy, "049D") },
    { busy, R"({"event":"device-busy","device_id":"049D"})" },
  };
  for (const auto& [name, message] : events)
  {
    HaplyRig rig;
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 0.0, 0.0, 1.0 }, 5);
    ASSERT_EQ(rig.service.force_N().z(), 1.0);
    rig.says.events = { message };
    rig.service.say(rig.says);
    EXPECT_EQ(lostFor(rig), "the vendor's service stopped the device: " + name) << message;
    EXPECT_EQ(rig.service.force_N().norm(), 0.0) << message;
  }
}

// Events come in their order: whatever stood before the one that ends the force has been heard.
TEST(HaplyService, GoesOnAfterEventsOfOtherKindsAndOfOtherDevices)
{
  HaplyRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.0, 0.0, 1.0 }, 5);
  rig.says.events = { FakeService::eventOf("device-connected", "049D"),
    FakeService::eventOf("device-disconnected", "62"), FakeService::eventOf("device-busy", "FFFF"),
    R"({"name":"session-started","data":{"session_id":8}})", "no JSON",
    FakeService::eventOf("device-safety-triggered", "049D", "stall_detected") };
  rig.service.say(rig.says);
  EXPECT_EQ(lostFor(rig), "the vendor's service stopped the device: stall_detected");
}

TEST(HaplyService, PassesOverMessagesOfOtherKindsDevicesAndSessionsBetweenItsAnswers)
{
  HaplyRig rig;
  rig.says.between = FakeService::messagesOfOthers();
  rig.service.say(rig.says);
  ASSERT_EQ(rig.device.open(), "");
  const Vec3 force_N(0.5, -1.25, 2.0), place_m = rig.says.position_m - Vec3(0.0, -0.12, 0.15);
  int seen = 0;
  for (int i = 0; i < 100; ++i)
  {
    ask(rig, force_N, 5);
    seen += rig.status == DeviceStatus::Ok ? 1 : 0;
    EXPECT_LT((rig.sample.pose_D.p - place_m).norm(), rig.status == DeviceStatus::Ok ? 1e-12 : 1.0) << i;
  }
  EXPECT_GT(seen, 50) << "but for stalls of this computer";
  EXPECT_EQ(rig.device.linkReport().strange, 0U) << "none of them is taken for a wrong answer";
  EXPECT_TRUE(test::eventually(
    [&]
    {
      ask(rig, force_N, 5);
      return rig.service.force_N() == force_N;
    }));
}

TEST(HaplyService, WhoseMessagesAreAllOfOthersIsLostWithinTwentyMilliseconds)
{
  for (const std::string& other : FakeService::messagesOfOthers())
  {
    HaplyRig rig;
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 0.0, 0.0, 1.0 }, 5);
    rig.says.between = std::vector<std::string>(3, other);
    rig.says.answer = Answers::Nothing;
    rig.service.say(rig.says);
    const std::int64_t until_ns = rig.time.now_ns() + 20 * perMs_ns;
    while (rig.time.now_ns() < until_ns)
    {
      rig.run(1);
    }
    EXPECT_GE(rig.lostTicks, 1) << other;
    EXPECT_THAT(rig.device.linkReport().lostFor, testing::HasSubstr("the device does not answer")) << other;
    EXPECT_EQ(rig.service.force_N().norm(), 0.0) << other;
  }
}

// 3.5 tells its version on the port of the states, older ones on a port of its own, and both take forces by another
// key.
TEST(HaplyService, IsAskedForItsVersionOnTheOldPortWhereThePortOfItsStatesDoesNotTellIt)
{
  using Asked = FakeService::Says::Asked;
  for (const Asked asked : { Asked::KnowsNot, Asked::Closes, Asked::Keeps })
  {
    for (const char* const version : { "3.1.4", "3.5.0" })
    {
      HaplyRig rig;
      rig.says.version = version;
      rig.says.asked = asked;
      rig.says.askedElsewhere = Asked::Answers;
      rig.service.say(rig.says);
      ASSERT_EQ(rig.device.open(), "") << version;
      ask(rig, { 0.0, 0.0, 1.0 }, 5);
      EXPECT_EQ(rig.service.force_N(), Vec3(0.0, 0.0, 1.0)) << version;
    }
    HaplyRig silent;
    silent.says.asked = silent.says.askedElsewhere = asked;
    silent.service.say(silent.says);
    EXPECT_THAT(silent.device.open(), testing::HasSubstr("does not tell its version"));
    EXPECT_EQ(silent.service.messages(), 0) << "a device is told nothing whose forces have an unknown key";
  }
}

TEST(HaplyService, ThatSaysSomethingElseIsLostWithinTwentyMillisecondsAndIsToldNoForce)
{
  for (const Answers answer :
    { Answers::Nothing, Answers::Broken, Answers::Huge, Answers::Endless, Answers::OtherArm, Answers::Closes })
  {
    HaplyRig rig;
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 0.0, 0.0, 1.0 }, 5);
    ASSERT_EQ(rig.service.force_N().z(), 1.0);
    rig.says.answer = answer;
    rig.service.say(rig.says);
    const std::int64_t until_ns = rig.time.now_ns() + 20 * perMs_ns;
    while (rig.time.now_ns() < until_ns)
    {
      rig.run(1);
    }
    EXPECT_GE(rig.lostTicks, 1) << static_cast<int>(answer);
    const std::string why = rig.device.linkReport().lostFor;
    EXPECT_NE(why, "") << static_cast<int>(answer);
    EXPECT_THAT(why, testing::Not(testing::HasSubstr("unplugged"))) << "a service has no cable";
    EXPECT_TRUE(answer != Answers::Closes || why.find("does not hold the connection") != std::string::npos) << why;
    EXPECT_TRUE(answer == Answers::Closes || rig.service.force_N().norm() == 0.0) << static_cast<int>(answer);
  }
}

} // namespace
} // namespace palpate
