// SPDX-License-Identifier: GPL-3.0-or-later
// What goes to a device when: a signal that was begun.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using Rig = test::PidRig;

// Three reports make a shake, and a report takes a millisecond.
TEST(PidOutput, ASignalOfOneTickIsFelt)
{
  Rig rig(test::plainLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.run(50);
  rig.command.signal = Signal::Oscillation;
  rig.run(1);
  rig.command.signal = Signal::None;
  double strongest = 0.0;
  for (int ms = 0; ms < 100; ++ms)
  {
    rig.run(1);
    strongest = std::max(strongest, std::fabs(rig.stick().force()[0]));
  }
  EXPECT_NEAR(strongest, 0.3, 0.01);
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

} // namespace
} // namespace palpate
