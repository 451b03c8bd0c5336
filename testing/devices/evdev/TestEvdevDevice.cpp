// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/evdev/EvdevRig.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using test::EvdevRig;
using test::stickTraits;
using test::VirtualDriver;
using test::wheelTraits;

constexpr std::uint16_t wheelProduct = 0xC24F;

TEST(EvdevDevice, SaysWhatItCanDo)
{
  EvdevRig stick(stickTraits());
  ASSERT_EQ(stick.device.open(), "");
  EXPECT_EQ(stick.device.info().deviceClass, DeviceClass::Joystick2D);
  EXPECT_TRUE(stick.device.info().rendersForce);
  EXPECT_EQ(stick.device.abilitiesNow(), (DeviceAbilities{ 2, true, true, true }));
  EXPECT_NEAR(stick.device.info().resolution_m.value, 2.0 / 65535.0 * stick.scale().halfTravel_m, 1e-12);
  EvdevRig wheel(wheelTraits(), wheelProduct);
  ASSERT_EQ(wheel.device.open(), "");
  EXPECT_EQ(wheel.device.info().deviceClass, DeviceClass::Wheel1D);
  EXPECT_EQ(wheel.device.abilitiesNow(), (DeviceAbilities{ 1, false, false, false }));
}

// D has y away from the person, an event device towards it.
TEST(EvdevDevice, TheForceOfTheCommandReachesTheHandAndThePlaceOfTheHandTheServo)
{
  EvdevRig rig(stickTraits());
  ASSERT_EQ(rig.device.open(), "");
  rig.driver().position = { 0.5, -0.25 };
  rig.driver().push = { -0.2, -0.4 }; // against the force: it stays where it is
  rig.command.wrench_D.force = { 1.0, -2.0, 0.0 };
  rig.run(20);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_NEAR(rig.driver().force()[0], 1.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
  EXPECT_NEAR(rig.driver().force()[1], 2.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), 0.5 * rig.scale().halfTravel_m, 1e-3 * rig.scale().halfTravel_m);
  EXPECT_NEAR(rig.sample.pose_D.p.y(), 0.25 * rig.scale().halfTravel_m, 1e-3 * rig.scale().halfTravel_m);
}

TEST(EvdevDevice, AWheelIsPushedAlongXAloneWhateverIsAskedAlongY)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { -1.5, 3.0, 0.0 };
  rig.run(20);
  EXPECT_NEAR(rig.driver().force()[0], -1.5 / rig.scale().maxForce_N, VirtualDriver::rounding);
  EXPECT_EQ(rig.driver().held(), 1);
  EXPECT_EQ(rig.sample.pose_D.p.y(), 0.0);
}

TEST(EvdevDevice, AForceThatHoldsGoesOnForSecondsAndEndsByItselfOnceNobodyGivesItAgain)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(20);
  const double force = rig.driver().force()[0];
  ASSERT_GT(force, 0.0);
  for (int ms = 0; ms < 3000; ++ms)
  {
    rig.run(1);
    ASSERT_EQ(rig.driver().force()[0], force) << ms;
  }
  rig.bus->advance(rig.options.output.duration_ms);
  EXPECT_EQ(rig.driver().playing(), 0);
  EXPECT_EQ(rig.driver().force()[0], 0.0);
}

// ff-memless lets its timer run while the kernel stores the effect.
TEST(EvdevDevice, AForceThatADriverMissedIsFeltWhenItIsRenewed)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  const double before = rig.driver().force()[0];
  rig.driver().missesNext = true;
  rig.command.wrench_D.force = { -1.0, 0.0, 0.0 };
  rig.run(2);
  ASSERT_EQ(rig.driver().force()[0], before);
  rig.run(rig.options.output.restartEvery_ms);
  EXPECT_NEAR(rig.driver().force()[0], -1.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
}

TEST(EvdevDevice, WithoutANewCommandFor20MillisecondsNothingPushesAndThenTheForceComesBack)
{
  EvdevRig rig(stickTraits());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 1.0, 0.0 };
  rig.run(50);
  ASSERT_NE(rig.driver().force()[0], 0.0);
  for (int ms = 0; ms <= rig.options.output.silence_ms + 1; ++ms)
  {
    rig.pass();
  }
  EXPECT_EQ(rig.driver().playing(), 0);
  rig.run(20);
  EXPECT_NEAR(rig.driver().force()[0], 2.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
}

TEST(EvdevDevice, ClosingLeavesNothingThatPushes)
{
  EvdevRig rig(stickTraits());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 1.0, 0.0 };
  rig.command.viscosity_Ns_per_m = 1.0;
  rig.run(50);
  rig.device.close();
  EXPECT_EQ(rig.driver().held(), 0);
  EXPECT_EQ(rig.driver().force(), (VirtualDriver::Axes{ 0.0, 0.0 }));
  EXPECT_EQ(rig.port.opened, rig.port.closed);
}

// Stiffness K, push f: the hand rests f / K inside the wall, on whichever side.
TEST(EvdevDevice, TheHandRestsAgainstWallsThatTheDriverHolds)
{
  EvdevRig rig(stickTraits());
  ASSERT_EQ(rig.device.open(), "");
  const double half_m = rig.scale().halfTravel_m, K = rig.scale().springStiffness_N_per_m;
  rig.command.wallCount = 2;
  rig.command.walls[0] = { Vec3::UnitX(), -0.3 * half_m, K };
  rig.command.walls[1] = { -Vec3::UnitX(), -0.5 * half_m, K };
  rig.run(rig.options.output.rampUp_ms);
  const double inside = 0.4 / VirtualDriver::springGain;
  rig.driver().push = { 0.4, 0.0 };
  rig.run(3000);
  EXPECT_NEAR(rig.driver().position[0], 0.5 + inside, 1e-3);
  rig.driver().push = { -0.4, 0.0 };
  rig.run(3000);
  EXPECT_NEAR(rig.driver().position[0], -0.3 - inside, 1e-3);
}

