// SPDX-License-Identifier: GPL-3.0-or-later
// The order of reports to a device: a signal that was begun, and walls that go.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using Rig = test::PidRig;

// The effects in the order in which they are made.
constexpr int springBlock = 3, damperBlock = 4;

DeviceCommand unlikeCorridors(const PidScale& scale)
{
  DeviceCommand command;
  const double half_m = scale.halfTravel_m, K = scale.springStiffness_N_per_m;
  command.wallCount = 4;
  command.walls = { { { Vec3::UnitX(), -0.3 * half_m, K }, { -Vec3::UnitX(), -0.5 * half_m, K },
    { Vec3::UnitY(), -0.2 * half_m, K }, { -Vec3::UnitY(), -0.2 * half_m, K } } };
  command.viscosity_Ns_per_m = scale.damperViscosity_Ns_per_m;
  return command;
}

/// The largest coefficient that the device has for any side of any axis of an effect.
double stiffest(Rig& rig, int block)
{
  const Condition &x = rig.stick().condition(block, 0), &y = rig.stick().condition(block, 1);
  return std::max({ x.negativeCoefficient, x.positiveCoefficient, y.negativeCoefficient, y.positiveCoefficient });
}

/// The strongest that is felt along x in that time.
double strongest(Rig& rig, int duration_ms)
{
  double most = 0.0;
  for (int ms = 0; ms < duration_ms; ++ms)
  {
    rig.run(1);
    most = std::max(most, std::fabs(rig.stick().force()[0]));
  }
  return most;
}

// Three reports make a shake, and a report takes a millisecond. The shake has a period of 20 ms and would last for 200
// ms; a caller asks for it as long as the hand is to be shaken.
TEST(PidOutput, ASignalIsFeltWhileItIsAskedForAndEndsAtOnceWithTheCommand)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.command.signal = Signal::Oscillation;
  EXPECT_NEAR(strongest(rig, 3 + 20), 0.3, 0.01);
  rig.command = {}; // as when the dead-man is let go
  rig.run(1);
  EXPECT_EQ(strongest(rig, 300), 0.0);
  rig.command.signal = Signal::Oscillation;
  EXPECT_NEAR(strongest(rig, 3 + 20), 0.3, 0.01);
}

TEST(PidOutput, ASignalThatIsTakenBackBeforeItsThirdReportIsNotFelt)
{
  for (const int reports : { 1, 2 })
  {
    Rig rig(test::plainLayout());
    ASSERT_EQ(rig.device.open(), "");
    rig.run(50);
    rig.command.signal = Signal::Oscillation;
    rig.run(reports);
    rig.command.signal = Signal::None;
    EXPECT_EQ(strongest(rig, 300), 0.0) << reports;
  }
}

TEST(PidOutput, ASignalThatWasBegunEndsWithEverythingElseWhenTheServoFallsSilent)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.command.signal = Signal::Oscillation;
  rig.run(1);
  for (int ms = 0; ms < 40; ++ms)
  {
    rig.bus->advance(1);
  }
  for (int ms = 0; ms < 100; ++ms)
  {
    rig.pass();
    EXPECT_EQ(rig.stick().force()[0], 0.0);
  }
}

// Walls that move are sent every 16 ms; four reports take them away.
TEST(PidOutput, WallsAndViscosityThatGoAreTakenAwayAtOnce)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command = unlikeCorridors(rig.scale());
  rig.run(test::ramped_ms);
  ASSERT_NEAR(stiffest(rig, springBlock), 1.0, 1e-3);
  ASSERT_NEAR(stiffest(rig, damperBlock), 1.0, 1e-3);
  rig.command.walls[0].offset_m *= 0.9;
  rig.run(3);
  rig.command = {};
  rig.run(4 + 1);
  EXPECT_EQ(stiffest(rig, springBlock), 0.0);
  EXPECT_EQ(stiffest(rig, damperBlock), 0.0);
}

TEST(PidOutput, AWallThatGoesIsTakenAwayAtOnceWhereBothSidesShareACoefficient)
{
  test::PidLayout layout = test::plainLayout();
  std::erase_if(layout.condition, [](const test::PidNumber& number) { return number.usage == 0x62; });
  Rig rig(layout);
  ASSERT_EQ(rig.device.open(), "");
  rig.command = unlikeCorridors(rig.scale());
  rig.run(test::ramped_ms);
  rig.command.walls[2].offset_m *= 0.9;
  rig.run(3);
  rig.command.walls[0] = rig.command.walls[1]; // the lower wall goes
  rig.run(4 + 1);
  const Condition& x = rig.stick().condition(springBlock, 0);
  EXPECT_NEAR(x.centre - x.deadBand, -1.0, 1e-3);
  EXPECT_NEAR(x.centre + x.deadBand, 0.5, 1e-3);
}

// And its end is no sign of another program: the device says that its spring has stopped.
TEST(PidOutput, WallsThatAreBelievedNoMoreEndAtOnceAndTheDeviceIsNotLost)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command = unlikeCorridors(rig.scale());
  rig.run(test::ramped_ms);
  rig.device.trust({});
  rig.run(5);
  EXPECT_EQ(rig.stick().effectsPlaying(), 2); // the forces
  rig.run(500);
  EXPECT_EQ(rig.lostTicks, 0);
}

// Each of the six reports, settings included, comes at least every seventh millisecond, or eleventh when all effects
// are armed again.
TEST(PidOutput, WhileStiffnessFallsEachAxisFollowsAndTheForceGetsItsTurn)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  const DeviceCommand whole = unlikeCorridors(rig.scale());
  rig.command = whole;
  rig.run(test::ramped_ms);
  constexpr int fall_ms = 200, late_ms = 2 * (7 + 4);
  const int forces = rig.stick().constantForces;
  for (int ms = 1; ms <= fall_ms; ++ms)
  {
    const double share = 1.0 - ms / static_cast<double>(fall_ms);
    for (std::size_t i = 0; i < 4; ++i)
    {
      rig.command.walls[i].stiffness_N_per_m = share * whole.walls[i].stiffness_N_per_m;
    }
    rig.command.viscosity_Ns_per_m = share * whole.viscosity_Ns_per_m;
    rig.command.wrench_D.force = { share, share, 0.0 };
    rig.run(1);
    const double most = share + late_ms / static_cast<double>(fall_ms);
    ASSERT_LE(stiffest(rig, springBlock), most) << ms;
    ASSERT_LE(stiffest(rig, damperBlock), most) << ms;
  }
  EXPECT_GE(rig.stick().constantForces - forces, fall_ms / late_ms);
}

} // namespace
} // namespace palpate
