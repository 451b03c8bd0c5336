// SPDX-License-Identifier: GPL-3.0-or-later
// Random bad meshes under a random hand for a long time.
// PALPATE_TEST_MESHES=1000 PALPATE_TEST_COUNT=100000 is the whole of it: so many meshes, so many ticks on each.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "testing/support/LongRun.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/SoupMaker.h"

namespace palpate::test
{
namespace
{

/// Ball radii worth trying on a mesh: a point, smaller and larger than its gaps, up to an edge.
std::vector<double> radiiFor(const BadMesh& made, Random& random)
{
  const double least_u = 1e-3 * made.edge_u;
  return { 0.0, std::max(0.4 * made.gap_u, least_u), std::max(0.55 * made.gap_u, least_u),
    std::max(made.gap_u, 0.03 * made.edge_u), std::max(made.gap_u, random.uniform(0.2, 1.0) * made.edge_u) };
}

/// All radii from both sides, one after the other, on one bad mesh.
RunFigures runOn(const BadMesh& made, std::uint64_t seed, std::uint64_t ticks)
{
  Random random(seed);
  const JudgedMesh touched(cleanMesh(made.bad).mesh), shape(made.clean);
  RunTask task = taskOn(made, touched, shape);
  RunFigures figures;
  const std::vector<double> radii = radiiFor(made, random);
  for (const double r : radii)
  {
    for (const bool inside : { false, true })
    {
      task.plan.radius_u = r;
      task.inside = inside;
      task.seed = random.next();
      LongRun run(task);
      if (run.placed())
      {
        run.run(ticks / (2 * radii.size()));
      }
      figures += run.figures();
    }
  }
  return figures;
}

TEST(SoupRuns, ABallHoldsOnAnyBadMeshAndIsNeverStuck)
{
  const std::uint64_t seed = testSeed(2401), meshes = testMeshes(10), ticks = testCount(10000);
  RunFigures all;
  for (std::uint64_t i = 0; i < meshes; ++i)
  {
    SCOPED_TRACE("mesh " + std::to_string(i) + " of seed " + std::to_string(seed));
    Random random(seed + 1000003 * i);
    const BadMesh made = makeBadMesh(random);
    const RunFigures figures = runOn(made, random.next(), ticks);
    EXPECT_TRUE(figures.clean()) << figures.text() << "\n" << figures.first;
    all += figures;
    if (i % 10 == 9)
    {
      std::cout << i + 1 << " meshes: " << all.text() << std::endl;
    }
  }
  EXPECT_GT(all.touching, all.ticks / 4);
  EXPECT_LE(all.created, 1e-9 * all.spent);
}

/// Meshes of seed 2401 on which a ball once stood still although it could go on: slivers whose normal is known to 1e-10
/// only (1, 24, 33), the end of a crevice between two edges (36, 55), an edge under a face already touched (59), and a
/// point at a vertex where a fin stands (22), points stopped by the plane of a face they stand beside (98, 461, 537),
/// one whose constraints at a vertex were searched again and again (337), and some in the crevice of a sliver whose
/// plane, where it is computed to be, cuts through it (87, 541, 991), one in the pocket under a fin (952), and balls
/// that came back to the border they had just left (582, 734).
TEST(SoupRuns, WhereABallOnceStoodStillItGoesOn)
{
  for (const std::uint64_t i : { 1, 22, 24, 33, 36, 55, 59, 87, 98, 337, 461, 537, 541, 582, 734, 952, 991 })
  {
    Random random(2401 + 1000003 * i);
    const BadMesh made = makeBadMesh(random);
    const RunFigures figures = runOn(made, random.next(), 100000);
    EXPECT_TRUE(figures.clean()) << "mesh " << i << ": " << figures.text() << "\n" << figures.first;
  }
}

/// A small ball in a box.
RunTask taskInBox(const TriangleMesh& box, const JudgedMesh& touched)
{
  RunTask task;
  task.scene = sceneOf(box);
  task.touched = &touched;
  task.size_u = 2.0;
  task.plan.radius_u = 0.05;
  task.seed = 7;
  return task;
}

/// The judge sees a ball that fell through.
TEST(SoupRuns, AHoleThatIsWiderThanClaimedIsSeenAsAFall)
{
  TriangleMesh box = makeCellBox(6);
  const JudgedMesh shape(cleanMesh(box).mesh);
  box.triangles.resize(box.triangles.size() - 20);
  const JudgedMesh touched(cleanMesh(box).mesh);
  RunTask task = taskInBox(box, touched);
  task.shape = &shape;
  LongRun run(task);
  ASSERT_TRUE(run.placed());
  run.run(20000);
  EXPECT_GT(run.figures().fallen, 0u);
  EXPECT_EQ(run.figures().through, 0u);
}

TEST(SoupRuns, ABallThatMayNotLookFarIsSeenToBeStuck)
{
  const JudgedMesh touched(cleanMesh(makeCellBox(6)).mesh);
  RunTask task = taskInBox(touched.mesh, touched);
  task.plan.workBudget = 1;
  LongRun run(task);
  ASSERT_TRUE(run.placed());
  run.run(5000);
  EXPECT_GT(run.figures().stuck, 0u);
  EXPECT_EQ(run.figures().through, 0u);
}

TEST(SoupRuns, WhatCannotBeFeltChangesNoBitUnderAnyHand)
{
  Random random(testSeed(2402));
  for (std::uint64_t i = 0; i < testMeshes(10); ++i)
  {
    const BadMesh made = makeHarmlessBadMesh(random);
    const auto good = sceneOf(made.clean), bad = sceneOf(made.bad);
    for (const double r : { 0.0, 0.3 * made.edge_u })
    {
      ContactPlan plan;
      plan.radius_u = r;
      GodObjectState onGood, onBad;
      RandomHand hand(made.clean, 0.03 * made.size_u, random.next());
      for (std::uint64_t k = 0; k < testCount(10000) / 10; ++k)
      {
        const Vec3 p_W = hand.next();
        const ContactResult felt = moveGodObject(*good, plan, p_W, onGood);
        const ContactResult other = moveGodObject(*bad, plan, p_W, onBad);
        ASSERT_EQ(other.pull_W, felt.pull_W) << "mesh " << i << ", tick " << k << ", radius " << r;
      }
    }
  }
}

TEST(SoupRuns, ABallSinksIntoCracksOfAFloorByNoMoreThanTheirSagitta)
{
  Random random(testSeed(2403));
  for (int i = 0; i < 20; ++i)
  {
    const double half_u = std::pow(10.0, random.uniform(-6.0, -1.5)), r = half_u * random.uniform(1.01, 20.0);
    const TriangleMesh floor = shrunk(makeSheet({ 4, 4, 12, 12, 0.3 }, random), half_u);
    const TriangleMesh touched = cleanMesh(floor).mesh;
    PathChecker checker(touched, r, 1e-12);
    Probe probe(sceneOf(floor), r, { 0, 0, 0.5 }, &checker);
    RandomHand hand(touched, 0.1, random.next());
    const double sagitta_u = r - std::sqrt(r * r - half_u * half_u);
    for (std::uint64_t k = 0; k < testCount(500); ++k)
    {
      const Vec3 p_W = hand.next();
      probe.to({ std::clamp(p_W.x(), -1.5, 1.5), std::clamp(p_W.y(), -1.5, 1.5), p_W.z() });
      ASSERT_GE(probe.x_W().z(), r - sagitta_u - 1e-12) << "gap " << 2 * half_u << ", radius " << r << ", tick " << k;
      ASSERT_EQ(probe.finding(), "") << "gap " << 2 * half_u << ", radius " << r << ", tick " << k;
    }
  }
}

} // namespace
} // namespace palpate::test
