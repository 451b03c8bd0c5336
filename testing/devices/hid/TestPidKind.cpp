// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/common/DeviceNotes.h"
#include "devices/hid/pid/PidKind.h"
#include "testing/devices/hid/PidRig.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

PidKind kindOfLayout(const test::PidLayout& layout)
{
  return pidKind(parseReportDescriptor(test::descriptorOf(layout)));
}

TEST(PidKind, IsReadFromTheAxesThatAreSensedAndPushedAndTheEffectsThereAre)
{
  struct Row
  {
    test::PidLayout layout;
    DeviceClass deviceClass;
    std::size_t sensed, pushed;
    HidUsage shaking;
  };
  for (const Row& row : { Row{ test::plainLayout(), DeviceClass::Joystick2D, 2, 2, pid::sine },
         Row{ test::adapterLayout(), DeviceClass::Joystick2D, 2, 2, pid::sine },
         Row{ test::wheelLayout(), DeviceClass::Wheel1D, 1, 1, pid::sine },
         Row{ test::pedalWheelLayout(), DeviceClass::Wheel1D, 1, 1, pid::sine },
         Row{ test::rumbleLayout(), DeviceClass::Vibration0D, 2, 0, pid::sine },
         Row{ test::buzzerLayout(), DeviceClass::Vibration0D, 2, 0, pid::constantForce } })
  {
    const PidKind kind = kindOfLayout(row.layout);
    EXPECT_EQ(kind.problem, "") << row.layout.name;
    EXPECT_EQ(kind.deviceClass, row.deviceClass) << row.layout.name;
    EXPECT_EQ(kind.sensedAxes, row.sensed) << row.layout.name;
    EXPECT_EQ(kind.pushedAxes, row.pushed) << row.layout.name;
    EXPECT_EQ(kind.shaking, row.shaking) << row.layout.name;
  }
}

TEST(PidKind, WhatItCanDoIsWhatItsConditionsCanExpressAndWhatItsPoolPromises)
{
  EXPECT_EQ(promised(kindOfLayout(test::plainLayout())), (DeviceAbilities{ 2, true, true, true }));
  EXPECT_EQ(promised(kindOfLayout(test::oneSidedLayout())), (DeviceAbilities{ 2, true, true, true }));
  // A single coefficient without saturation: nobody would limit the force of a spring or of a damper.
  EXPECT_EQ(promised(kindOfLayout(test::adapterLayout())), (DeviceAbilities{ 2, false, false, true }));
  test::PidLayout bare = test::plainLayout();
  bare.effects = { 0x26 };
  EXPECT_EQ(promised(kindOfLayout(bare)), (DeviceAbilities{ 2, false, false, false }));
  EXPECT_EQ(promised(kindOfLayout(test::rumbleLayout())), (DeviceAbilities{ 2, false, false, true }));
}

TEST(PidKind, WithoutForceAndVibrationItIsRefusedByName)
{
  test::PidLayout springs = test::plainLayout();
  springs.effects = { 0x40, 0x41 };
  EXPECT_TRUE(test::says(kindOfLayout(springs).problem, { "neither", "constant", "vibration" }));
  test::PidRig rig(springs);
  EXPECT_NE(rig.device.open().find("plain stick"), std::string::npos);
}

TEST(PidKind, ThePedalOfAWheelIsNoPartOfTheHand)
{
  test::PidRig rig(test::pedalWheelLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.stick().position = { 0.25, -0.5 };
  rig.command.wrench_D.force = { 1.0, 2.0, 0.0 };
  rig.run(5);
  EXPECT_NEAR(rig.sample.pose_D.p.x(), 0.25 * rig.scale().halfTravel_m, 0.01 * rig.scale().halfTravel_m);
  EXPECT_EQ(rig.sample.pose_D.p.y(), 0.0);
  EXPECT_NEAR(rig.stick().force()[0], 0.2, 1e-3);
  EXPECT_EQ(rig.stick().effectsUsed(), 4); // one force; a spring, a damper, a shake
  EXPECT_EQ(rig.stick().badReports, 0);
}

TEST(PidKind, WhatEachKindCannotDoIsSaid)
{
  const auto notes = [](const test::PidLayout& layout)
  {
    test::PidRig rig(layout);
    return shortcomings(rig.device.info());
  };
  EXPECT_TRUE(test::says(notes(test::plainLayout()),
    { "force along x and y only", "moves along x and y only", "walls of its own", "no device check", "softer" }));
  EXPECT_TRUE(test::says(
    notes(test::wheelLayout()), { "force along x only", "moves along x only", "walls of its own", "no device check" }));
  EXPECT_TRUE(
    test::says(notes(test::rumbleLayout()), { "no directed force", "vibration", "moves along x and y only" }));
  EXPECT_EQ(notes(test::rumbleLayout()).find("walls"), std::string::npos);
  EXPECT_NE(notes(test::adapterLayout()).find("holds no walls itself"), std::string::npos);
  test::PidLayout bare = test::plainLayout();
  bare.effects = { 0x26 };
  EXPECT_TRUE(test::says(notes(bare), { "no viscosity", "cannot vibrate" }));
  test::PidLayout shaky = test::plainLayout();
  std::erase(shaky.effects, 0x41);
  EXPECT_NE(notes(shaky).find("holds walls without viscosity"), std::string::npos);
  EXPECT_EQ(notes(shaky).find("no viscosity"), std::string::npos);
  DeviceInfo ideal;
  ideal.simulated = true;
  EXPECT_EQ(shortcomings(ideal), "");
}

} // namespace
} // namespace palpate
