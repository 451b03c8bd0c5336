// SPDX-License-Identifier: GPL-3.0-or-later
// An implant in a hand that never rests. PALPATE_TEST_FULL=1 is a minute of it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "ImplantRun.h"
#include "Plug.h"

namespace palpate::test
{

TEST(Implant, PutInDrawnAndTurnedMeetsNothingStepsNoForceGivesNoEnergyAndReplaysBitForBit)
{
  const double play_mm = 0.5;
  const PlugSize size;
  ImplantTask task{ shellWithHole(size), plugOf(size, play_mm) };
  task.seconds = std::getenv("PALPATE_TEST_FULL") != nullptr ? 60.0 : task.seconds;
  const ImplantFigures seen = playImplant(task);
  std::cout << describe(seen) << '\n';
  EXPECT_EQ(seen.problem, "");
  EXPECT_EQ(seen.crossings, 0u);
  EXPECT_GE(seen.judged, seen.ticks / 25);
  EXPECT_LE(seen.step_N, 0.2);
  EXPECT_LE(seen.excess_J, 5e-3 * 8.5 / 3.0) << "5 mJ for a device of 3 N";
  EXPECT_LE(seen.seatedOff_mm, play_mm) << "it is where it fits";
  EXPECT_GT(seen.touching, seen.ticks / 4) << "what is not felt shows nothing";
  EXPECT_GT(seen.pressed_N, 1.0);
}

} // namespace palpate::test
