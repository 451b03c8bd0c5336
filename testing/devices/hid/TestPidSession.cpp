// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>

#include <gtest/gtest.h>

#include "devices/io/PidDevice.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

/// Stands still until the test moves it.
class HandClock final : public Clock
{
public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->now_ns_; }
  void advance(int duration_ms) noexcept { this->now_ns_ += duration_ms * std::int64_t{ 1000000 }; }

private:
  std::atomic<std::int64_t> now_ns_ = 1000000; // 0 is before anything was written
};

/// A session in virtual time whose hand presses on a wall. Millisecond by millisecond the link's reader, the tick and
/// the link's writer get their turn; a pass that hangs stays where it is, on a thread of its own.
struct PressedSession
{
  explicit PressedSession(bool silent = false)
  {
    this->port.device->silent = silent;
    SessionOptions virtualTime;
    virtualTime.virtualTime = true;
    this->session.setScene(test::sceneOf(raiseWalls({ { { -1.0, 0.0 }, { 1.0, 0.0 } }, { { 0, 1 } } }, 0.01)));
    auto device = std::make_unique<PidDevice>("pid", this->bus, this->port.entry, this->passes());
    this->link = &device->link();
    EXPECT_EQ(this->session.start(std::move(device), virtualTime), "");
  }
  ~PressedSession() { this->bus->release(this->port); }

  [[nodiscard]] PidDeviceOptions passes() const
  {
    PidDeviceOptions options;
    options.threads = false;
    options.clock = &this->clock;
    return options;
  }

  int hanging()
  {
    return this->bus->alone([this] { return this->port.hanging; });
  }

  /// Runs a pass until it ends or one write more hangs.
  template<class Pass>
  void turn(std::future<bool>& last, Pass pass)
  {
    const auto ended = [&last] { return last.wait_for(std::chrono::milliseconds(1)) == std::future_status::ready; };
    if (last.valid() && !ended())
    {
      return;
    }
    const int before = this->hanging();
    last = std::async(std::launch::async, pass);
    ASSERT_TRUE(test::eventually([&] { return ended() || this->hanging() > before; }));
  }

  /// The servo's share of the next ticks: none of them waits, locks or allocates.
  void ticks(int count)
  {
    const test::AllocationGuard guard;
    const int done = this->session.step(count);
    const std::uint64_t disturbed = guard.allocations() + guard.frees() + guard.locks();
    EXPECT_EQ(done, count);
    EXPECT_EQ(disturbed, 0U);
  }

  void millisecond(double hand)
  {
    this->clock.advance(1);
    this->bus->alone([&] { this->port.device->position[1] = hand; });
    this->bus->advance(1);
    this->turn(this->reader, [this] { return this->link->readPass(0); });
    this->ticks(1);
    this->turn(this->writer, [this] { return this->link->writePass(); });
  }

  std::shared_ptr<test::FakeHidBus> bus = std::make_shared<test::FakeHidBus>(false);
  test::FakePort& port = bus->plug(test::plainLayout());
  HandClock clock;
  HapticSession session;
  PidLink* link = nullptr;
  std::future<bool> reader, writer;
};

// A write may take 50 ms before the device counts as stalled.
TEST(PidSession, AStalledDeviceMakesNoTickLate)
{
  PressedSession rig;
  double hand = -0.1;
  for (int k = 0; k < 2000 && rig.session.state().force_D.norm() < 0.5; ++k)
  {
    rig.millisecond(hand = std::min(hand + 1e-3, 0.2));
  }
  ASSERT_GE(rig.session.state().force_D.norm(), 0.5);
  rig.bus->alone([&] { return rig.port.stalls = true; });
  for (int k = 0; k < 100 && rig.hanging() == 0; ++k)
  {
    rig.millisecond(hand += 1e-4); // another force, to be written
  }
  ASSERT_EQ(rig.hanging(), 1);
  for (int since_ms = 1; since_ms <= 51; ++since_ms)
  {
    ASSERT_EQ(rig.session.state().fault, Fault::None) << since_ms;
    rig.millisecond(hand);
  }
  EXPECT_EQ(rig.session.state().fault, Fault::DeviceLost);
  EXPECT_EQ(rig.session.state().force_D.norm(), 0.0);
  rig.ticks(5000);
  EXPECT_EQ(rig.hanging(), 2); // all the while, with the order to stop behind it
}

// The force begins, with its ramp, when the hand is known; nobody has to touch again.
TEST(PidSession, ADeviceThatSaysNothingUntilItIsMovedIsNoLostOne)
{
  PressedSession rig(true);
  for (int k = 0; k < 100; ++k)
  {
    rig.millisecond(-0.1);
    ASSERT_EQ(rig.session.state().fault, Fault::NoHand);
    ASSERT_EQ(rig.session.state().force_D.norm(), 0.0);
  }
  rig.bus->alone([&] { return rig.port.device->silent = false; });
  double hand = -0.1;
  for (int k = 0; k < 2000 && rig.session.state().force_D.norm() < 0.5; ++k)
  {
    rig.millisecond(hand = std::min(hand + 1e-3, 0.2));
  }
  EXPECT_EQ(rig.session.state().fault, Fault::None);
  EXPECT_GE(rig.session.state().force_D.norm(), 0.5);
}

TEST(PidSession, ALostDeviceIsAFaultThatStaysWhenItIsPluggedInAgain)
{
  auto bus = std::make_shared<test::FakeHidBus>(false);
  test::FakePort& port = bus->plug(test::plainLayout());
  PidDeviceOptions passes;
  passes.threads = false;
  auto owned = std::make_unique<PidDevice>("pid", bus, port.entry, passes);
  PidLink& link = owned->link();
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::move(owned), options), "");
  const auto hear = [&]
  {
    bus->advance(1);
    return link.readPass(0);
  };
  ASSERT_TRUE(hear());
  session.step(1);
  EXPECT_EQ(session.state().fault, Fault::SceneRefused); // only that there is nothing to touch here
  bus->alone([&] { return port.present = false; });
  while (link.readPass(0)) // reports that were queued before still come
  {
  }
  session.step(1);
  EXPECT_EQ(session.state().fault, Fault::DeviceLost);
  bus->alone([&] { return port.present = true; });
  static_cast<void>(link.writePass());
  EXPECT_TRUE(link.report().attached);
  ASSERT_TRUE(hear());
  session.step(100);
  EXPECT_EQ(session.state().fault, Fault::DeviceLost); // until a person engages
  session.engage();
  session.step(1);
  EXPECT_EQ(session.state().fault, Fault::SceneRefused);
}

} // namespace
} // namespace palpate
