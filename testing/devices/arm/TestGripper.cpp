// SPDX-License-Identifier: GPL-3.0-or-later
// Force Dimension's gripper as a switch.
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/library/GripSwitch.h"
#include "testing/devices/arm/LibraryRig.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate
{
namespace
{

/// Openings of two readings each, as a hand has them, and whether the second is held.
bool heldAfter(GripSwitch& grip, double opening_rad)
{
  static_cast<void>(grip.isHeld(opening_rad));
  return grip.isHeld(opening_rad);
}

TEST(GripSwitch, IsHeldBelowHalfOfTheWidestOpeningSoFar)
{
  GripSwitch grip;
  EXPECT_FALSE(heldAfter(grip, 0.0)) << "it may be closed by nobody";
  EXPECT_FALSE(heldAfter(grip, 0.4));
  EXPECT_TRUE(heldAfter(grip, 0.19));
  EXPECT_FALSE(heldAfter(grip, 0.21));
  EXPECT_FALSE(heldAfter(grip, 0.8));
  EXPECT_TRUE(heldAfter(grip, 0.39));
  EXPECT_FALSE(heldAfter(grip, 0.41));
}

TEST(GripSwitch, OfALeftHandHasNegativeOpenings)
{
  GripSwitch grip;
  EXPECT_FALSE(heldAfter(grip, -0.4));
  EXPECT_TRUE(heldAfter(grip, -0.19));
  EXPECT_FALSE(heldAfter(grip, -0.21));
}

TEST(GripSwitch, TakesNoiseForNoOpening)
{
  GripSwitch grip;
  EXPECT_FALSE(heldAfter(grip, 0.04)); // 2 degrees
  EXPECT_FALSE(heldAfter(grip, 0.0));
}

TEST(GripSwitch, IsNotHeldByASingleNumberThatIsTooLargeNorByOneThatIsNoOpening)
{
  GripSwitch grip;
  EXPECT_FALSE(heldAfter(grip, 0.4));
  EXPECT_FALSE(grip.isHeld(3.0));
  EXPECT_FALSE(grip.isHeld(0.3)) << "0.3 rad are not below half of 0.4";
  constexpr double endless = std::numeric_limits<double>::infinity();
  for (const double number : { std::numeric_limits<double>::quiet_NaN(), endless, -endless, 1e300, 4.0 })
  {
    EXPECT_FALSE(heldAfter(grip, number)) << number;
    EXPECT_FALSE(heldAfter(grip, 0.3)) << number;
    EXPECT_TRUE(heldAfter(grip, 0.1)) << number;
  }
}

/// An arm behind a library of that name, with a gripper that a test opens.
struct GrippedRig : test::LibraryRig
{
  explicit GrippedRig(const char* library)
    : LibraryRig(forceDimensionKit(library)), grip(test::fakeFunction<void(double, int)>(library, "fakeGrip")),
      asked(test::fakeFunction<int()>(library, "fakeGripAsked")),
      readings(test::fakeFunction<int()>(library, "fakeReadings"))
  {
  }
  ~GrippedRig() { this->grip(0.0, -1); }
  GrippedRig(const GrippedRig&) = delete;
  GrippedRig& operator=(const GrippedRig&) = delete;

  [[nodiscard]] bool heldAt(double opening_rad, int answer = 0)
  {
    this->grip(opening_rad, answer);
    this->run(3);
    EXPECT_EQ(this->status, DeviceStatus::Ok);
    return this->sample.grip;
  }

  void (*grip)(double, int);
  int (*asked)(), (*readings)();
};

TEST(ForceDimension, TellsThatItsGripperIsHeldAndAsksForItOnceAReading)
{
  GrippedRig rig(PALPATE_FAKE_DHD);
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_FALSE(rig.heldAt(0.4));
  const int asked = rig.asked(), readings = rig.readings();
  EXPECT_TRUE(rig.heldAt(0.1));
  EXPECT_EQ(rig.asked() - asked, 3);
  EXPECT_EQ(rig.readings() - readings, 3);
  EXPECT_FALSE(rig.heldAt(0.3));
  rig.device.close();
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_FALSE(rig.heldAt(0.1)) << "the openings of before are forgotten";
}

TEST(ForceDimension, WithoutAGripperIsNotHeldAndWorks)
{
  GrippedRig rig(PALPATE_FAKE_DHD);
  ASSERT_EQ(rig.device.open(), "");
  for (const double opening_rad : { 0.4, 0.1 })
  {
    EXPECT_FALSE(rig.heldAt(opening_rad, -1));
  }
  EXPECT_EQ(rig.sample.pose_D.p, Vec3(0.01, 0.02, -0.03));
  EXPECT_FALSE(rig.heldAt(0.4, 1)) << "a library that answers at its own rate says 1";
  EXPECT_TRUE(rig.heldAt(0.1, 1));
}

TEST(ForceDimension, WorksWithALibraryThatHasNoFunctionForAGripper)
{
  GrippedRig rig(PALPATE_FAKE_BARE_DHD);
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 1.0, -2.0, 3.0 }, 5);
  const auto force = test::fakeFunction<double(int)>(PALPATE_FAKE_BARE_DHD, "fakeForce");
  EXPECT_EQ(Vec3(force(0), force(1), force(2)), Vec3(1.0, -2.0, 3.0));
  EXPECT_FALSE(rig.heldAt(0.4));
  EXPECT_FALSE(rig.heldAt(0.1));
}

TEST(ForceDimension, IsListedWithAGripWhereItsLibraryHasTheFunctionForIt)
{
  for (const char* const library : { PALPATE_FAKE_DHD, PALPATE_FAKE_BARE_DHD })
  {
    DeviceOptions options;
    options.hid = std::make_shared<test::FakeHidBus>();
    options.arms = std::make_shared<const std::vector<ArmKit>>(1, forceDimensionKit(library));
    EXPECT_EQ(knownDevices(options).back().hasGrip, std::string(library) == PALPATE_FAKE_DHD);
  }
}

} // namespace
} // namespace palpate
