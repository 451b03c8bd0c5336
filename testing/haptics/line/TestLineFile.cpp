// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "haptics/line/LineFile.h"

namespace palpate
{
namespace
{

TEST(LineFile, ReadsPlacesInAnyOrderOfColumns)
{
  const auto parsed = parseLine("value, s ,friction\r\n12.5,-0.04,0\n17 ,0.04, 0.25\n");
  ASSERT_EQ(parsed.problem, "");
  ASSERT_EQ(parsed.value.size(), 2U);
  EXPECT_EQ(parsed.value[0].s_m, -0.04);
  EXPECT_EQ(parsed.value[1].potential_J, 17.0);
  EXPECT_EQ(parsed.value[1].friction_N, 0.25);
  EXPECT_EQ(parseLine("s,value\n0,1\n1,1").value.size(), 2U); // the last line may end with the file
}

TEST(LineFile, EachWayOfBeingWrongIsNamedWithItsLine)
{
  const std::vector<std::pair<std::string, std::string>> bad = {
    { "", "line 1" },
    { "s,friction\n0,0\n1,0\n", "line 1" },
    { "s,value,value\n0,0,0\n", "line 1" },
    { "s,value,colour\n0,0,0\n", "line 1" },
    { "s,value\n0,0\n", "two positions" },
    { "s,value\n0,0\n1\n", "line 3" },
    { "s,value\n0,0\n1,2,3\n", "line 3" },
    { "s,value\n0,0\n1,x\n", "line 3" },
    { "s,value\n0,0\n1,nan\n", "line 3" },
    { "s,value\n0,0\n1,1e999\n", "line 3" },
    { "s,value\n0,0\n0,1\n", "must grow" },
    { "s,value\n0,0\n\n1,1\n", "line 3" },
  };
  for (const auto& [text, reason] : bad)
  {
    const auto parsed = parseLine(text);
    EXPECT_TRUE(parsed.value.empty()) << text;
    EXPECT_NE(parsed.problem.find(reason), std::string::npos) << reason << " is not in: " << parsed.problem;
  }
}

TEST(LineFile, TheSteepestSlopeDrawsWithTheForceThatWasAskedFor)
{
  LineWorld world;
  world.places = parseLine("s,value\n0,10\n0.01,11\n0.02,15\n0.05,14\n").value;
  scaleToHardest(world.places, 0.5);
  EXPECT_NEAR(lineForce(world, 0.015), -0.5, 1e-12);      // 400 per m
  EXPECT_NEAR(lineForce(world, 0.005), -0.125, 1e-12);    // 100
  EXPECT_NEAR(lineForce(world, 0.03), 0.5 / 12.0, 1e-12); // 33.3, downhill to the right
}

TEST(LineFile, ValuesThatAreAllTheSameStayFlat)
{
  LineWorld world;
  world.places = parseLine("s,value\n0,10\n0.01,10\n").value;
  scaleToHardest(world.places, 0.5);
  EXPECT_EQ(lineForce(world, 0.005), 0.0);
}

} // namespace
} // namespace palpate
