// SPDX-License-Identifier: GPL-3.0-or-later
// Never stuck, never through: a long slide over a rough sphere in any unit, at any fineness.
// PALPATE_TEST_TRIANGLES=4000000 PALPATE_TEST_COUNT=30000 is the whole of it: 30 s on every size.
#include <gtest/gtest.h>

#include "haptics/contact/sweep/Work.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

/// Units per millimetre: mm, m, km.
constexpr std::array<double, 3> units = { 1.0, 1e-3, 1e-6 };
constexpr std::array<double, 4> radii_mm = { 0.0, 0.25, 1.0, 2.0 };

std::vector<std::size_t> sizes(std::size_t largest)
{
  std::vector<std::size_t> chosen;
  for (const std::size_t triangles : { 1000u, 10000u, 100000u, 1000000u, 4000000u })
  {
    if (triangles <= testTriangles(largest))
    {
      chosen.push_back(triangles);
    }
  }
  return chosen;
}

/// One slide; every tick must touch, stay outside and lag by no more than depth + r + 1 mm.
void slide(const NoisySphere& sphere, const std::shared_ptr<const Scene>& scene, double r_mm, PathChecker* checker)
{
  const double unit = sphere.unitsPerMillimetre();
  Probe probe(scene, r_mm * unit, slideStart_W(sphere), checker);
  std::size_t capped = 0;
  const std::size_t ticks = testCount(1500);
  for (std::size_t i = 0; i < ticks; ++i)
  {
    const SlidePoint point = slideOver(sphere, i);
    const ContactResult result = probe.to(point.p_W);
    capped += result.capped;
    ASSERT_GT(result.contacts, 0) << "tick " << i;
    ASSERT_FALSE(result.infeasible || result.overBudget || result.seatFailed) << "tick " << i;
    ASSERT_LE((probe.x_W() - point.p_W).norm(), point.depth_u + (r_mm + 1.0) * unit) << "tick " << i;
    const double clearance = probe.x_W().norm() - sphere.surfaceRadius_u(probe.x_W().normalized());
    ASSERT_GE(clearance, -1e-9 * unit) << "tick " << i << ": the centre is inside";
    ASSERT_EQ(probe.finding(), "") << "tick " << i;
  }
  EXPECT_LE(static_cast<double>(capped), 0.001 * static_cast<double>(ticks)); // at most one tick in a thousand
}

class Rough : public ::testing::TestWithParam<std::tuple<std::size_t, double>>
{
};

TEST_P(Rough, EveryTickTouchesAndNoneLagsBehind)
{
  const auto [triangles, unit] = GetParam();
  const NoisySphere sphere(triangles, unit);
  const auto scene = sceneOf(sphere.mesh());
  for (const double r_mm : radii_mm)
  {
    SCOPED_TRACE("radius " + std::to_string(r_mm) + " mm");
    slide(sphere, scene, r_mm, nullptr);
  }
}

INSTANTIATE_TEST_SUITE_P(
  NoisySphere, Rough, ::testing::Combine(::testing::ValuesIn(sizes(100000)), ::testing::ValuesIn(units)));

class RoughPath : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(RoughPath, CrossesNothingInExactArithmetic)
{
  const NoisySphere sphere(GetParam(), 1.0);
  const auto scene = sceneOf(sphere.mesh());
  const TriangleMesh clean = cleanMesh(sphere.mesh()).mesh;
  for (const double r_mm : radii_mm)
  {
    SCOPED_TRACE("radius " + std::to_string(r_mm) + " mm");
    PathChecker checker(clean, r_mm, 1e-9); // row 11: positions are exact to 1e-12 m
    slide(sphere, scene, r_mm, &checker);
  }
}

INSTANTIATE_TEST_SUITE_P(NoisySphere, RoughPath, ::testing::ValuesIn(sizes(10000)));

TEST(NoisySphere, TheMeshIsClosedAndItsRaysAgreeWithItsVertices)
{
  const NoisySphere sphere(1000, 1.0);
  const CleanResult clean = cleanMesh(sphere.mesh());
  EXPECT_EQ(clean.report.trianglesOut, 980u); // 20 * 7^2
  EXPECT_EQ(clean.report.verticesOut, 492u);  // 2 + T / 2
  EXPECT_EQ(clean.report.boundaryEdges + clean.report.nonManifoldEdges + clean.report.duplicate, 0u);
  for (const auto& [a, b, c] : sphere.mesh().triangles)
  {
    const Vec3 centre = (sphere.mesh().vertices_W[a] + sphere.mesh().vertices_W[b] + sphere.mesh().vertices_W[c]) / 3;
    ASSERT_NEAR(sphere.surfaceRadius_u(centre.normalized()), centre.norm(), 1e-9);
  }
}

TEST(NoisySphere, ASlideIsTheSameForAnyOrderOfTriangles)
{
  Random random(testSeed(101));
  const NoisySphere sphere(2000, 1.0);
  for (const double r : { 0.0, 1.0 })
  {
    Probe first(sceneOf(sphere.mesh()), r, slideStart_W(sphere));
    Probe other(sceneOf(shuffled(sphere.mesh(), random)), r, slideStart_W(sphere));
    for (std::size_t i = 0; i < testCount(1000); ++i)
    {
      first.to(slideOver(sphere, i).p_W);
      other.to(slideOver(sphere, i).p_W);
      ASSERT_EQ(other.x_W(), first.x_W()) << "tick " << i;
    }
  }
}

TEST(NoisySphere, NoTickAllocatesOrLocks)
{
  const NoisySphere sphere(10000, 1.0);
  const auto scene = sceneOf(sphere.mesh());
  for (const double r : radii_mm)
  {
    Probe probe(scene, r, slideStart_W(sphere));
    for (std::size_t i = 0; i < testCount(500); ++i)
    {
      const Vec3 p = slideOver(sphere, i).p_W;
      const AllocationGuard guard;
      probe.to(p);
      ASSERT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u) << "tick " << i << ", radius " << r;
    }
  }
}

TEST(NoisySphere, WithASmallBudgetTheBallMovesOnlyAsFarAsIsFree)
{
  const NoisySphere sphere(10000, 1.0);
  const TriangleMesh clean = cleanMesh(sphere.mesh()).mesh;
  for (const double r : { 0.0, 1.0 })
  {
    PathChecker checker(clean, r, 1e-9);
    Probe probe(sceneOf(sphere.mesh()), r, slideStart_W(sphere), &checker);
    probe.plan().workBudget = 30;
    std::size_t over = 0;
    for (std::size_t i = 0; i < testCount(500); ++i)
    {
      const ContactResult result = probe.to(slideOver(sphere, i).p_W);
      over += result.overBudget;
      // A node opens two children before it is counted, and the faces of a leaf are tested before they are.
      ASSERT_LE(result.work, 30u + 2u + 8u * work::pointTest) << "tick " << i;
      ASSERT_EQ(probe.finding(), "") << "tick " << i;
    }
    EXPECT_GT(over, 0u);
  }
}

} // namespace
} // namespace palpate::test