TEST(EvdevDevice, WallsAreLeftToTheDriverOnlyOnceItIsBelievedAndClosedByTheHostBefore)
{
  EvdevRig rig(stickTraits());
  rig.device.trust({});
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_FALSE(rig.device.info().abilities.offersWalls());
  EXPECT_TRUE(rig.device.offered().offersWalls());
  const double half_m = rig.scale().halfTravel_m, K = 0.1 * rig.scale().springStiffness_N_per_m;
  rig.command.wallCount = 1;
  rig.command.walls[0] = { Vec3::UnitX(), 0.1 * half_m, K };
  rig.driver().position = { -0.1, 0.0 };
  rig.driver().push = { -0.2, 0.0 }; // as much as the wall gives, so that it stays
  rig.run(20);
  const double expected = K * 0.2 * half_m / rig.scale().maxForce_N;
  EXPECT_NEAR(rig.driver().force()[0], expected, VirtualDriver::rounding + 1e-3);
  EXPECT_EQ(rig.driver().of(FF_SPRING)->u.condition[0].left_coeff, 0);
  rig.device.trust({ true, true });
  rig.run(rig.options.output.rampUp_ms);
  EXPECT_TRUE(rig.device.info().abilities.offersWalls());
  EXPECT_GT(rig.driver().of(FF_SPRING)->u.condition[0].left_coeff, 0);
  EXPECT_EQ(rig.driver().of(FF_CONSTANT)->u.constant.level, 0);
}

// Pushed by f against the handle's own friction b and a damper of B the hand goes at f / (b + B).
TEST(EvdevDevice, ViscosityBrakesTheHandInBothDirections)
{
  EvdevRig rig(stickTraits());
  ASSERT_EQ(rig.device.open(), "");
  rig.command.viscosity_Ns_per_m = 0.5 * rig.scale().damperViscosity_Ns_per_m;
  rig.run(rig.options.output.rampUp_ms);
  const double damper = 0.5 * VirtualDriver::springGain * VirtualDriver::damperMetric;
  for (const double push : { 0.3, -0.3 })
  {
    for (const std::size_t axis : { 0U, 1U })
    {
      rig.driver().push[axis] = push;
    }
    rig.run(500);
    for (const std::size_t axis : { 0U, 1U })
    {
      EXPECT_NEAR(rig.driver().velocity[axis], push / (VirtualDriver::handleFriction + damper), 1e-3) << axis;
    }
  }
}

TEST(EvdevDevice, AWheelThatIsUnpluggedIsLostAndGivesNoForceWhenItComesBackUntilNoneWasAskedForOnce)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(50);
  rig.port.present = false;
  rig.run(2);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  EXPECT_TRUE(test::says(rig.device.linkReport().lostFor, { "unplugged" }));
  rig.port.present = true;
  rig.run(1000);
  EXPECT_EQ(rig.status, DeviceStatus::Ok);
  EXPECT_EQ(rig.driver().force()[0], 0.0);
  rig.command = {};
  rig.run(5);
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(20);
  EXPECT_NEAR(rig.driver().force()[0], 2.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
}

TEST(EvdevDevice, ADriverThatRefusesForcesIsLostWithTheReason)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.port.uploadsThatFail = 1;
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(2);
  EXPECT_EQ(rig.status, DeviceStatus::Lost);
  EXPECT_TRUE(test::says(rig.device.linkReport().lostFor, { "rejects", "Input/output error" }));
  EXPECT_EQ(rig.driver().playing(), 0);
}

// The reader goes on while the kernel waits for the driver.
TEST(EvdevDevice, ADriverThatHangsIsAFaultAfter50Milliseconds)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  ASSERT_EQ(rig.status, DeviceStatus::Ok);
  DeviceStatus before = DeviceStatus::Lost, after = DeviceStatus::Ok;
  rig.port.whileUploading = [&]
  {
    rig.bus->advance(50);
    static_cast<void>(rig.device.link().readPass(0));
    before = rig.device.read(0.0, rig.sample);
    rig.bus->advance(1);
    static_cast<void>(rig.device.link().readPass(0));
    after = rig.device.read(0.0, rig.sample);
  };
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  rig.run(2);
  EXPECT_EQ(before, DeviceStatus::Ok);
  EXPECT_EQ(after, DeviceStatus::Lost);
  EXPECT_EQ(rig.device.linkReport().stalls, 1u);
}

TEST(EvdevDevice, GivesNoForceBeforeTheDeviceHasSaidWhereTheHandIs)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  ASSERT_EQ(rig.device.open(), "");
  rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  for (int ms = 0; ms < 50; ++ms)
  {
    rig.status = rig.device.read(0.0, rig.sample);
    rig.device.write(rig.command);
    rig.pass();
  }
  EXPECT_EQ(rig.status, DeviceStatus::Waiting);
  EXPECT_TRUE(test::says(rig.device.linkReport().message, { "not reported a position", "move" }));
  EXPECT_EQ(rig.driver().force()[0], 0.0);
  rig.run(20);
  EXPECT_NEAR(rig.driver().force()[0], 2.0 / rig.scale().maxForce_N, VirtualDriver::rounding);
}

TEST(EvdevDevice, SaysWhyItCannotBeOpened)
{
  EvdevRig rig(wheelTraits(), wheelProduct);
  rig.port.openProblem = "no permission";
  EXPECT_EQ(rig.device.open(), "\"virtual device\": no permission");
  rig.port.present = false;
  EXPECT_TRUE(test::says(rig.device.open(), { "not attached" }));
}

} // namespace
} // namespace palpate
