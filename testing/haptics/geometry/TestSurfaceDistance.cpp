// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/SurfaceDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/TreeOf.h"

namespace palpate::test
{
namespace
{

double nearestOfAll(const SurfaceTree& surface, const Vec3& x_W)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : surface.mesh().triangles)
  {
    const auto& v = surface.mesh().vertices_W;
    nearest = std::min(nearest, (nearestOnTriangle(x_W, v[a], v[b], v[c]) - x_W).norm());
  }
  return nearest;
}

/// The furthest of many random points of `from`.
double sampled(const SurfaceTree& from, const SurfaceTree& to, std::size_t count, Random& random)
{
  double furthest = 0.0;
  const auto& mesh = from.mesh();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& [a, b, c] = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const double s = std::sqrt(random.uniform()), t = random.uniform();
    const Vec3 x_W = (1 - s) * mesh.vertices_W[a] + s * (1 - t) * mesh.vertices_W[b] + s * t * mesh.vertices_W[c];
    furthest = std::max(furthest, nearestOn(to.data(), x_W).distance_u);
  }
  return furthest;
}

TEST(SurfaceDistance, TheNearestPointIsTheNearestOfAllTriangles)
{
  Random random(testSeed(4101));
  const SurfaceTree soup = treeOf(makeSoup(500, 1.0, random));
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    const Vec3 x_W = random.inCube(1.5);
    const double truth = nearestOfAll(soup, x_W);
    EXPECT_DOUBLE_EQ(nearestOn(soup.data(), x_W).distance_u, truth);
    EXPECT_EQ(nearestOn(soup.data(), x_W, 0.99 * truth).triangle, SurfaceData::none);
    EXPECT_NE(nearestOn(soup.data(), x_W, 1.01 * truth).triangle, SurfaceData::none);
  }
}

TEST(SurfaceDistance, AShiftedSheetIsAsFarAsItIsShifted)
{
  Random random(testSeed(4102));
  const SurfaceTree sheet = treeOf(makeSheet({ 1.0, 1.0, 30, 30, 0.3 }, random));
  for (const double up : { 0.0, 1e-6, 0.01, 3.0 })
  {
    const SurfaceTree other = treeOf(shifted(makeSheet({ 1.0, 1.0, 7, 9, 0.3 }, random), { 0, 0, up }));
    const DistanceProof proof = proveWithin(sheet, other, up + 1e-9);
    EXPECT_EQ(proof.verdict, DistanceProof::Verdict::Within) << up;
    EXPECT_GE(proof.bound_u, up);
    if (up > 0.0)
    {
      EXPECT_EQ(proveWithin(sheet, other, 0.99 * up).verdict, DistanceProof::Verdict::Beyond) << up;
    }
  }
}

TEST(SurfaceDistance, APartIsNearTheWholeAndNotTheOtherWayRound)
{
  Random random(testSeed(4103));
  const SurfaceTree whole = treeOf(makeSheet({ 2.0, 1.0, 20, 10, 0.2 }, random));
  const SurfaceTree part = treeOf(makeSheet({ 1.0, 1.0, 9, 9, 0.2 }, random));
  EXPECT_EQ(proveWithin(part, whole, 1e-9).verdict, DistanceProof::Verdict::Within);
  const DistanceProof back = proveWithin(whole, part, 0.49); // its ends stand 0.5 out
  EXPECT_EQ(back.verdict, DistanceProof::Verdict::Beyond);
  EXPECT_GT(nearestOfAll(part, back.witness_W), 0.49);
  EXPECT_EQ(proveWithin(whole, part, 0.5 + 1e-9).verdict, DistanceProof::Verdict::Within);
}

