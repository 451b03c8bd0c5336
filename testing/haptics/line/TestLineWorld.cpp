// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "haptics/line/LineWorld.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A hill of 1 mJ in 10 mm, then a hollow.
LineWorld hill()
{
  LineWorld world;
  world.places = { { -0.05, 0.0, 0.0 }, { 0.0, 0.0, 0.1 }, { 0.01, 1e-3, 0.3 }, { 0.05, -1e-3, 0.3 } };
  return world;
}

TEST(LineWorld, AHandIsDrawnDownhillByTheSlopeOfTheValue)
{
  const LineWorld world = hill();
  EXPECT_DOUBLE_EQ(lineForce(world, -0.02), 0.0);
  EXPECT_DOUBLE_EQ(lineForce(world, 0.005), -1e-3 / 0.01);
  EXPECT_DOUBLE_EQ(lineForce(world, 0.03), 2e-3 / 0.04);
}

TEST(LineWorld, BeyondAStopItIsASpringToTheStop)
{
  const LineWorld world = hill();
  EXPECT_DOUBLE_EQ(lineForce(world, 0.06), world.stop_N_per_m * (0.05 - 0.06));
  EXPECT_DOUBLE_EQ(lineForce(world, -0.06), world.stop_N_per_m * (-0.05 + 0.06));
  EXPECT_NEAR(lineForce(world, 0.05 + 1e-12), 0.0, 1e-9);
}

TEST(LineWorld, ADetentDrawsToItsMiddleAndHardestHalfWayToTheNext)
{
  LineWorld world = hill();
  for (LinePlace& place : world.places)
  {
    place.potential_J = 0.0;
  }
  world.detentEvery_m = 0.008;
  world.detent_N = 0.4;
  for (const int detent : { -5, -1, 0, 2, 6 })
  {
    const double middle_m = detent * world.detentEvery_m;
    EXPECT_NEAR(lineForce(world, middle_m), 0.0, 1e-12);
    EXPECT_NEAR(lineForce(world, middle_m + 0.001), -0.1, 1e-12); // a quarter of the distance to the half
    EXPECT_NEAR(lineForce(world, middle_m + 0.0039999), -0.4, 1e-4);
    EXPECT_NEAR(lineForce(world, middle_m - 0.0039999), 0.4, 1e-4);
  }
}

/// The potential that the formulas in the header mean.
double potential(const LineWorld& world, double s_m)
{
  const LinePlace &first = world.places.front(), &last = world.places.back();
  if (s_m < first.s_m || s_m > last.s_m)
  {
    const LinePlace& stop = s_m < first.s_m ? first : last;
    const double beyond_m = s_m - stop.s_m;
    return stop.potential_J + 0.5 * world.stop_N_per_m * beyond_m * beyond_m;
  }
  std::size_t i = 1;
  while (world.places[i].s_m < s_m)
  {
    ++i;
  }
  const LinePlace &a = world.places[i - 1], &b = world.places[i];
  const double way = std::remainder(s_m, world.detentEvery_m);
  return a.potential_J + (b.potential_J - a.potential_J) * (s_m - a.s_m) / (b.s_m - a.s_m) +
         0.5 * (2.0 * world.detent_N / world.detentEvery_m) * way * way;
}

TEST(LineWorld, IsTheSlopeOfOnePotentialSoThatNoClosedWayGivesWork)
{
  test::Random random(test::testSeed(531));
  LineWorld world = hill();
  world.detentEvery_m = 0.007;
  world.detent_N = 0.2;
  constexpr double h_m = 1e-7;
  for (std::size_t run = 0; run < test::testCount(300); ++run)
  {
    const double s_m = random.uniform(-0.06, 0.06);
    const double slope_N = (potential(world, s_m - h_m) - potential(world, s_m + h_m)) / (2.0 * h_m);
    const double left_N = lineForce(world, s_m - 2.0 * h_m), right_N = lineForce(world, s_m + 2.0 * h_m);
    EXPECT_GE(slope_N, std::min(left_N, right_N) - 1e-4) << s_m; // at a kink between the two
    EXPECT_LE(slope_N, std::max(left_N, right_N) + 1e-4) << s_m;
  }
}

TEST(LineWorld, FrictionHoldsAtRestAndBrakesWithWhatThePlaceHas)
{
  const LineWorld world = hill();
  double anchor_m = 0.02;
  EXPECT_NEAR(lineFriction(world, 0.0205, anchor_m), -world.stop_N_per_m * 0.0005, 1e-12); // 0.1 of 0.3 N: it holds
  EXPECT_NEAR(anchor_m, 0.02, 1e-15);
  EXPECT_NEAR(lineFriction(world, 0.03, anchor_m), -0.3, 1e-12); // it slides
  EXPECT_NEAR(lineFriction(world, 0.005, anchor_m), 0.2, 1e-12); // half way from 0.1 to 0.3 N, the other way
}

TEST(LineWorld, FrictionTakesWorkOverEveryClosedWay)
{
  test::Random random(test::testSeed(532));
  const LineWorld world = hill();
  double s_m = 0.0, anchor_m = 0.0, work_J = 0.0;
  for (std::size_t step = 0; step < test::testCount(2000); ++step)
  {
    const double next_m = std::clamp(s_m + random.uniform(-2e-3, 2e-3), -0.05, 0.05);
    work_J += lineFriction(world, next_m, anchor_m) * (next_m - s_m); // held over the displacement there at the least
    s_m = next_m;
  }
  work_J += lineFriction(world, 0.0, anchor_m) * (0.0 - s_m);
  EXPECT_LT(work_J, 0.0);
}

TEST(LineWorld, WhatCannotBeFeltIsRefusedWithItsReason)
{
  const auto refusalOf = [](const std::function<void(LineWorld&)>& change, double largest_N_per_m = unlimited)
  {
    LineWorld world = hill();
    change(world);
    return world.refusal(largest_N_per_m);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusalOf([](LineWorld&) {}), "");
  EXPECT_NE(refusalOf([](LineWorld& w) { w.places.resize(1); }).find("two positions"), std::string::npos);
  EXPECT_NE(refusalOf([&](LineWorld& w) { w.places[2].potential_J = nan; }).find("place 3"), std::string::npos);
  EXPECT_NE(refusalOf([](LineWorld& w) { w.places[1].friction_N = -1.0; }).find("place 2"), std::string::npos);
  EXPECT_NE(refusalOf([](LineWorld& w) { w.places[3].s_m = 0.01; }).find("beyond the previous one"), std::string::npos);
  EXPECT_NE(refusalOf([&](LineWorld& w) { w.detentEvery_m = nan; }).find("detents"), std::string::npos);
  EXPECT_NE(refusalOf([](LineWorld& w) { w.stop_N_per_m = 0.0; }).find("stops"), std::string::npos);
  const std::string stiff = refusalOf(
    [](LineWorld& w)
    {
      w.detentEvery_m = 0.01;
      w.detent_N = 2.0;
    },
    300.0); // 2 * 2 N / 10 mm
  EXPECT_TRUE(test::says(stiff, { "400 N/m", "300 can be rendered" })) << stiff;
}

} // namespace
} // namespace palpate
