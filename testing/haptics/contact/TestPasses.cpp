// SPDX-License-Identifier: GPL-3.0-or-later
// Row 54: how the passes of a tick are spent.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/support/Anywhere.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

/// Where two facets meet at an angle of 1e-4 rad is known ten thousand times worse than where they are: a ball there
/// must not be moved to and fro by rounding until the passes are used up.
TEST(Passes, ABallRestsInAShallowValleyInAFewPasses)
{
  constexpr double r = 2.0, largest = 100.0; // coordinate
  constexpr double gapRounding = 16 * std::numeric_limits<double>::epsilon() * largest;
  Random random(testSeed(121));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    const double slope = std::pow(10.0, random.uniform(-4, -2)), rise = 3 * slope;
    TriangleMesh valley;
    valley.vertices_W = { { -3, 0, 0 }, { 3, 0, 0 }, { -3, 3, rise }, { 3, 3, rise }, { -3, -3, rise },
      { 3, -3, rise } };
    valley.triangles = { { 0, 1, 3 }, { 0, 3, 2 }, { 0, 4, 5 }, { 0, 5, 1 } };
    const Anywhere anywhere(random, 50.0);
    Probe probe(sceneOf(anywhere(valley)), r, anywhere({ 0, 0.1, 2.5 }));
    for (int k = 0; k < 5; ++k)
    {
      // The hand is 4 deep and off the middle by less than 4 slope: both sides hold the ball.
      const ContactResult result = probe.to(anywhere({ 0.1 * k, random.uniform(-1e-4, 1e-4), -2 }));
      ASSERT_LE(result.passes, 10) << "slope " << slope << ", tick " << k;
      const Vec3 off = probe.x_W() - anywhere({ 0.1 * k, 0, r * std::sqrt(1 + slope * slope) });
      ASSERT_LE(off.norm(), gapRounding / slope) << "slope " << slope << ", tick " << k;
    }
  }
}

/// A valley z = 0.3 |y| - 0.02 x^2 in columns of 0.1, whose edges a ball rolls over on both sides at once.
TriangleMesh makeBentValley()
{
  constexpr int columns = 40, rows = 20;
  TriangleMesh mesh;
  for (int i = 0; i <= columns; ++i)
  {
    for (int j = -rows; j <= rows; ++j)
    {
      const double x = -2 + 0.1 * i, y = 0.1 * j;
      mesh.vertices_W.push_back({ x, y, 0.3 * std::fabs(y) - 0.02 * x * x });
    }
  }
  const auto at = [](int i, int j) { return static_cast<std::uint32_t>(i * (2 * rows + 1) + j + rows); };
  for (int i = 0; i < columns; ++i)
  {
    for (int j = -rows; j < rows; ++j)
    {
      mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

TEST(Passes, ABallCrossesAColumnOfFacetsByOneSlideAndOneRoll)
{
  constexpr int columns = 15, toSettle = 10;
  const TriangleMesh valley = makeBentValley();
  Random random(testSeed(122));
  for (const double r : { 0.5, 1.0, 2.0 })
  {
    for (int i = 0; i < 20; ++i)
    {
      const Anywhere anywhere(random, 10.0);
      Probe probe(sceneOf(anywhere(valley)), r, anywhere({ -1, 0.01, r + 1 }));
      probe.to(anywhere({ -1, 0.01, -1 }));
      const ContactResult result = probe.to(anywhere({ -1 + 0.1 * columns, random.uniform(-0.05, 0.05), -1 }));
      ASSERT_LE(result.passes, 2 * columns + toSettle) << "radius " << r << ", place " << i;
    }
  }
}

} // namespace
} // namespace palpate::test
