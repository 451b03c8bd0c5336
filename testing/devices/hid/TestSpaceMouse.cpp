// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/common/DeviceNotes.h"
#include "devices/io/SpaceMouseDevice.h"
#include "haptics/session/HapticSession.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

using test::CapLayout;
using test::FakeHidBus;
using test::FakePort;
using test::VirtualSpaceMouse;

constexpr double speed_m_per_s = CapMotionOptions{}.speed_m_per_s, turn_rad_per_s = CapMotionOptions{}.turn_rad_per_s;
constexpr double rest = CapMotionOptions{}.restShare;
constexpr int firstReport_ms = 20; // they come every 16 ms

/// A SpaceMouse on a bus in virtual time: every millisecond a tick of the servo and a pass of the reader.
struct CapRig
{
  explicit CapRig(const CapLayout& layout, const std::string& serial = "0001") : port(bus->plug(layout, serial))
  {
    SpaceMouseOptions options;
    options.threads = false;
    options.clock = &this->bus->time();
    this->device = std::make_unique<SpaceMouseDevice>("spacemouse", this->bus, this->port.entry, options);
  }

  VirtualSpaceMouse& cap() { return *this->port.spaceMouse; }

  void run(int duration_ms)
  {
    for (int i = 0; i < duration_ms; ++i)
    {
      this->bus->advance(1);
      static_cast<void>(this->device->link().readPass(0));
      this->status = this->device->read(1e-3 * ++this->tick, this->sample);
      this->lostTicks += this->status == DeviceStatus::Lost ? 1 : 0;
    }
  }

  /// Presses one axis as far as it goes and gives the motion of 100 ticks after the first report.
  Pose sweptBallOf(std::size_t axis, std::int64_t counts)
  {
    this->cap().cap = {};
    this->cap().cap[axis] = counts;
    this->run(firstReport_ms);
    const Pose from = this->sample.pose_D;
    this->run(100);
    return { this->sample.pose_D.p - from.p, this->sample.pose_D.q * from.q.conjugate() };
  }

  std::shared_ptr<FakeHidBus> bus = std::make_shared<FakeHidBus>();
  FakePort& port;
  std::unique_ptr<SpaceMouseDevice> device;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  int lostTicks = 0;
  int tick = 0;
};

// D has x to the right, y away and z up; HID x to the right, y near and z down.
TEST(SpaceMouse, EveryAxisOfEveryGenerationMovesTheHandTheWayTheCapIsPressed)
{
  const std::array<Vec3, 3> way_D{ Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitZ() };
  for (const CapLayout& layout : test::allCaps())
  {
    for (const std::size_t axis : { 0U, 1U, 2U })
    {
      CapRig rig(layout);
      ASSERT_EQ(rig.device->open(), "") << layout.name;
      const Pose there = rig.sweptBallOf(axis, layout.range);
      EXPECT_LE((there.p - 0.1 * speed_m_per_s * way_D[axis]).norm(), 1e-12) << layout.name << axis;
      EXPECT_EQ(there.q.vec().norm(), 0.0);
      const Pose back = rig.sweptBallOf(axis, -layout.range);
      EXPECT_LE((back.p + there.p).norm(), 1e-12) << layout.name << axis;
    }
  }
}

// A tick turns by the unit of 1 + i w dt / 2, which is 2 atan(w dt / 2).
TEST(SpaceMouse, EveryTurnOfEveryGenerationTurnsTheHandRightHandedAboutTheSameWay)
{
  const std::array<Vec3, 3> about_D{ Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitZ() };
  for (const CapLayout& layout : test::allCaps())
  {
    for (const std::size_t axis : { 0U, 1U, 2U })
    {
      CapRig rig(layout);
      ASSERT_EQ(rig.device->open(), "") << layout.name;
      const Pose there = rig.sweptBallOf(3 + axis, layout.range);
      const double half_rad = 100 * std::atan(0.5 * turn_rad_per_s * 1e-3);
      EXPECT_LE((there.q.vec() - std::sin(half_rad) * about_D[axis]).norm(), 1e-12) << layout.name << axis;
      EXPECT_EQ(there.p.norm(), 0.0);
      EXPECT_NEAR(rig.sample.pose_D.q.norm(), 1.0, 1e-12);
    }
  }
}

