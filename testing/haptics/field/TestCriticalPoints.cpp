// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/CriticalPoints.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

const GridIndex flow_n{ 20, 18, 22 };
constexpr std::size_t all = 1000;

FieldBlock flowOf(const std::function<Vec3(const Vec3&)>& function)
{
  const Vec3 corner_W(3, -4, 5);
  return FieldBlock(1, { flow_n, Vec3(1.0, 0.5, 2.0), { corner_W } },
    { { FieldBlockRole::Vector, "v", test::sampledVectors(flow_n, function) } });
}

TEST(CriticalPoints, OfALinearFlowIsItsOneZeroWhereverItIs)
{
  test::Random random(test::testSeed(1670));
  for (std::size_t i = 0; i < test::testCount(60); ++i)
  {
    const Vec3 zero = Vec3(9.5, 8.5, 10.5) + random.inCube(7.0);
    const Mat3 slope =
      (Mat3() << random.inCube(1.0), random.inCube(1.0), random.inCube(1.0)).finished() + 1.5 * Mat3::Identity();
    const FieldBlock brick = flowOf([&](const Vec3& at) { return Vec3(slope * (at - zero)); });
    const std::vector<Vec3> found = findCriticalPoints(brick, all);
    ASSERT_EQ(found.size(), 1U) << zero.transpose();
    // Floats of up to 60 are known to 4e-6, and the slope is 0.5 at least along every direction for most of these.
    EXPECT_LT((brick.grid().toIndex(found[0]) - zero).norm(), 4e-4);
  }
}

TEST(CriticalPoints, OfWavesAreAllThereAreAndThoseInTheMiddleComeFirst)
{
  // (sin a x, sin b y, sin c z) is 0 at multiples of 5, 6 and 7 points, moved by a half: 4 x 3 x 3 inside of the grid.
  // A trilinear sine has its zero where the straight line between two samples has it: in the middle, by symmetry.
  const auto waves = [](const Vec3& i)
  {
    return Vec3(std::sin(std::numbers::pi * (i.x() - 0.5) / 5.0), std::sin(std::numbers::pi * (i.y() - 0.5) / 6.0),
      std::sin(std::numbers::pi * (i.z() - 0.5) / 7.0));
  };
  const FieldBlock brick = flowOf(waves);
  const std::vector<Vec3> found = findCriticalPoints(brick, all);
  ASSERT_EQ(found.size(), 4U * 3U * 3U);
  double before = 0.0;
  for (const Vec3& place_W : found)
  {
    const Vec3 index = brick.grid().toIndex(place_W);
    const Vec3 whole = (index - Vec3::Constant(0.5)).cwiseQuotient(Vec3(5, 6, 7));
    EXPECT_LT((whole - whole.array().round().matrix()).norm(), 1e-5) << index.transpose();
    const double away = (index - Vec3(9.5, 8.5, 10.5)).norm();
    EXPECT_GE(away, before - 1e-5);
    before = away;
  }
  EXPECT_EQ(findCriticalPoints(brick, 5).size(), 5U);
}

TEST(CriticalPoints, AreNotAtWallsNorWhereValuesAreMissingNorInAStreamThatIsEverywhere)
{
  const auto besideWall = [](const Vec3& i) { return Vec3(std::max(0.0, i.z() - 5.0) * Vec3(1.0, 0.3 * i.x(), 0.2)); };
  EXPECT_TRUE(findCriticalPoints(flowOf(besideWall), all).empty());
  EXPECT_TRUE(findCriticalPoints(flowOf([](const Vec3&) { return Vec3(1, 0, 0); }), all).empty());
  const auto hole = [](const Vec3& i)
  { return i == Vec3(9, 9, 9) ? Vec3(Vec3::Constant(NAN)) : Vec3(i - Vec3(9.3, 9.3, 9.3)); };
  EXPECT_TRUE(findCriticalPoints(flowOf(hole), all).empty());
  EXPECT_TRUE(findCriticalPoints(*test::scalarFieldBlock(8, [](const Vec3& i) { return i.x(); }), all).empty());
}

} // namespace
} // namespace palpate
