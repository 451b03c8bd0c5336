// SPDX-License-Identifier: GPL-3.0-or-later
// Row 15: input as it comes. Duplicates, flips, triangles without area, gaps, fins, slivers.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

TEST(Soup, ADamagedMeshFeelsBitForBitLikeTheGoodOne)
{
  Random random(testSeed(91));
  const NoisySphere sphere(2000, 1.0);
  for (const double r : { 0.0, 1.0 })
  {
    Probe good(sceneOf(sphere.mesh()), r, slideStart_W(sphere));
    Probe damaged(sceneOf(withDefects(sphere.mesh(), random)), r, slideStart_W(sphere));
    for (std::size_t i = 0; i < testCount(1000); ++i)
    {
      const Vec3 p = slideOver(sphere, i).p_W;
      good.to(p);
      damaged.to(p);
      ASSERT_EQ(damaged.x_W(), good.x_W()) << "tick " << i << ", radius " << r;
    }
  }
}

TEST(Soup, ABallBridgesAGapAndSinksByItsSagitta)
{
  const double r = 1e-3;
  Random random(testSeed(92));
  for (const double gap : { 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1.9e-3 })
  {
    SCOPED_TRACE(gap);
    const TriangleMesh mesh = makeCracked(gap, random);
    PathChecker checker(mesh, r, 1e-15);
    Probe probe(sceneOf(mesh), r, { -0.01, 0.001, 0.005 }, &checker);
    const double sagitta = r - std::sqrt(r * r - gap * gap / 4);
    for (int i = 0; i <= 200; ++i)
    {
      probe.to({ -0.01 + 1e-4 * i, 0.001, -0.001 });
      ASSERT_GE(probe.x_W().z(), r - sagitta - 1e-12) << "tick " << i;
      ASSERT_LE(probe.x_W().z(), r + 1e-12) << "tick " << i;
    }
    probe.along({ 0, 0.001, -0.001 }, 100); // back to the middle of the gap: as deep as it gets
    EXPECT_NEAR(probe.x_W().z(), r - sagitta, 1e-9);
    EXPECT_EQ(probe.finding(), "");
  }
}

TEST(Soup, ABallStopsAtAFin)
{
  const TriangleMesh mesh = makeFin();
  for (const double r : { 0.0, 0.1 })
  {
    PathChecker checker(mesh, r, 1e-12);
    Probe probe(sceneOf(mesh), r, { -0.7, 0.1, 0.4 }, &checker);
    const ContactResult result = probe.along({ 0.3, 0.2, -0.05 }, 20);
    EXPECT_LE((probe.x_W() - Vec3(-r, 0.2, r)).norm(), 1e-12); // between floor and fin
    EXPECT_EQ(result.contacts, 2);
    EXPECT_EQ(probe.finding(), "");
  }
}

/// Towards one random place after another.
void wander(Probe& probe, Random& random)
{
  Vec3 goal = random.inCube(10.0), p = Vec3::Zero();
  for (std::size_t i = 0; i < testCount(5000); ++i)
  {
    if (i % 50 == 0)
    {
      goal = random.inCube(10.0);
    }
    p += 0.05 * (goal - p);
    probe.to(p);
    ASSERT_EQ(probe.finding(), "") << "tick " << i;
  }
}

TEST(Soup, TrianglesThatCrossEachOtherAreNeverCrossed)
{
  Random random(testSeed(93));
  const TriangleMesh mesh = makeSoup(400, 10.0, random);
  const TriangleMesh clean = cleanMesh(mesh).mesh;
  const auto scene = sceneOf(mesh);
  PathChecker checker(clean, 0.0);
  Probe probe(scene, 0.0, { 0, 0, 0 }, &checker);
  wander(probe, random);
}

TEST(Soup, ABallKeepsItsDistanceToTrianglesThatCrossEachOther)
{
  const double r = 0.3;
  Random random(testSeed(94));
  const TriangleMesh mesh = makeSoup(150, 10.0, random);
  const TriangleMesh clean = cleanMesh(mesh).mesh;
  // Slivers 1e-6 wide: the normal of a face is known to rounding times 1e7, so the distance to 1e-16 * 10 * 1e7.
  PathChecker checker(clean, r, 1e-8);
  Probe probe(sceneOf(mesh), r, { 0, 0, 0 }, &checker);
  wander(probe, random);
}

} // namespace
} // namespace palpate::test
