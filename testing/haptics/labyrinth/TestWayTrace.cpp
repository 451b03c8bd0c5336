// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/labyrinth/WayTrace.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

double distanceTo(const WayTrace& trace, const Vec3& p_W)
{
  double least_u = std::numeric_limits<double>::infinity();
  for (const Vec3& kept_W : trace.points_W())
  {
    least_u = std::min(least_u, (kept_W - p_W).norm());
  }
  return least_u;
}

TEST(WayTrace, StraightWayKeepsAPointPerStepOfThatLength)
{
  WayTrace trace(0.25);
  for (int k = 0; k <= 64; ++k) // steps of 1/16: exact in binary
  {
    trace.add({ k / 16.0, 0, 0 });
  }
  ASSERT_EQ(trace.points_W().size(), 17u);
  for (std::size_t k = 0; k < 17; ++k)
  {
    EXPECT_EQ(trace.points_W()[k], Vec3(0.25 * static_cast<double>(k), 0, 0));
  }
}

TEST(WayTrace, RestingHandAddsNothing)
{
  WayTrace trace(0.25);
  for (int k = 0; k < 100000; ++k)
  {
    trace.add({ 1, 2, 0 });
  }
  EXPECT_EQ(trace.points_W().size(), 1u);
}

TEST(WayTrace, ErrantWayStaysInItsMemoryAndNearToWhatIsKept)
{
  test::Random random(test::testSeed(61));
  constexpr double first_u = 0.01;
  WayTrace trace(first_u);
  std::vector<Vec3> way_W{ Vec3::Zero() };
  for (std::size_t k = 0; k < test::testCount(20000); ++k)
  {
    way_W.push_back(way_W.back() + random.uniform(0.0, 3.0 * first_u) * random.direction());
    trace.add(way_W.back());
    ASSERT_LT(trace.points_W().size(), WayTrace::most);
  }
  EXPECT_GT(trace.apart_u(), first_u) << "the way is too short for this test";
  for (std::size_t k = 0; k < way_W.size(); k += 97)
  {
    EXPECT_LE(distanceTo(trace, way_W[k]), 2.0 * trace.apart_u());
  }
}

TEST(WayTrace, NeighboursAreApart)
{
  test::Random random(test::testSeed(62));
  WayTrace trace(0.01);
  for (std::size_t k = 0; k < test::testCount(20000); ++k)
  {
    trace.add(random.inCube(1.0));
  }
  for (std::size_t k = 1; k < trace.points_W().size(); ++k)
  {
    EXPECT_GE((trace.points_W()[k] - trace.points_W()[k - 1]).norm(), trace.apart_u());
  }
}

} // namespace
} // namespace palpate
