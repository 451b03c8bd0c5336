// SPDX-License-Identifier: GPL-3.0-or-later
// What a ball hits on its way, where faces meet at angles near rounding.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "haptics/contact/Sweep.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

/// Two unit squares in z = 0 that meet at x = 0.
TriangleMesh twoSquares()
{
  return { { { -1, -1, 0 }, { 0, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 } } };
}

TEST(Sweep, ABallThatSinksByLessThanRoundingBeforeItComesOverAFaceIsStoppedByIt)
{
  const auto scene = sceneOf(twoSquares());
  SweepQuery query;
  query.radius_u = 1.0;
  query.resolution.include({ 1, 1, 1 });
  const double tol_u = query.resolution.tol();
  for (const double sinks_u : { 3 * tol_u, 1e-12, 1e-9, 1e-8 })
  {
    // Steeper than sqrt(2 tol / r) = 1.7e-7 it would meet the edge between them. Both squares are touched at the start;
    // over the second one it comes after a tenth of the tolerance of depth.
    const double before = std::min(0.5, 0.1 * tol_u / sinks_u);
    query.from_W = { -0.5 * before, 0.25, 1.0 };
    query.to_W = { 0.5 * (1 - before), 0.25, 1.0 - sinks_u };
    const SweepHit first = sweepBall(*scene, query, 1000);
    ASSERT_TRUE(first.hit) << sinks_u; // the square it is over
    const std::array touched = { first.feature };
    query.touched = touched;
    const SweepHit second = sweepBall(*scene, query, 1000);
    query.touched = {};
    ASSERT_TRUE(second.hit) << sinks_u;
    EXPECT_EQ(second.feature.kind, FeatureKind::Face);
    EXPECT_NE(second.feature.a, first.feature.a);
    EXPECT_NEAR(second.t, before, 1e-12);
  }
}

} // namespace
} // namespace palpate::test