TEST(SurfaceDistance, ACoarserSphereIsAsFarAsItsSagittaSays)
{
  // The finer sphere's new vertices lie on the sphere, half way along edges of the coarser one: the furthest point of
  // the finer mesh is one of them or one beyond the middle of a face, R - distance of the lowest face.
  const SurfaceTree coarse = treeOf(makeIcosphere(3, 50.0)), fine = treeOf(makeIcosphere(4, 50.0));
  double lowest = 50.0;
  for (std::uint32_t t = 0; t < coarse.data().faces.size(); ++t)
  {
    const FaceRecord face = coarse.data().face(t);
    lowest = std::min(lowest, std::abs(face.normal_W.dot(face.corner_W[0])));
  }
  const double sagitta = 50.0 - lowest;
  EXPECT_EQ(proveWithin(coarse, fine, (1 + 1e-9) * sagitta).verdict, DistanceProof::Verdict::Within);
  EXPECT_EQ(proveWithin(fine, coarse, (1 + 1e-9) * sagitta).verdict, DistanceProof::Verdict::Within);
  // The finer one's own middle face dips a quarter of it.
  EXPECT_EQ(proveWithin(fine, coarse, 0.7 * sagitta).verdict, DistanceProof::Verdict::Beyond);
}

TEST(SurfaceDistance, NothingIsProvenThatASampleDeniesAndTwiceTheSamplesAre)
{
  Random random(testSeed(4104));
  for (const int levels : { 2, 3 })
  {
    const SurfaceTree coarse = treeOf(makeIcosphere(levels, 50.0)), fine = treeOf(makeIcosphere(levels + 2, 50.0));
    const double there = sampled(coarse, fine, testCount(5000), random);
    const double back = sampled(fine, coarse, testCount(5000), random);
    EXPECT_NE(proveWithin(coarse, fine, 0.999 * there).verdict, DistanceProof::Verdict::Within);
    EXPECT_NE(proveWithin(fine, coarse, 0.999 * back).verdict, DistanceProof::Verdict::Within);
    EXPECT_EQ(proveWithin(coarse, fine, 2 * std::max(there, back)).verdict, DistanceProof::Verdict::Within);
    EXPECT_EQ(proveWithin(fine, coarse, 2 * std::max(there, back)).verdict, DistanceProof::Verdict::Within);
  }
  const SurfaceTree rough = treeOf(NoisySphere(5000, 1.0).mesh()), finer = treeOf(NoisySphere(20000, 1.0).mesh());
  const double furthest = sampled(finer, rough, testCount(5000), random);
  EXPECT_NE(proveWithin(finer, rough, 0.999 * furthest).verdict, DistanceProof::Verdict::Within);
}

TEST(SurfaceDistance, AHoleIsNotMissedHoweverSmall)
{
  Random random(testSeed(4105));
  const TriangleMesh whole = makeSheet({ 1.0, 1.0, 40, 40, 0.0 }, random);
  TriangleMesh holed = whole;
  holed.triangles.erase(holed.triangles.begin() + 1000);
  const SurfaceTree a = treeOf(whole), b = treeOf(holed);
  // A right triangle with legs of 1/40: its inscribed circle has the radius (2 - sqrt 2) / 2 of a leg.
  const double depth = (2 - std::sqrt(2.0)) / 2 / 40;
  EXPECT_NE(proveWithin(a, b, 0.9 * depth).verdict, DistanceProof::Verdict::Within);
  EXPECT_EQ(proveWithin(b, a, 1e-9).verdict, DistanceProof::Verdict::Within);
}

TEST(SurfaceDistance, TwoTrianglesNearAFineSheetAreCutIntoFewPiecesATriangleOfIt)
{
  Random random(testSeed(4105));
  const int cells = static_cast<int>(std::sqrt(static_cast<double>(testTriangles(100'000)) / 2));
  const SurfaceTree fine = treeOf(makeSheet({ 100.0, 100.0, cells, cells, 0.3 }, random));
  const SurfaceTree coarse = treeOf(makeSheet({ 100.0, 100.0, 1, 1, 0.0 }, random));
  for (const double limit : { 0.07, 1e-6 })
  {
    const DistanceProof proof = proveWithin(coarse, fine, limit);
    EXPECT_EQ(proof.verdict, DistanceProof::Verdict::Within);
    // Halves down to the size of a triangle are two a triangle, each then meets the lines of a few.
    EXPECT_LE(proof.pieces, 8 * fine.mesh().triangles.size()) << limit;
  }
}

TEST(SurfaceDistance, StopsWhenItIsAskedTo)
{
  std::stop_source source;
  source.request_stop();
  const SurfaceTree sphere = treeOf(makeIcosphere(5, 1.0));
  EXPECT_EQ(proveWithin(sphere, sphere, 1.0, source.get_token()).verdict, DistanceProof::Verdict::Open);
}

} // namespace
} // namespace palpate::test