TEST(SpaceMouse, ALighterPressIsSlowerAndNextToNoPressIsNone)
{
  CapRig rig(test::newerCap());
  ASSERT_EQ(rig.device->open(), "");
  EXPECT_NEAR(rig.sweptBallOf(0, 175).p.x(), 0.1 * speed_m_per_s * (0.5 - rest) / (1.0 - rest), 1e-12);
  EXPECT_EQ(rig.sweptBallOf(0, 7).p.norm(), 0.0); // 2 % of 350
}

TEST(SpaceMouse, TwoReportsAreOnePressAndNeitherForgetsTheOther)
{
  CapRig rig(test::wiredCap());
  ASSERT_EQ(rig.device->open(), "");
  rig.cap().cap = { 350, 0, 0, 0, 0, 350 };
  rig.run(firstReport_ms);
  const Pose from = rig.sample.pose_D;
  rig.cap().silent = true;
  for (int i = 0; i < 5; ++i)
  {
    rig.cap().inputs.push_back({ 2, 0, 0, 0, 0, 0x5E, 0x01 }); // of the turn alone: 350 about z
    rig.run(10);
  }
  EXPECT_NEAR(rig.sample.pose_D.p.x() - from.p.x(), 0.05 * speed_m_per_s, 1e-12);
  EXPECT_LT((rig.sample.pose_D.q * from.q.conjugate()).z(), 0.0);
}

TEST(SpaceMouse, LetGoTheHandStaysAndNeverLeavesItsWorkspace)
{
  CapRig rig(test::newerCap());
  ASSERT_EQ(rig.device->open(), "");
  rig.cap().cap = { 350, 350, 350, 0, 0, 0 };
  rig.run(3000);
  const double radius_m = rig.device->info().workspaceRadius_m.value;
  EXPECT_NEAR(rig.sample.pose_D.p.norm(), radius_m, 1e-12);
  rig.cap().cap = {};
  rig.run(firstReport_ms);
  const Vec3 left_D = rig.sample.pose_D.p;
  rig.run(1000);
  EXPECT_EQ(rig.sample.pose_D.p, left_D);
  EXPECT_EQ(rig.sample.velocity_D.linear.norm(), 0.0);
}

TEST(SpaceMouse, ARadioLinkThatBreaksOffWhileTheCapIsPressedStopsTheHand)
{
  CapRig rig(test::radioCap());
  ASSERT_EQ(rig.device->open(), "");
  rig.cap().cap[0] = 350;
  rig.run(200);
  rig.cap().silent = true;
  const double from_m = rig.sample.pose_D.p.x();
  rig.run(1000);
  // A tenth of a second after the last report, which is at most 16 ms old.
  EXPECT_LE(rig.sample.pose_D.p.x() - from_m, 0.101 * speed_m_per_s);
  EXPECT_GT(rig.sample.pose_D.p.x() - from_m, 0.08 * speed_m_per_s);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
}

TEST(SpaceMouse, ButtonsOfEveryGenerationAreBits)
{
  for (const CapLayout& layout : test::allCaps())
  {
    CapRig rig(layout);
    ASSERT_EQ(rig.device->open(), "");
    rig.cap().buttons = 0x89;
    rig.run(5);
    EXPECT_EQ(rig.sample.buttons, 0x89U) << layout.name;
    rig.cap().buttons = 0;
    rig.run(5);
    EXPECT_EQ(rig.sample.buttons, 0U) << layout.name;
  }
}

