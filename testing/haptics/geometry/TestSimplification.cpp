// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/Simplification.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "haptics/geometry/SheetClearance.h"
#include "haptics/geometry/SurfaceDistance.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

SurfaceTree treeOf(const TriangleMesh& mesh)
{
  return SurfaceTree(cleanMesh(mesh).mesh);
}

/// The furthest vertex or centre of a triangle of `from`.
double sampled(const SurfaceTree& from, const SurfaceTree& to)
{
  double furthest = 0.0;
  for (const auto& [a, b, c] : from.mesh().triangles)
  {
    const auto& v = from.mesh().vertices_W;
    for (const Vec3& x_W : { v[a], v[b], v[c], Vec3((v[a] + v[b] + v[c]) / 3) })
    {
      furthest = std::max(furthest, nearestOn(to.data(), x_W).distance_u);
    }
  }
  return furthest;
}

TEST(Simplification, APlaneOfManyTrianglesBecomesTwo)
{
  Random random(testSeed(4201));
  const int cells = static_cast<int>(std::sqrt(static_cast<double>(testTriangles(5'000)) / 2));
  const SurfaceTree sheet = treeOf(makeSheet({ 1.0, 1.0, cells, cells, 0.3 }, random));
  const Simplification flat = simplifyWithin(sheet, { 1e-9 });
  ASSERT_TRUE(flat.tree) << flat.refusal;
  EXPECT_EQ(flat.tree->mesh().triangles.size(), 2U);
  EXPECT_LE(flat.bound_u, 1e-9);
  EXPECT_LE(sampled(sheet, *flat.tree), 1e-15);
}

TEST(Simplification, ASphereKeepsAboutWhatItsSagittaAsksFor)
{
  constexpr double radius = 50.0, limit = 0.07;
  const SurfaceTree sphere = treeOf(makeIcosphere(6, radius)); // 81,920 triangles
  const Simplification fewer = simplifyWithin(sphere, { limit });
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  // Inscribed triangles spread alike: N = 5.83 R / d for the worst of them, 4 pi R / (3 sqrt 3 d) = 2.42 R / d where
  // all are equilateral; fewer than that cannot stay within d of the sphere with all corners on it.
  const double least = 2.42 * radius / (limit + 5.83 * radius / 81920);
  EXPECT_GE(static_cast<double>(fewer.tree->mesh().triangles.size()), 0.95 * least);
  EXPECT_LE(fewer.tree->mesh().triangles.size(), sphere.mesh().triangles.size() / 2);
  EXPECT_LE(fewer.bound_u, limit);
  EXPECT_GE(fewer.bound_u, sampled(*fewer.tree, sphere));
  EXPECT_GE(fewer.bound_u, sampled(sphere, *fewer.tree));
}

TEST(Simplification, EveryVertexIsOneOfTheOriginals)
{
  const SurfaceTree sphere = treeOf(makeIcosphere(5, 50.0));
  const Simplification fewer = simplifyWithin(sphere, { 0.2 });
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  const auto key = [](const Vec3& v) { return std::tuple(v.x(), v.y(), v.z()); };
  std::set<std::tuple<double, double, double>> known;
  for (const Vec3& v : sphere.mesh().vertices_W)
  {
    known.insert(key(v));
  }
  for (const Vec3& v : fewer.tree->mesh().vertices_W)
  {
    EXPECT_TRUE(known.contains(key(v)));
  }
  EXPECT_EQ(cleanMesh(fewer.tree->mesh()).report.boundaryEdges, 0U);
  EXPECT_FALSE(crossingTriangles(*fewer.tree));
}

TEST(Simplification, NoiseThatIsFeltIsKept)
{
  const SurfaceTree rough = treeOf(NoisySphere(20'000, 1.0).mesh()); // edges of 1.3 mm over waves of 3 mm
  const Simplification none = simplifyWithin(rough, { 0.01 });
  EXPECT_FALSE(none.tree);
  EXPECT_NE(none.refusal.find("half"), std::string::npos);
}

TEST(Simplification, AThinPlateKeepsBothOfItsSides)
{
  Random random(testSeed(4202));
  // Two wavy sheets 0.1 mm apart, coarser than that by far, and a limit of 0.07 mm in which they could meet.
  TriangleMesh lower = makeSheet({ 20.0, 20.0, 100, 100, 0.3 }, random);
  for (Vec3& v : lower.vertices_W)
  {
    v.z() = 0.05 * std::sin(v.x());
  }
  TriangleMesh both = lower;
  append(both, shifted(lower, { 0, 0, 0.1 }));
  EXPECT_FALSE(simplifyWithin(treeOf(both), { 0.07 }).tree);
  // Ten times as far apart they can go, and do not meet.
  TriangleMesh apart = lower;
  append(apart, shifted(lower, { 0, 0, 1.0 }));
  const Simplification fewer = simplifyWithin(treeOf(apart), { 0.07 });
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  EXPECT_FALSE(crossingTriangles(*fewer.tree));
}

TEST(Simplification, RefusesWhatItCannotKeepItsWordFor)
{
  Random random(testSeed(4204));
  EXPECT_NE(
    simplifyWithin(treeOf(makeBox({ 0, 0, 0 }, { 1, 1, 1 })), { 0.01 }).refusal.find("half"), std::string::npos);
  EXPECT_NE(simplifyWithin(treeOf(makeFin()), { 0.01 }).refusal.find("three or more"), std::string::npos);
  EXPECT_FALSE(simplifyWithin(treeOf(makeSoup(300, 1.0, random)), { 0.01 }).tree);
  EXPECT_NE(simplifyWithin(treeOf(makeIcosphere(3, 1.0)), { 0.0 }).refusal.find("above zero"), std::string::npos);
  SimplifyLimits limits{ 0.1 };
  std::stop_source source;
  source.request_stop();
  limits.stop = source.get_token();
  EXPECT_NE(simplifyWithin(treeOf(makeIcosphere(4, 1.0)), limits).refusal.find("stopped"), std::string::npos);
}

TEST(Simplification, SaysHowFarItHasCome)
{
  double last = 0.0;
  SimplifyLimits limits{ 0.5 };
  limits.progress = [&last](double share)
  {
    EXPECT_GE(share, last);
    last = share;
  };
  const Simplification fewer = simplifyWithin(treeOf(makeIcosphere(5, 50.0)), limits);
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  EXPECT_GT(last, 0.5);
}

TEST(SheetClearance, FindsCrossingsAndNothingElse)
{
  Random random(testSeed(4205));
  EXPECT_FALSE(crossingTriangles(treeOf(makeIcosphere(3, 1.0))));
  EXPECT_FALSE(crossingTriangles(treeOf(makeSheet({ 1.0, 1.0, 20, 20, 0.3 }, random))));
  TriangleMesh two = makeIcosphere(3, 1.0);
  append(two, shifted(makeIcosphere(3, 1.0), { 1.5, 0.1, 0.2 }));
  EXPECT_TRUE(crossingTriangles(treeOf(two)));
}

TEST(SheetClearance, SheetsAreApartOrNot)
{
  Random random(testSeed(4206));
  TriangleMesh both = makeSheet({ 1.0, 1.0, 40, 40, 0.2 }, random);
  const std::size_t one = both.vertices_W.size();
  append(both, shifted(makeSheet({ 1.0, 1.0, 40, 40, 0.2 }, random), { 0, 0, 0.1 }));
  const SurfaceTree tree = treeOf(both);
  ASSERT_EQ(tree.mesh().vertices_W.size(), 2 * one);
  const std::vector<bool> apart = verticesNearOtherSheets(tree, 0.09), near = verticesNearOtherSheets(tree, 0.11);
  EXPECT_EQ(std::count(apart.begin(), apart.end(), true), 0);
  EXPECT_EQ(std::count(near.begin(), near.end(), false), 0);
}

} // namespace
} // namespace palpate::test
