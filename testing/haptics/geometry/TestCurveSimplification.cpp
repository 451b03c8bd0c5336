// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveSimplification.h"
#include "testing/support/Polylines.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

TEST(CurveSimplification, StaysWithinItsErrorAndItsErrorWithinTheTolerance)
{
  test::Random random(test::testSeed(642));
  for (std::size_t i = 0; i < test::testCount(40); ++i)
  {
    const std::vector<Vec3> line_W = test::wavyLine(random.next(), 50 + random.below(300), i % 2 == 0);
    const double tolerance_u = std::pow(10.0, random.uniform(-4.0, -0.5));
    const SimplifiedCurve simple = simplify(line_W, tolerance_u);
    const std::vector<Vec3> kept_W = test::pick(line_W, simple.kept);
    ASSERT_LE(simple.error_u, tolerance_u) << "case " << i;
    ASSERT_LE(test::hausdorffFromBelow(line_W, kept_W), simple.error_u + 1e-12) << "case " << i;
    ASSERT_EQ(kept_W.front(), line_W.front());
    ASSERT_EQ(kept_W.back(), line_W.back());
    ASSERT_TRUE(i % 2 != 0 || kept_W.size() >= 3) << "a ring keeps an inside";
  }
}

// n segments of a circle are off by the sagitta R (1 - cos(pi / n)); halving keeps powers of two.
TEST(CurveSimplification, ACircleKeepsAsManyPointsAsItsSagittaAsks)
{
  const int count = 1024;
  std::vector<Vec3> circle_W;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 2 * std::numbers::pi * (i % count) / count;
    circle_W.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  for (const int segments : { 4, 16, 64, 256 })
  {
    const double sagitta_u = 1.0 - std::cos(std::numbers::pi / segments);
    const SimplifiedCurve simple = simplify(circle_W, sagitta_u * (1 + 1e-9));
    EXPECT_EQ(simple.kept.size(), static_cast<std::size_t>(segments) + 1);
    EXPECT_NEAR(simple.error_u, sagitta_u, 1e-12);
  }
}

TEST(CurveSimplification, KeepsTheTipOfALineThatTurnsBack)
{
  const std::vector<Vec3> hairpin_W{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0.5, 0, 0 } };
  const SimplifiedCurve simple = simplify(hairpin_W, 0.1);
  EXPECT_EQ(simple.kept, (std::vector<std::uint32_t>{ 0, 2, 3 }));
  EXPECT_EQ(simple.error_u, 0.0);
}

TEST(CurveSimplification, LeavesShortOnesAlone)
{
  EXPECT_TRUE(simplify({}, 1.0).kept.empty());
  const std::vector<Vec3> two_W{ { 0, 0, 0 }, { 0.1, 0, 0 } };
  EXPECT_EQ(simplify(two_W, 1.0).kept.size(), 2u);
  EXPECT_EQ(simplify({ two_W.data(), 1 }, 1.0).kept.size(), 1u);
}

} // namespace
} // namespace palpate
