// SPDX-License-Identifier: GPL-3.0-or-later
// Where a god-object begins.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

TEST(Seat, InFreeSpaceItBeginsAtTheDevice)
{
  const Vec3 start(3, 4, 5);
  for (const double r : { 0.0, 1.0 })
  {
    EXPECT_EQ(Probe(sceneOf(makeBox(-Vec3::Ones(), Vec3::Ones())), r, start).x_W(), start);
  }
}

TEST(Seat, AnOverlappingBallIsMovedOutByTheLeastMotionToTheSideOfItsCentre)
{
  const auto scene = sceneOf(makeBox({ -5, -5, -5 }, { 5, 5, 5 }));
  EXPECT_LE((Probe(scene, 1.0, { 0.5, 0.25, 5.3 }).x_W() - Vec3(0.5, 0.25, 6)).norm(), 1e-12);
  EXPECT_LE((Probe(scene, 1.0, { 0.5, 0.25, 4.8 }).x_W() - Vec3(0.5, 0.25, 4)).norm(), 1e-12); // from inside
}

TEST(Seat, ABallThatCutsATessellatedPlaneIsLiftedOntoItFromAnyHeight)
{
  Random random(testSeed(122));
  const double r = 1.0;
  const auto scene = sceneOf(makeSheet({ 60, 60, 24, 24, 0.35 }, random));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const double height = (random.below(2) == 0 ? 1 : -1) * r * std::pow(10.0, random.uniform(-9, 0));
    const Vec3 p(random.uniform(-20, 20), random.uniform(-20, 20), height);
    GodObjectState state;
    ContactPlan plan;
    plan.radius_u = r;
    const ContactResult result = moveGodObject(*scene, plan, p, state);
    ASSERT_FALSE(result.seatFailed) << "case " << i << ", height " << height;
    // The least motion to the side of the centre is straight up or down, by less than the radius.
    ASSERT_LE((state.x_W - Vec3(p.x(), p.y(), height > 0 ? r : -r)).norm(), 1e-9)
      << "case " << i << ", height " << height;
  }
}

TEST(Seat, ABallThatFindsNoPlaceWithinItsRadiusReportsIt)
{
  TriangleMesh slot = makeBox({ -5, -5, -5 }, { 5, 5, 5 });
  append(slot, shifted(makeBox({ -5, -5, 0 }, { 5, 5, 5 }), { 0, 0, 5.5 })); // a gap of half a unit
  GodObjectState state;
  ContactPlan plan;
  plan.radius_u = 1.0;
  EXPECT_TRUE(moveGodObject(*sceneOf(slot), plan, { 0, 0, 5.25 }, state).seatFailed);
}

TEST(Seat, APointExactlyOnATriangleIsLiftedOffItAndStaysOnThatSide)
{
  Random random(testSeed(121));
  const TriangleMesh mesh = makeSheet({ 8, 8, 8, 8, 0.0 }, random);
  const auto scene = sceneOf(mesh);
  for (const Vec3& start : { Vec3(0.25, 0.125, 0), Vec3(1, 0.5, 0), Vec3(2, 2, 0) })
  {
    PathChecker checker(mesh, 0.0);
    Probe probe(scene, 0.0, start, &checker);
    EXPECT_LE((probe.x_W() - start).norm(), 1e-12);
    const double side = probe.x_W().z();
    EXPECT_NE(side, 0.0);
    probe.to(start + Vec3(0, 0, side > 0 ? -1 : 1));
    EXPECT_EQ(probe.x_W().z() > 0, side > 0);
    EXPECT_EQ(probe.finding(), "");
  }
}

// The point rests nearer to its faces than rounding tells: their sides do, in either orientation of the triangles.
TEST(Seat, ABallThatIsPutWhereAPressedPointRestsIsOnTheSideOfThePoint)
{
  Random random(testSeed(123));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    const Vec3 half(random.uniform(2, 40), random.uniform(2, 40), random.uniform(2, 40));
    TriangleMesh box = makeBox(-half, half);
    for (auto& triangle : box.triangles)
    {
      if (random.below(2) == 0)
      {
        std::swap(triangle[0], triangle[1]);
      }
    }
    const auto scene = sceneOf(box);
    Probe point(scene, 0.0, Vec3(400, random.uniform(-50, 50), random.uniform(-50, 50)));
    const Vec3 deep(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    point.along(deep, 20);
    GodObjectState state;
    ContactPlan plan;
    plan.radius_u = 0.5;
    plan.seatsBySide = true;
    ASSERT_FALSE(moveGodObject(*scene, plan, point.x_W(), state).seatFailed) << "case " << i;
    const double outside = (state.x_W.cwiseAbs() - half).cwiseMax(0.0).norm();
    ASSERT_NEAR(outside, plan.radius_u, 1e-9) << "case " << i << ": " << state.x_W.transpose();
  }
}

TEST(Seat, ACentreInsideAClosedSurfaceTouchesItFromInside)
{
  const NoisySphere sphere(5000, 1.0);
  for (const double r : { 0.0, 1.0 })
  {
    PathChecker checker(sphere.mesh(), r, 1e-9); // row 11: positions are exact to 1e-12 m
    Probe probe(sceneOf(sphere.mesh()), r, { 1, 2, 3 }, &checker);
    EXPECT_GT(probe.along({ 60, 10, 5 }, 50).contacts, 0);
    EXPECT_LT(probe.x_W().norm(), sphere.surfaceRadius_u(probe.x_W().normalized()));
    EXPECT_EQ(probe.finding(), "");
  }
}

} // namespace
} // namespace palpate::test
