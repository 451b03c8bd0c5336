// SPDX-License-Identifier: GPL-3.0-or-later
// Another program's effects on our device, seen where the device says nothing of it.
#include <gtest/gtest.h>

#include "testing/devices/hid/ModelCases.h"
#include "testing/devices/hid/PidRig.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using Rig = test::PidRig;

constexpr int noticed_ms = 250;

test::PidLayout silentLayout()
{
  test::PidLayout layout = test::plainLayout();
  layout.habits.wipesSilently = true;
  return layout;
}

TEST(PidWatch, AnUploadByAnotherProgramIsNoticedWithinAQuarterSecondAndSaidWithTheCure)
{
  for (const test::PidLayout& layout : { silentLayout(), test::adapterLayout(), test::hobbyLayout() })
  {
    Rig rig(layout);
    ASSERT_EQ(rig.device.open(), "");
    rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    rig.run(333);
    ASSERT_EQ(rig.lostTicks, 0) << layout.name;
    rig.port.openProblem = "busy";
    rig.stick().uploadFromElsewhere();
    rig.run(noticed_ms);
    EXPECT_GT(rig.lostTicks, 0) << layout.name;
    EXPECT_EQ(rig.stick().force()[0], 0.0) << layout.name;
    const std::string said = rig.device.linkReport().lostFor;
    EXPECT_TRUE(test::says(said, { "close that program", "evdev", "plugin/README.md" }));
  }
}

TEST(PidWatch, AModelOfASilentFirmwareIsSeenToBeTakenToo)
{
  for (const test::ModelCase& one : test::modelCases())
  {
    Rig rig(one.model, one.descriptor);
    ASSERT_EQ(rig.device.open(), "");
    rig.run(200);
    rig.port.openProblem = "busy";
    one.model->wipe();
    const std::uint8_t create = one.name == "OpenFFBoard" ? 0x11 : 5;
    ASSERT_TRUE(one.model->take(HidReportKind::Feature, std::vector<std::uint8_t>{ create, 1, 0, 0 }));
    rig.run(noticed_ms);
    EXPECT_GT(rig.lostTicks, 0) << one.name;
  }
}

TEST(PidWatch, EffectsOfOurOwnAndALongUseAreNoDisturbance)
{
  for (const test::PidLayout& layout : test::allLayouts())
  {
    Rig rig(layout);
    ASSERT_EQ(rig.device.open(), "");
    rig.command.wrench_D.force = { 1.0, 0.5, 0.0 };
    rig.run(3000);
    EXPECT_EQ(rig.lostTicks, 0) << layout.name;
  }
}

// The answers are missing: the device is used all the same.
TEST(PidWatch, ADeviceThatStopsAnsweringOrAnswersOtherwiseEachTimeIsNotAskedOn)
{
  Rig rig(silentLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.port.featureTimesOut = true;
  rig.run(500);
  rig.port.featureTimesOut = false;
  rig.run(500);
  EXPECT_EQ(rig.lostTicks, 0);
}

} // namespace
} // namespace palpate