TEST(SpaceMouse, ShortAndForeignReportsAreCountedAndChangeNothing)
{
  CapRig rig(test::radioCap());
  ASSERT_EQ(rig.device->open(), "");
  rig.run(5);
  for (const std::vector<std::uint8_t>& strange :
    { std::vector<std::uint8_t>{ 1, 0x5E, 0x01 }, { 0x17, 80 }, { 0x77, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 } })
  {
    rig.cap().inputs.push_back(strange);
  }
  rig.run(100);
  EXPECT_EQ(rig.sample.pose_D.p.norm(), 0.0);
  EXPECT_EQ(rig.device->linkReport().strange, 3U);
  EXPECT_EQ(rig.device->linkReport().inputs, 0U);
}

TEST(SpaceMouse, APressBeyondTheRangeIsCutToItAndCounted)
{
  CapRig rig(test::newerCap());
  ASSERT_EQ(rig.device->open(), "");
  EXPECT_NEAR(rig.sweptBallOf(0, 30000).p.x(), 0.1 * speed_m_per_s, 1e-12);
  EXPECT_GE(rig.device->linkReport().outOfRange, 6U);
}

TEST(SpaceMouse, UnpluggedItIsLostAndPluggedInAgainItGoesOnFromWhereItWas)
{
  CapRig rig(test::wiredCap());
  ASSERT_EQ(rig.device->open(), "");
  rig.cap().cap[0] = 350;
  rig.run(200);
  rig.port.present = false;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  EXPECT_FALSE(rig.device->linkReport().attached);
  EXPECT_NE(rig.device->linkReport().message.find("not attached"), std::string::npos);
  const Vec3 lostAt_D = rig.sample.pose_D.p;
  rig.port.entry.path = "elsewhere";
  rig.port.spaceMouse = std::make_shared<VirtualSpaceMouse>(test::wiredCap());
  rig.port.present = true;
  rig.run(600);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.sample.pose_D.p, lostAt_D); // the press of before is forgotten
  EXPECT_GT(rig.sweptBallOf(1, -350).p.y(), 0.0);
}

TEST(SpaceMouse, ALoosePlugThatBouncesSoonAfterItWasFoundIsFoundInItsNewPlace)
{
  CapRig rig(test::wiredCap(), "");
  ASSERT_EQ(rig.device->open(), "");
  for (const char* path : { "bounced", "bounced again" })
  {
    rig.run(20);
    rig.port.present = false;
    rig.run(5);
    EXPECT_FALSE(rig.device->linkReport().attached) << path;
    rig.port.entry.path = path;
    rig.port.spaceMouse = std::make_shared<VirtualSpaceMouse>(test::wiredCap());
    rig.port.present = true;
    for (int i = 0; i < 60 && !rig.device->linkReport().attached; ++i)
    {
      rig.run(10); // looked for each half a second
    }
    EXPECT_TRUE(rig.device->linkReport().attached) << path << ": " << rig.device->linkReport().message;
  }
}

TEST(SpaceMouse, UnpluggingAtAnyStepOfOpeningIsAnAnswerAndNothingStaysOpen)
{
  bool opened = false;
  int steps = 0;
  for (; !opened; ++steps)
  {
    auto rig = std::make_unique<CapRig>(test::wiredCap());
    rig->port.callsUntilUnplugged = steps;
    const std::string problem = rig->device->open();
    opened = problem.empty();
    EXPECT_TRUE(opened || problem.find("wired cap") != std::string::npos) << problem;
    EXPECT_TRUE(opened || rig->port.opened == rig->port.closed) << steps;
    ASSERT_LT(steps, 10);
  }
  EXPECT_EQ(steps, 3); // reading its descriptor, opening it
}

TEST(SpaceMouse, NoPermissionBusyBrokenAndIncompleteAreSaidWithTheName)
{
  for (const std::string problem : { "no permission", "busy" })
  {
    CapRig rig(test::wiredCap());
    rig.port.openProblem = problem;
    EXPECT_NE(rig.device->open().find("\"wired cap\": " + problem), std::string::npos);
  }
  CapRig cut(test::wiredCap());
  cut.port.descriptor.resize(cut.port.descriptor.size() / 2);
  EXPECT_NE(cut.device->open().find("report descriptor of"), std::string::npos);
  CapRig three(test::wiredCap());
  CapLayout translation = test::wiredCap();
  three.port.descriptor = test::descriptorOf(translation);
  three.port.descriptor[3] = 0x04; // a joystick, not a multi-axis controller
  EXPECT_NE(three.device->open().find("six axes"), std::string::npos);
}

