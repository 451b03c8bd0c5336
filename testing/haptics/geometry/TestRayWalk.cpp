// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/measure/WallThickness.h"
#include "testing/support/Alternative.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/TreeOf.h"

namespace palpate::test::rays
{
namespace
{

/// CGAL's tree with exact constructions: the judge of our walk.
class ExactRays
{
public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;

  explicit ExactRays(const TriangleMesh& mesh)
  {
    for (const auto& t : mesh.triangles)
    {
      this->triangles_.emplace_back(
        toPoint(mesh.vertices_W[t[0]]), toPoint(mesh.vertices_W[t[1]]), toPoint(mesh.vertices_W[t[2]]));
    }
    this->tree_.rebuild(this->triangles_.begin(), this->triangles_.end());
  }

  [[nodiscard]] std::optional<double> first_u(const Vec3& from_W, const Vec3& direction_W) const
  {
    const Kernel::Ray_3 ray(toPoint(from_W), Kernel::Vector_3(direction_W.x(), direction_W.y(), direction_W.z()));
    const auto hit = this->tree_.first_intersection(ray);
    const auto* const point = hit ? alternative<Kernel::Point_3>(hit->first) : nullptr;
    return point != nullptr
             ? std::optional<double>(std::sqrt(CGAL::to_double(CGAL::squared_distance(*point, toPoint(from_W)))))
             : std::nullopt;
  }

private:
  static Kernel::Point_3 toPoint(const Vec3& p) { return { p.x(), p.y(), p.z() }; }
  Triangles triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>> tree_;
};

TEST(FirstHit, IsWhereCgalHasItAmongRandomTrianglesAndSlivers)
{
  Random random(testSeed(31));
  const TriangleMesh mesh = cleanMesh(makeSoup(300, 1.0, random)).mesh;
  const SurfaceTree tree{ TriangleMesh(mesh) };
  const ExactRays exact(mesh);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 from_W = random.inCube(1.5), direction_W = random.direction();
    const auto ours = firstHit(tree, from_W, direction_W, 0.0);
    const auto theirs = exact.first_u(from_W, direction_W);
    ASSERT_EQ(ours.has_value(), theirs.has_value()) << i;
    if (ours)
    {
      ++hits;
      EXPECT_NEAR(ours->way_u, *theirs, 1e-9) << i; // a sliver's plane loses some digits
    }
  }
  EXPECT_GT(hits, 100u);
}

TEST(FirstHit, NoRaySlipsOutOfASphereThroughAnEdgeOrAVertex)
{
  const SurfaceTree tree = treeOf(makeIcosphere(3, 2.0));
  for (const Vec3& v : tree.mesh().vertices_W)
  {
    const auto hit = firstHit(tree, Vec3::Zero(), v.normalized(), 0.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->way_u, 2.0, 1e-12);
  }
  for (const auto& t : tree.mesh().triangles)
  {
    const Vec3 middle_W = 0.5 * (tree.mesh().vertices_W[t[0]] + tree.mesh().vertices_W[t[1]]);
    const auto hit = firstHit(tree, Vec3::Zero(), middle_W.normalized(), 0.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->way_u, middle_W.norm(), 1e-12);
  }
}

TEST(WallThickness, OfABoxIsItsSideWhereverItIsTouched)
{
  const Vec3 low(-1, 2, 3), high(4, 4, 10);
  const SurfaceTree tree = treeOf(makeBox(low, high));
  Random random(testSeed(32));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    Vec3 p_W(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), random.uniform(low.z(), high.z()));
    const int axis = static_cast<int>(i % 3);
    p_W[axis] = i % 2 == 0 ? low[axis] : high[axis];
    const Vec3 inward_W = (i % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(axis);
    const auto thickness_u = wallThickness_u(tree, p_W, inward_W);
    ASSERT_TRUE(thickness_u);
    EXPECT_DOUBLE_EQ(*thickness_u, high[axis] - low[axis]);
    EXPECT_FALSE(wallThickness_u(tree, p_W, -inward_W)) << "outwards there is nothing";
  }
}

TEST(WallThickness, OfAHollowBallIsTheDifferenceOfItsRadii)
{
  TriangleMesh shell = makeIcosphere(5, 10.0);
  append(shell, makeIcosphere(5, 8.0));
  const SurfaceTree tree = treeOf(shell);
  const double sagitta = 1.0 - std::cos(0.5 * 0.0390); // of the longest edge, 0.0390 rad at that level
  Random random(testSeed(33));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Vec3 out_W = random.direction();
    const auto at = firstHit(tree, 20.0 * out_W, -out_W, 0.0);
    ASSERT_TRUE(at);
    const auto thickness_u = wallThickness_u(tree, at->p_W, -out_W);
    ASSERT_TRUE(thickness_u);
    EXPECT_NEAR(*thickness_u, 2.0, 2.0 * 10.0 * sagitta);
  }
}

TEST(PointSide, OfABoxIsByItsCoordinatesEvenWhereRaysMeetItsEdges)
{
  const SurfaceTree tree = treeOf(makeBox(Vec3(0, 0, 0), Vec3(2, 2, 2)));
  EXPECT_TRUE(isClosed(tree));
  EXPECT_EQ(sideOf(tree, Vec3(1, 1, 1)), PointSide::Inside);
  EXPECT_EQ(sideOf(tree, Vec3(2, 1, 0.5)), PointSide::On);
  Random random(testSeed(34));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 x_W = Vec3(1, 1, 1) + random.inCube(1.5);
    const bool inside = (x_W - Vec3(1, 1, 1)).cwiseAbs().maxCoeff() < 1.0;
    EXPECT_EQ(sideOf(tree, x_W), inside ? PointSide::Inside : PointSide::Outside) << x_W.transpose();
  }
}

TEST(PointSide, OfAHollowBallIsOutsideInItsHollow)
{
  TriangleMesh shell = makeIcosphere(3, 10.0);
  append(shell, makeIcosphere(3, 8.0));
  const SurfaceTree tree = treeOf(shell);
  Random random(testSeed(35));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Vec3 out_W = random.direction();
    EXPECT_EQ(sideOf(tree, 7.5 * out_W), PointSide::Outside);
    EXPECT_EQ(sideOf(tree, 9.0 * out_W), PointSide::Inside);
    EXPECT_EQ(sideOf(tree, 10.1 * out_W), PointSide::Outside);
  }
}

TEST(PointSide, OnlyWhatHasNoHoleIsClosed)
{
  TriangleMesh box = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_TRUE(isClosed(treeOf(box)));
  box.triangles.pop_back();
  EXPECT_FALSE(isClosed(treeOf(box)));
}

} // namespace
} // namespace palpate::test::rays
