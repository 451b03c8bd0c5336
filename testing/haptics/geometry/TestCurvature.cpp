// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/geometry/measure/Curvature.h"
#include "haptics/geometry/measure/RayWalk.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/TreeOf.h"

namespace palpate::test::curvature
{
namespace
{

std::optional<Curvature> curvatureBelow(const SurfaceTree& tree, const Vec3& from_W, const Vec3& inward_W)
{
  const auto hit = firstHit(tree, from_W, inward_W, 0.0);
  return hit ? curvatureAt(tree, hit->triangle, hit->p_W, -inward_W) : std::nullopt;
}

TEST(Curvature, OfABallIsOneOverItsRadiusInBothDirectionsFromOutsideAndMinusThatFromInside)
{
  Random random(testSeed(41));
  for (const double radius_u : { 1e-6, 1.0, 1e6 })
  {
    const SurfaceTree tree =
      treeOf(makeIcosphere(4, radius_u)); // edges of about 0.08 rad: the fit errs by their square
    for (std::size_t i = 0; i < testCount(100); ++i)
    {
      const Vec3 out_W = random.direction();
      const auto outside = curvatureBelow(tree, 3.0 * radius_u * out_W, -out_W);
      const auto inside = curvatureBelow(tree, Vec3::Zero(), out_W);
      ASSERT_TRUE(outside && inside);
      EXPECT_NEAR(outside->largest_per_u * radius_u, 1.0, 0.02);
      EXPECT_NEAR(outside->least_per_u * radius_u, 1.0, 0.02);
      EXPECT_NEAR(inside->largest_per_u * radius_u, -1.0, 0.02);
      EXPECT_NEAR(inside->least_per_u * radius_u, -1.0, 0.02);
    }
  }
}

TEST(Curvature, OfABallComesNearerToTheTruthAsTheSquareOfItsTriangles)
{
  const auto worst = [](int levels)
  {
    Random random(testSeed(42));
    const SurfaceTree tree = treeOf(makeIcosphere(levels, 1.0));
    double most = 0.0;
    for (std::size_t i = 0; i < 100; ++i)
    {
      const Vec3 out_W = random.direction();
      most = std::max(most, std::abs(curvatureBelow(tree, 3.0 * out_W, -out_W)->mean_per_u() - 1.0));
    }
    return most;
  };
  EXPECT_LT(worst(5), 0.4 * worst(4)); // a quarter, and something for where the random places are
  EXPECT_LT(worst(4), 0.4 * worst(3));
}

/// A sheet of cells over [-1, 1]^2, at a height of each place.
template<class Height>
TriangleMesh sheet(int cells, Height height)
{
  TriangleMesh mesh;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = 2.0 * i / cells - 1.0, y = 2.0 * j / cells - 1.0;
      mesh.vertices_W.emplace_back(x, y, height(x, y));
    }
  }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

TEST(Curvature, OfACylinderIsOneOverItsRadiusAndZero)
{
  const double radius_u = 2.0;
  const SurfaceTree tree = treeOf(sheet(40, [=](double x, double) { return std::sqrt(radius_u * radius_u - x * x); }));
  Random random(testSeed(43));
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const double angle = random.uniform(-0.35, 0.35);
    const Vec3 out_W(std::sin(angle), 0.0, std::cos(angle));
    const auto found = curvatureBelow(tree, 5.0 * out_W + random.uniform(-0.7, 0.7) * Vec3::UnitY(), -out_W);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->largest_per_u, 1.0 / radius_u, 0.01 / radius_u);
    EXPECT_NEAR(found->least_per_u, 0.0, 0.01 / radius_u);
  }
}

TEST(Curvature, OfASaddleHasBothSigns)
{
  const SurfaceTree tree = treeOf(sheet(40, [](double x, double y) { return 0.5 * (x * x - y * y); }));
  const auto found = curvatureBelow(tree, Vec3(0.01, 0.013, 5.0), -Vec3::UnitZ());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->largest_per_u, 1.0, 0.01);
  EXPECT_NEAR(found->least_per_u, -1.0, 0.01);
  EXPECT_NEAR(found->gaussian_per_u2(), -1.0, 0.02);
}

TEST(Curvature, OfABoxIsZeroUpToItsEdges)
{
  const SurfaceTree tree = treeOf(makeBox(Vec3(0, 0, 0), Vec3(1, 2, 3)));
  for (const double x : { 1e-6, 0.3, 1.0 - 1e-6 })
  {
    const auto found = curvatureBelow(tree, Vec3(x, 0.5, 9.0), -Vec3::UnitZ());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->largest_per_u, 0.0);
    EXPECT_EQ(found->least_per_u, 0.0);
  }
}

TEST(Curvature, OfTooFewVerticesIsNotKnown)
{
  TriangleMesh roof; // two triangles that do not lie in a plane
  roof.vertices_W = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0.3 } };
  roof.triangles = { { 0, 1, 2 }, { 1, 2, 3 } };
  EXPECT_FALSE(curvatureBelow(treeOf(roof), Vec3(0.2, 0.2, 5.0), -Vec3::UnitZ()));
}

} // namespace
} // namespace palpate::test::curvature
