// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/Simplification.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "haptics/geometry/simplify/SheetClearance.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "testing/support/Meshes.h"
#include "testing/support/NearestPoints.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/SoupMaker.h"
#include "testing/support/TreeOf.h"

namespace palpate::test
{
namespace
{

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
  TriangleMesh curve;
  curve.vertices_W = { { 0, 0, 0 }, { 1, 0, 0 } };
  curve.triangles = { { 0, 1, 1 } };
  EXPECT_NE(
    simplifyWithin(SurfaceTree(cleanSegments(curve).mesh, 0.1), { 0.01 }).refusal.find("curves"), std::string::npos);
  EXPECT_FALSE(simplifyWithin(treeOf(makeSoup(300, 1.0, random)), { 0.01 }).tree);
  EXPECT_NE(simplifyWithin(treeOf(makeIcosphere(3, 1.0)), { 0.0 }).refusal.find("above 0"), std::string::npos);
  SimplifyLimits limits{ 0.1 };
  std::stop_source source;
  source.request_stop();
  limits.stop = source.get_token();
  EXPECT_NE(simplifyWithin(treeOf(makeIcosphere(4, 1.0)), limits).refusal.find("stopped"), std::string::npos);
}

TEST(Simplification, ASampleRefusesALargeRoughSurfaceBeforeAllOfItIsTried)
{
  const SurfaceTree rough = treeOf(NoisySphere(100'000, 1.0).mesh());
  SimplifyLimits limits{ 0.02 };
  bool all = false;
  limits.progress = [&all](double) { all = true; };
  const Simplification none = simplifyWithin(rough, limits);
  EXPECT_FALSE(none.tree);
  EXPECT_NE(none.refusal.find("in a sample"), std::string::npos) << none.refusal;
  EXPECT_FALSE(all); // only collapses on all of it are told
}

TEST(Simplification, EdgesOfThreeTrianglesStayAsTheyAreAndTheRestGoes)
{
  Random random(testSeed(4207));
  TriangleMesh mesh = makeSheet({ 20.0, 20.0, 60, 60, 0.0 }, random);
  // A fin on the row of edges along y = 0, on the vertices of the sheet.
  const TriangleMesh flat = mesh;
  for (const auto& corners : flat.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
      const Vec3 &p = flat.vertices_W[i], &q = flat.vertices_W[j];
      if (std::abs(p.y()) < 1e-9 && std::abs(q.y()) < 1e-9 && p.x() < q.x())
      {
        const auto tip = static_cast<std::uint32_t>(mesh.vertices_W.size());
        mesh.vertices_W.push_back(0.5 * (p + q) + Vec3(0, 0, 1));
        mesh.triangles.push_back({ i, j, tip });
      }
    }
  }
  const CleanResult clean = cleanMesh(mesh);
  ASSERT_EQ(clean.report.nonManifoldEdges, 60U);
  const SurfaceTree surface(clean.mesh);
  const Simplification fewer = simplifyWithin(surface, { 0.05 });
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  const CleanResult after = cleanMesh(fewer.tree->mesh());
  EXPECT_EQ(after.report.nonManifoldEdges, 60U);
  // 60 edges with two triangles of the sheet and one of the fin each; the rest of 7,200 lies in their plane.
  EXPECT_LE(fewer.tree->mesh().triangles.size(), 7200U / 4);
  EXPECT_LE(sampled(surface, *fewer.tree), 0.05);
}

TEST(Simplification, WhatCrossedBeforeMayCrossAfterWhereItIsTheSame)
{
  TriangleMesh two = makeIcosphere(5, 50.0);
  append(two, shifted(makeIcosphere(5, 50.0), { 60.0, 1.0, 2.0 }));
  const SurfaceTree surface = treeOf(two);
  ASSERT_TRUE(crossingTriangles(surface));
  const Simplification fewer = simplifyWithin(surface, { 0.2 });
  ASSERT_TRUE(fewer.tree) << fewer.refusal;
  EXPECT_TRUE(crossingTriangles(*fewer.tree));
  EXPECT_LE(sampled(surface, *fewer.tree), 0.2);
}

TEST(Simplification, TrianglesSoFineThatOtherSheetsAreFarAwayInThemAreStillSimplified)
{
  Random random(testSeed(4208));
  const SurfaceTree sheet = treeOf(makeSheet({ 1.0, 1.0, 60, 60, 0.0 }, random));
  const Simplification flat = simplifyWithin(sheet, { 1.0 }); // each triangle has all others within the limit
  ASSERT_TRUE(flat.tree) << flat.refusal;
  EXPECT_EQ(flat.tree->mesh().triangles.size(), 2U);
}

constexpr int samplesAnEdge = 12;

/// Points of all triangles, on a grid of so many steps an edge.
template<class Visit>
void forEachSample(const TriangleMesh& mesh, Visit visit)
{
  for (const auto& [a, b, c] : mesh.triangles)
  {
    for (int i = 0; i <= samplesAnEdge; ++i)
    {
      for (int j = 0; i + j <= samplesAnEdge; ++j)
      {
        const double s = static_cast<double>(i) / samplesAnEdge, t = static_cast<double>(j) / samplesAnEdge;
        visit((1 - s - t) * mesh.vertices_W[a] + s * mesh.vertices_W[b] + t * mesh.vertices_W[c]);
      }
    }
  }
}

TEST(Simplification, NoSampleOfEitherOfRandomSurfacesIsBeyondTheProvenBound)
{
  Random random(testSeed(4209));
  std::size_t simpler = 0;
  for (std::size_t i = 0; i < testCount(12); ++i)
  {
    const BadMesh made = makeHarmlessBadMesh(random);
    const SurfaceTree surface = treeOf(made.bad);
    const double limit = made.edge_u * random.uniform(0.02, 1.0);
    const Simplification fewer = simplifyWithin(surface, { limit });
    if (!fewer.tree)
    {
      continue;
    }
    ++simpler;
    const NearestPoints before(surface.mesh()), after(fewer.tree->mesh());
    const double rounding = 1e-12 * made.size_u;
    EXPECT_LE(fewer.bound_u, limit);
    forEachSample(surface.mesh(), [&](const Vec3& x_W) { ASSERT_LE(after.distance_u(x_W), fewer.bound_u + rounding); });
    forEachSample(
      fewer.tree->mesh(), [&](const Vec3& x_W) { ASSERT_LE(before.distance_u(x_W), fewer.bound_u + rounding); });
  }
  EXPECT_GT(simpler, 0U) << "nothing was proven, so nothing was tested";
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
