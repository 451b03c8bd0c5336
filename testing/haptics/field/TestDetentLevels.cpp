// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/field/laws/Detent.h"

namespace palpate
{
namespace
{

TEST(DetentLevels, NearerToEachOtherThanAHollowIsWideShareWhatIsBetweenThem)
{
  DetentPlan plan{ 0.15, 0.0, 2.0, 1.0, false };
  EXPECT_EQ(setLevels(plan, "4 4.5 9"), "");
  const DetentPlan equal{ 0.15, 4.0, 0.5, 1.0, false };
  for (double f = 3.75; f < 4.75; f += 0.0137)
  {
    EXPECT_NEAR(detentEnergy(plan, f).energy, detentEnergy(equal, f).energy, 1e-12) << f;
  }
}

TEST(DetentLevels, ThatCannotBeAreRefusedInWordsAndChangeNothing)
{
  DetentPlan plan;
  EXPECT_EQ(setLevels(plan, "2, 1"), "");
  EXPECT_NE(setLevels(plan, "1, two").find("'two' is not a number"), std::string::npos);
  EXPECT_NE(setLevels(plan, "1, nan").find("'nan' is not a number"), std::string::npos);
  EXPECT_NE(setLevels(plan, "3 1 3").find("the same"), std::string::npos);
  EXPECT_NE(setLevels(plan, "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17").find("at most 16"), std::string::npos);
  EXPECT_EQ(plan.levelCount, 2);
  EXPECT_EQ(plan.levels[0], 1.0);
  EXPECT_EQ(setLevels(plan, " "), "");
  EXPECT_EQ(plan.levelCount, 0);
}

} // namespace
} // namespace palpate
