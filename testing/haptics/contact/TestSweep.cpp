// SPDX-License-Identifier: GPL-3.0-or-later
// Hits of a ball on its path, where faces meet at angles near rounding.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/contact/sweep/Sweep.h"
#include "testing/support/ExactTriangles.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

struct Piece
{
  Vec3 from_W, to_W;
};

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

/// A path of a point through or just beside a triangle, up to ten thousand times as long, mostly nearly upright on it:
/// there single precision would lose how far it passes from the middle.
Piece wayNear(const std::array<Vec3, 3>& corners, Random& random)
{
  const auto& [a, b, c] = corners;
  const double u = random.uniform(-0.1, 1.1), v = random.uniform(-0.1, 1.1 - u);
  const Vec3 through = a + u * (b - a) + v * (c - a), upright = (b - a).cross(c - a).normalized();
  const double tilt = std::pow(10.0, random.uniform(-6, 0));
  const Vec3 direction = (upright + tilt * random.direction()).normalized();
  const double length_u = std::pow(10.0, random.uniform(-1, 4)) * (b - a).norm(), share = random.uniform();
  return { through - share * length_u * direction, through + (1 - share) * length_u * direction };
}

TEST(Sweep, ALongWayOfAPointMeetsWhatRationalArithmeticSaysAtEveryScale)
{
  Random random(testSeed(2711));
  std::size_t met = 0;
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const double size_u = std::pow(10.0, random.uniform(-30, 30));
    const Vec3 a = random.inCube(size_u), b = a + random.inCube(size_u);
    const Vec3 c = a + random.uniform() * (b - a) + std::pow(10.0, random.uniform(-6, 0)) * random.inCube(size_u);
    const TriangleMesh mesh{ { a, b, c }, { { 0, 1, 2 } } };
    const Piece way = wayNear({ a, b, c }, random);
    const bool truth = CGAL::do_intersect(segmentOf<Rational>(way.from_W, way.to_W), triangleOf<Rational>(mesh, 0));
    met += truth;
    ASSERT_EQ(sweepBall(*sceneOf(mesh), straightQuery(way.from_W, way.to_W), 1000).hit, truth)
      << "way " << i << ", size " << size_u;
  }
  EXPECT_GT(met, testCount(20000) / 4);
}

/// The moment a ball comes beside an edge along which it goes, worked out in the edge's own frame: the edge is the x
/// axis from 0 to 1, the ball sinks towards it and is at its distance before it has come to its end.
TEST(Sweep, ABallThatComesBesideAnEdgeItSinksToIsStoppedThere)
{
  // A fin that stands on the edge downwards: nothing but the edge and its ends can be met from above.
  const TriangleMesh fin{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, -1 } }, { { 0, 1, 2 } } };
  const auto scene = sceneOf(fin);
  SweepQuery query;
  query.radius_u = 1e-6;
  query.resolution.include({ 1, 1, 1 });
  const double tol_u = query.resolution.tol();
  for (const double sinks_u : { 1e-9, 1e-8, 1e-7 })
  {
    // It begins a hundredth of the tolerance before the end, as far away as the radius.
    const double before_u = 0.01 * tol_u;
    query.from_W = { -before_u, 0, query.radius_u };
    query.to_W = { 0.5, 0, query.radius_u - sinks_u };
    const SweepHit hit = sweepBall(*scene, query, 1000);
    ASSERT_TRUE(hit.hit) << sinks_u;
    EXPECT_LE(hit.t * 0.5, 4 * tol_u) << sinks_u;
  }
}

} // namespace
} // namespace palpate::test
