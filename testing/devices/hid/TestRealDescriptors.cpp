// SPDX-License-Identifier: GPL-3.0-or-later
// Report descriptors of real devices (descriptors/README.md).
#include <gtest/gtest.h>

#include "devices/hid/SpaceMouseInput.h"
#include "devices/hid/pid/PidKind.h"
#include "devices/io/HidDiscovery.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/devices/hid/RealDescriptors.h"

namespace palpate
{
namespace
{

using test::RealDescriptor;

/// With axes at all; a device that gives force says so by its kind.
struct Known
{
  const char* name;
  std::size_t bytes;
  DeviceClass deviceClass;
  std::size_t sensed, pushed;
  DeviceAbilities offered;
};

// Sizes are those that their owners give. The SideWinder and the boards have all usages of a condition, 0x60 to 0x65;
// the adapters have one coefficient and no dead band, which can hold nothing that is limited on one side only. Nothing
// in the wheel's descriptor tells it from a stick: that its y gives no force is found by pushing.
TEST(RealDescriptors, ThoseOfForceFeedbackDevicesParseToTheRightKind)
{
  const DeviceAbilities shakes{ 2, false, false, true }, holds{ 2, true, true, true };
  for (const Known& known : { Known{ "microsoft-sidewinder-ff2-045e-001b", 1343, DeviceClass::Joystick2D, 2, 2, holds },
         Known{ "adapt-ffb-joy-0.3.0-stick", 1348, DeviceClass::Joystick2D, 2, 2, shakes },
         Known{ "adapt-ffb-joy-0.5.0b1-stick", 1348, DeviceClass::Joystick2D, 2, 2, shakes },
         Known{ "adapt-ffb-joy-0.5.0b1-wheel", 1348, DeviceClass::Joystick2D, 2, 2, shakes },
         Known{ "openffboard-1axis", 1196, DeviceClass::Wheel1D, 1, 1, { 1, true, true, true } },
         Known{ "openffboard-2axis", 1215, DeviceClass::Joystick2D, 2, 2, holds } })
  {
    const RealDescriptor real = test::realDescriptor(known.name);
    EXPECT_EQ(real.bytes.size(), known.bytes) << known.name;
    const ReportDescriptor parsed = parseReportDescriptor(real.bytes);
    EXPECT_EQ(parsed.problem, "") << known.name;
    EXPECT_EQ(PidEngine::refusal(parsed), "") << known.name;
    const PidKind kind = pidKind(parsed);
    EXPECT_EQ(kind.deviceClass, known.deviceClass) << known.name;
    EXPECT_EQ(kind.sensedAxes, known.sensed) << known.name;
    EXPECT_EQ(kind.pushedAxes, known.pushed) << known.name;
    EXPECT_EQ(promised(kind), known.offered) << known.name;
  }
}

// Its largest numbers for the axis and for Direction Enable are left over from another item: 0. Without the bit its
// firmware gives no force.
TEST(RealDescriptors, ABoardOfOneAxisIsToldToUseTheDirection)
{
  struct LastReport final : HidConnection
  {
    int read(std::span<std::uint8_t>, int) noexcept override { return 0; }
    bool write(std::span<const std::uint8_t> report) noexcept override
    {
      this->bytes.assign(report.begin(), report.end());
      return true;
    }
    bool setFeature(std::span<const std::uint8_t>) noexcept override { return true; }
    int getFeature(std::span<std::uint8_t>) noexcept override { return -1; }
    std::string error() const override { return {}; }
    void wait(int) noexcept override {}
    std::vector<std::uint8_t> bytes;
  } connection;
  const ReportDescriptor parsed = parseReportDescriptor(test::realDescriptor("openffboard-1axis").bytes);
  ASSERT_TRUE(PidEngine(connection, parsed).setEffect(1, {}));
  constexpr std::size_t trigger = 12, axes = 13; // after two selectors, four times and the gain
  EXPECT_EQ(connection.bytes.at(trigger), 0xFF);
  EXPECT_EQ(connection.bytes.at(axes), 2); // x is bit 0
}

TEST(RealDescriptors, ThoseWithoutForceAreListedAsSuchOrAreCaps)
{
  for (const RealDescriptor& real : test::realDescriptors())
  {
    if (real.name.substr(0, 2) != "x-")
    {
      continue;
    }
    test::FakeHidBus bus;
    bus.plug(test::plainLayout(), "7").descriptor = real.bytes;
    const std::vector<FoundHid> found = findHidDevices(bus);
    ASSERT_EQ(found.size(), 1U) << real.name;
    EXPECT_EQ(parseReportDescriptor(real.bytes).problem, "") << real.name;
    const bool cap = real.name.find("spacemouse") != std::string::npos;
    EXPECT_EQ(found[0].kind, cap ? FoundHid::Kind::SpaceMouse : FoundHid::Kind::Unusable) << real.name;
    EXPECT_EQ(found[0].problem.empty(), cap) << real.name << found[0].problem;
    EXPECT_TRUE(cap || found[0].problem.find("no force") != std::string::npos) << found[0].problem;
  }
}

TEST(RealDescriptors, AreAllThere)
{
  EXPECT_EQ(test::realDescriptors().size(), 11U);
}

} // namespace
} // namespace palpate
