// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 10 and 20: over a convex edge. All lengths in metres; the box's edge is the line x = 0.05, z = 0.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr double edge_m = 0.05;

TriangleMesh box()
{
  return makeBox({ -edge_m, -edge_m, -0.1 }, { edge_m, edge_m, 0 });
}

TEST(ConvexEdges, APointLeavesTheTopWithinAMicrometreOfTheEdge) // row 10
{
  PathChecker checker(box(), 0.0);
  Probe probe(sceneOf(box()), 0.0, { 0.045, 0.01, 0.001 }, &checker);
  probe.along({ 0.0499, 0.01, -0.001 }, 50);
  for (int micrometres = -100; micrometres <= 100; ++micrometres)
  {
    const Vec3 p(edge_m + 1e-6 * micrometres, 0.01, -0.001);
    const ContactResult result = probe.to(p);
    SCOPED_TRACE(micrometres);
    if (micrometres < 0)
    {
      // Pushed by the top alone: 1 N up, nothing sideways.
      ASSERT_LE((probe.x_W() - Vec3(p.x(), 0.01, 0)).norm(), 1e-12);
      ASSERT_EQ(result.contacts, 1);
    }
    else if (micrometres > 0)
    {
      ASSERT_EQ(probe.x_W(), p); // free at once, no force
      ASSERT_EQ(result.contacts, 0);
    }
  }
  EXPECT_EQ(probe.finding(), "");
}

TEST(ConvexEdges, AFastPointLeavesInTheTickThatPassesTheEdge) // row 10
{
  Probe probe(sceneOf(box()), 0.0, { 0.045, 0.01, 0.001 });
  probe.to({ 0.0485, 0.01, -0.001 });
  for (int tick = 0; tick < 60; ++tick)
  {
    const Vec3 p(0.04853 + 1e-4 * tick, 0.01, -0.001); // 100 mm/s, 20 um past the edge in tick 15
    probe.to(p);
    ASSERT_LE((probe.x_W() - (tick < 15 ? Vec3(p.x(), 0.01, 0) : p)).norm(), 1e-12) << "tick " << tick;
  }
}

TEST(ConvexEdges, ABallSnapsToTheSideWithinAMicrometreOfTheEdge) // row 10
{
  // The centre stays above the top until the device passes the edge; then the nearest place is at the side, found by
  // rolling down: (edge + r, z of the device).
  const double r = 1e-3;
  PathChecker checker(box(), r, 1e-15);
  Probe probe(sceneOf(box()), r, { 0.045, 0.01, 0.003 }, &checker);
  probe.along({ 0.0499, 0.01, -0.001 }, 50);
  for (int micrometres = -50; micrometres <= 50; ++micrometres)
  {
    const Vec3 p(edge_m + 1e-6 * micrometres, 0.01, -0.001);
    probe.to(p);
    const Vec3 truth = micrometres < 0 ? Vec3(p.x(), 0.01, r) : Vec3(edge_m + r, 0.01, -0.001);
    if (micrometres != 0)
    {
      ASSERT_LE((probe.x_W() - truth).norm(), 1e-9) << micrometres << " um";
    }
  }
  EXPECT_EQ(probe.finding(), "");
}

TEST(ConvexEdges, ABallRollsOverAnEdgeOnAnArcOfItsRadius) // row 20
{
  const double r = 1e-3;
  for (const double fraction : { 0.99, 0.5, 0.1 }) // how far from the edge the device is, in radii
  {
    SCOPED_TRACE(fraction);
    PathChecker checker(box(), r, 1e-15);
    Probe probe(sceneOf(box()), r, { edge_m - 0.01, 0.01, 2 * r }, &checker);
    probe.along({ edge_m, 0.01, fraction * r }, 20);
    for (int degree = 0; degree <= 90; ++degree)
    {
      const double a = degree * std::numbers::pi / 180;
      const Vec3 outwards(std::sin(a), 0, std::cos(a));
      const ContactResult result = probe.to(Vec3(edge_m, 0.01, 0) + fraction * r * outwards);
      // Nearest point of the arc: straight outwards from the edge through the device.
      ASSERT_LE((probe.x_W() - (Vec3(edge_m, 0.01, 0) + r * outwards)).norm(), 1e-6) << degree << " degrees";
      ASSERT_LE(result.passes, 4) << degree << " degrees";
    }
    EXPECT_EQ(probe.finding(), "");
  }
}

TEST(ConvexEdges, ABallRestsOnACornerOnTheLineThroughTheDevice) // row 20, vertex
{
  const double r = 1e-3;
  const Vec3 corner(edge_m, edge_m, 0);
  Random random(testSeed(71));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Vec3 outwards = random.direction().cwiseAbs();
    Probe probe(sceneOf(box()), r, corner + 3 * r * outwards);
    probe.to(corner + 0.7 * r * outwards);
    ASSERT_LE((probe.x_W() - (corner + r * outwards)).norm(), 1e-12) << "case " << i;
  }
}

TEST(ConvexEdges, ABallRollsOffARimOnToNothing)
{
  // The free border of a sheet is an edge too: the ball rolls round it and is let go below.
  Random random(testSeed(72));
  const TriangleMesh sheet = makeSheet({ 0.1, 0.1, 5, 5, 0.2 }, random);
  const double r = 1e-3;
  PathChecker checker(sheet, r, 1e-15);
  Probe probe(sceneOf(sheet), r, { 0.04, 0.01, 0.003 }, &checker);
  probe.along({ 0.0499, 0.01, -0.0005 }, 20);
  EXPECT_NEAR(probe.x_W().z(), r, 1e-12);
  const Vec3 below(0.0505, 0.01, -0.004);
  probe.along(below, 20);
  EXPECT_EQ(probe.x_W(), below);
  EXPECT_EQ(probe.finding(), "");
}

} // namespace
} // namespace palpate::test
