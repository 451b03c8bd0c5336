// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/SurfacePath.h"
#include "testing/support/Meshes.h"
#include "testing/support/NearestPoints.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "testing/support/TreeOf.h"

namespace palpate::test::ways
{
namespace
{

/// It lies on the surface, begins and ends where it should, and is as long as it says.
void expectIsWayOver(const TriangleMesh& mesh, const SurfacePath& path, const Vec3& from_W, const Vec3& to_W)
{
  ASSERT_EQ(path.problem, "");
  ASSERT_GE(path.points_W.size(), 2u);
  EXPECT_LT((path.points_W.front() - from_W).norm(), 1e-9);
  EXPECT_LT((path.points_W.back() - to_W).norm(), 1e-9);
  const NearestPoints near(mesh);
  double length_u = 0.0;
  for (std::size_t i = 1; i < path.points_W.size(); ++i)
  {
    const Vec3 &a = path.points_W[i - 1], &b = path.points_W[i];
    length_u += (b - a).norm();
    for (const double share : { 0.0, 0.31, 0.5, 0.77, 1.0 })
    {
      EXPECT_LT(near.distance_u(a + share * (b - a)), 1e-9);
    }
  }
  EXPECT_NEAR(length_u, path.length_u, 1e-9);
}

/// From (x, y) on the top of the unit cube to (y, z) on its side x = 1: straight in the best of the unfoldings.
double unfolded(double x, double y, double toY, double toZ)
{
  const double over = std::hypot((1.0 - x) + (1.0 - toZ), y - toY);
  const double overBack = std::hypot((1.0 - x) + (1.0 - toY), (1.0 - y) + (1.0 - toZ));
  const double overFront = std::hypot((1.0 - x) + toY, y + (1.0 - toZ));
  return std::min({ over, overBack, overFront });
}

TEST(SurfacePath, OverACubeIsAsLongAsItsUnfoldingIsStraight)
{
  const TriangleMesh cube = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const SurfaceTree tree = treeOf(cube);
  Random random(testSeed(51));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Vec3 from_W(random.uniform(), random.uniform(), 1.0), to_W(1.0, random.uniform(), random.uniform());
    const SurfacePath path = shortestPath(tree, from_W, to_W);
    expectIsWayOver(cube, path, from_W, to_W);
    EXPECT_NEAR(path.length_u, unfolded(from_W.x(), from_W.y(), to_W.y(), to_W.z()), 1e-9) << i;
  }
}

TEST(SurfacePath, FromCornerToOppositeCornerOfACubeIsTheRootOfFive)
{
  const SurfaceTree tree = treeOf(makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  EXPECT_NEAR(shortestPath(tree, Vec3(0, 0, 0), Vec3(1, 1, 1)).length_u, std::sqrt(5.0), 1e-12);
}

TEST(SurfacePath, OverATessellatedPlaneIsStraightFromVertexToVertexOfARegularGridToo)
{
  Random random(testSeed(52));
  for (const double jitter : { 0.0, 0.2 }) // more would fold it
  {
    const Quat turn = shortestTurn(Vec3::UnitZ(), Vec3(1, 2, 3));
    const SurfaceTree tree = treeOf(rotated(makeSheet({ 20.0, 20.0, 30, 30, jitter }, random), turn));
    const auto& vertices = tree.mesh().vertices_W;
    for (std::size_t i = 0; i < testCount(400); ++i)
    {
      const Vec3& from_W = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
      const Vec3& to_W = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
      ASSERT_NEAR(shortestPath(tree, from_W, to_W).length_u, (to_W - from_W).norm(), 1e-9) << i;
    }
  }
}

// The nearest point of a convex body is a map that lengthens no path (Busemann & Feller 1936): from the sphere to the
// polyhedron in it, and from there to the ball inside.
TEST(SurfacePath, OverAPolyhedronInASphereIsNoLongerThanTheGreatCircleAndNoShorterThanThatOfTheBallInside)
{
  const TriangleMesh sphere = makeIcosphere(4, 1.0);
  const SurfaceTree tree = treeOf(sphere);
  double inner = 1.0;
  for (const auto& t : sphere.triangles)
  {
    const Vec3 &a = sphere.vertices_W[t[0]], &b = sphere.vertices_W[t[1]], &c = sphere.vertices_W[t[2]];
    inner = std::min(inner, std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  Random random(testSeed(53));
  for (std::size_t i = 0; i < testCount(20); ++i)
  {
    const auto& vertices = tree.mesh().vertices_W;
    const Vec3& from_W = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
    const Vec3& to_W = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
    const double angle = std::atan2(from_W.cross(to_W).norm(), from_W.dot(to_W));
    const SurfacePath path = shortestPath(tree, from_W, to_W);
    ASSERT_EQ(path.problem, "");
    EXPECT_LE(path.length_u, angle * (1.0 + 1e-12));
    EXPECT_GE(path.length_u, inner * angle * (1.0 - 1e-12));
  }
}

TEST(SurfacePath, BetweenPartsThatDoNotHangTogetherIsRefused)
{
  TriangleMesh two = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  append(two, makeBox(Vec3(5, 0, 0), Vec3(6, 1, 1)));
  const SurfacePath path = shortestPath(treeOf(two), Vec3(0.5, 0.5, 1), Vec3(5.5, 0.5, 1));
  EXPECT_TRUE(test::says(path.problem, { "points", "surface", "connected" }));
  EXPECT_TRUE(path.points_W.empty());
  EXPECT_EQ(shortestPath(treeOf(two), Vec3(0, 0, NAN), Vec3(0, 0, 1)).problem, "a point is not finite");
}

TEST(SurfacePath, WithinATriangleIsTheStraightLineBetweenTheNearestPoints)
{
  const SurfaceTree tree = treeOf(makeBox(Vec3(0, 0, 0), Vec3(4, 4, 4)));
  const SurfacePath path = shortestPath(tree, Vec3(3.0, 0.5, 5.0), Vec3(3.5, 0.7, 4.5)); // above the top
  EXPECT_NEAR(path.length_u, std::hypot(0.5, 0.2), 1e-12);
}

} // namespace
} // namespace palpate::test::ways
