// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/tool/certify/TrianglePair.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

TEST(NearestPair, OfEdgesThatAreNearlyParallelIsTheirCommonPerpendicularAtAnySmallAngle)
{
  Random random(testSeed(2851));
  for (int i = 0; i < 2000; ++i)
  {
    // Two long edges cross at a height above one another; each triangle lies on its own side of the gap.
    const double angle_rad = std::pow(10.0, random.uniform(-6, -1)), height = std::pow(10.0, random.uniform(-6, -3));
    const Vec3 along(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    const Vec3 shift = random.inCube(50.0), up = height * Vec3::UnitZ();
    const Corners tool_W{ shift + up - random.uniform(5, 20) * along, shift + up + random.uniform(5, 20) * along,
      shift + up + Vec3(random.uniform(-5, 5), 3.0, random.uniform(1, 9)) };
    const Corners scene_W{ shift - random.uniform(5, 40) * Vec3::UnitX(), shift + random.uniform(5, 40) * Vec3::UnitX(),
      shift + Vec3(random.uniform(-5, 5), 3.0, -random.uniform(1, 9)) };
    const NearestPair nearest = nearestPair(tool_W, scene_W);
    // Corners are rounded by a few of this; the place of the crossing along the edges by 1 / angle^2 of it, which lies
    // as much / angle beside the perpendicular.
    constexpr double rounding = 8.0 * 60.0 * std::numeric_limits<double>::epsilon();
    const double beside = rounding / angle_rad;
    EXPECT_NEAR(nearest.distance_u, height, rounding + 0.5 * beside * beside / height) << angle_rad;
    EXPECT_GE(gapAlong(nearest.n, tool_W, scene_W), height - rounding - 0.5 * beside * beside / height) << angle_rad;
  }
}

} // namespace
} // namespace palpate::test