TEST(SpaceMouse, TheFactoryListsItWithWhatItCannotDo)
{
  auto bus = std::make_shared<FakeHidBus>();
  bus->plug(test::radioCap(), "7");
  DeviceOptions options;
  options.hid = bus;
  const KnownDevice known = knownDevices(options).back();
  EXPECT_EQ(known.name, "spacemouse-256f-c62e-7");
  EXPECT_EQ(known.problem, "");
  EXPECT_FALSE(known.info.rendersForce);
  EXPECT_EQ(kindOf(known.info), "6 axes of motion, no force");
  EXPECT_NE(shortcomings(known.info).find("renders no force"), std::string::npos);
  const MadeDevice made = makeDevice(known.name, options);
  ASSERT_NE(made.device, nullptr);
  EXPECT_EQ(made.device->open(), "");
}

// The hand is led 10 mm into a sphere under a held button, which is then let go.
TEST(SpaceMouse, ItsButtonIsWhatMustBeHeldAndLetGoTheForceIsZeroAfterFiftyMilliseconds)
{
  auto bus = std::make_shared<FakeHidBus>();
  FakePort& port = bus->plug(test::newerCap());
  SpaceMouseOptions passes;
  passes.threads = false;
  passes.clock = &bus->time();
  auto owned = std::make_unique<SpaceMouseDevice>("spacemouse", bus, port.entry, passes);
  SpaceMouseLink& link = owned->link();
  HapticSession session;
  session.setScene(test::sceneOf(test::makeIcosphere(3, 0.05)));
  HapticParameters parameters;
  parameters.safety.engageRamp_s = 0.01;
  parameters.safety.deadMan.buttons = 1;
  parameters.map.offset_W = { 0.0, 0.0, 0.06 };
  ASSERT_EQ(session.setParameters(parameters), "");
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::move(owned), options), "");
  const auto run = [&](int duration_ms)
  {
    for (int i = 0; i < duration_ms; ++i)
    {
      bus->advance(1);
      EXPECT_TRUE(link.readPass(0));
      session.step(1);
    }
  };
  port.spaceMouse->buttons = 1;
  run(50);
  port.spaceMouse->cap[2] = 350; // down
  run(200);
  EXPECT_GT(session.state().force_D.z(), 0.1);
  port.spaceMouse->cap = {};
  port.spaceMouse->buttons = 0;
  run(52);
  EXPECT_EQ(session.state().force_D.norm(), 0.0);
  EXPECT_TRUE(session.state().letGo);
}

TEST(SpaceMouse, ReadingWaitsForNothingWhateverItsReaderDoes)
{
  auto bus = std::make_shared<FakeHidBus>(false);
  FakePort& port = bus->plug(test::wiredCap());
  SpaceMouseDevice device("spacemouse", bus, port.entry);
  ASSERT_EQ(device.open(), "");
  bus->alone([&] { return port.spaceMouse->cap[0] = 350; });
  DeviceSample sample;
  {
    const test::AllocationGuard guard;
    for (int tick = 0; tick < 5000; ++tick)
    {
      static_cast<void>(device.read(1e-3 * tick, sample));
    }
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
  }
  double time_s = 5.0;
  EXPECT_TRUE(test::eventually(
    [&]
    {
      bus->advance(1);
      return device.read(time_s += 1e-3, sample) == DeviceStatus::Ok && sample.pose_D.p.x() > 0.01;
    }));
  bus->alone([&] { return port.present = false; });
  EXPECT_TRUE(test::eventually([&] { return device.read(time_s += 1e-3, sample) == DeviceStatus::Lost; }));
  bus->alone([&] { return port.present = true; });
  EXPECT_TRUE(test::eventually([&] { return device.read(time_s += 1e-3, sample) == DeviceStatus::Ok; }));
  device.close();
}

} // namespace
} // namespace palpate
