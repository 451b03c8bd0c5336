// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/io/PidDevice.h"
#include "haptics/session/HapticSession.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate
{
namespace
{

// Five seconds of session in virtual time on a device whose writes hang: no period passes without its tick.
TEST(PidSession, AStalledDeviceMakesNoTickLate)
{
  auto bus = std::make_shared<test::FakeHidBus>(false);
  test::FakePort& port = bus->plug(test::plainLayout());
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::make_unique<PidDevice>("pid", bus, port.entry), options), "");
  bus->alone([&] { return port.stalls = true; });
  EXPECT_EQ(session.step(5000), 5000);
  EXPECT_EQ(session.report().ticks, 5000u);
  EXPECT_EQ(session.report().missed, 0u);
  bus->release(port);
  EXPECT_EQ(session.stop(), "");
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
  session.step(1);
  bus->alone([&] { return port.present = false; });
  while (link.readPass(0)) // what was queued before still comes
  {
  }
  session.step(1);
  EXPECT_EQ(session.state().fault, Fault::DeviceLost);
  bus->alone([&] { return port.present = true; });
  static_cast<void>(link.writePass());
  EXPECT_TRUE(link.report().attached);
  session.step(100);
  EXPECT_EQ(session.state().fault, Fault::DeviceLost); // until a person engages
  session.engage();
  session.step(1);
  EXPECT_EQ(session.state().fault, Fault::SceneRefused); // only that there is nothing to touch here
}

} // namespace
} // namespace palpate
