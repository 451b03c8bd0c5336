// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices on their straight paths from one snapshot to the next: the force in each tick between them.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "testing/haptics/contact/BendingSheet.h"
#include "testing/support/Bender.h"
#include "testing/support/Meshes.h"
#include "testing/support/SheetHeight.h"

namespace palpate::test
{
namespace
{

class Bending : public testing::TestWithParam<double>
{
};

TEST_P(Bending, ASheetThatRisesUnderARestingHandPushesHarderInEqualStepsFromTickToTick)
{
  const double radius = GetParam(), speed = 0.05;
  Bender sheet(
    sheetOf(20, 421), [=](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, speed * t_s)); }, at20Hz);
  sheet.parameters.contact.radius_u = radius;
  const Vec3 hand(0.0031, 0.0023, radius - 1e-3);
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.01)));
  for (int i = 2; i <= 400; ++i)
  {
    const TickOutput out = sheet.tick(hand);
    const double height = speed * 1e-3 * i; // at the snapshots i / 50, and between them
    ASSERT_NEAR(out.state.force_D.z(), K * (height + radius - hand.z()), 1e-9) << "tick " << i;
    ASSERT_LE(out.state.force_D.head<2>().norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(Bending, AWaveIsFeltWhereItsVerticesAreOnTheirWay)
{
  const double radius = GetParam();
  const auto wave = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 5e-3 * std::sin(twoPi * (v.x() / 0.08 - 2.0 * t_s))); };
  Bender sheet(sheetOf(40, 422), wave, at20Hz);
  sheet.parameters.contact.radius_u = radius;
  static_cast<void>(sheet.tick({ 0.0031, 0.0023, 0.05 }));
  int touching = 0;
  for (int i = 2; i <= 400; ++i)
  {
    const double along = 0.02 * std::sin(twoPi * 1e-3 * i);
    const TickOutput out = sheet.tick({ along, 0.0023, -8e-3 });
    const TriangleMesh felt = sheet.mesh();
    const Vec3 x = out.state.proxy_W.p;
    touching += out.state.contacts > 0 ? 1 : 0;
    ASSERT_NEAR(distanceTo(felt, x), radius, 1e-9) << "tick " << i;
    ASSERT_GT(x.z(), heightAt(felt, x)) << "tick " << i;
  }
  EXPECT_EQ(touching, 399);
}

TEST_P(Bending, ABumpThatShootsAtAHandNeverPassesIt)
{
  const double radius = GetParam();
  for (const double speed : { 0.1, 1.0, 5.0 })
  {
    for (const double side : { 1.0, -1.0 })
    {
      for (const double depth : { -0.02, 2e-3 }) // the hand waits in the air, or is pressed
      {
        const auto bump = [=](const Vec3& v, double t_s)
        {
          const double r2 = v.head<2>().squaredNorm() / (0.03 * 0.03);
          return Vec3(v.x(), v.y(), side * speed * t_s * std::exp(-r2));
        };
        Bender sheet(sheetOf(30, 423), bump, 10);
        sheet.parameters.contact.radius_u = radius;
        const Vec3 start(0.0131, 0.0043, side * (0.03 + radius)), hand(0.0131, 0.0043, side * (radius - depth));
        static_cast<void>(sheet.tick(start));
        for (int i = 2; i <= std::min(400, static_cast<int>(0.2 / speed * 1e3)); ++i)
        {
          const Vec3 x = sheet.tick(hand).state.proxy_W.p;
          const TriangleMesh felt = sheet.mesh();
          ASSERT_GT(side * (x.z() - heightAt(felt, x)), 0.0) << speed << " m/s, side " << side << ", tick " << i;
          ASSERT_GE(distanceTo(felt, x), radius - 1e-9) << speed << " m/s, side " << side << ", tick " << i;
        }
      }
    }
  }
}

TEST_P(Bending, FrictionHoldsAHandAtTheSamePointOfItsTriangle)
{
  const double radius = GetParam();
  // A stretch with shear: a point of a triangle stays the same affine function of all of them.
  const auto stretch = [](const Vec3& v, double t_s)
  { return Vec3(v.x() * (1 + t_s) + 0.3 * t_s * v.y(), v.y() * (1 - 0.4 * t_s), 0.02 * t_s + 0.1 * t_s * v.x()); };
  Bender sheet(sheetOf(20, 424), stretch, at20Hz);
  sheet.parameters.contact.radius_u = radius;
  sheet.parameters.contact.friction = { 100.0, 100.0 };
  const Vec3 hand(0.0371, 0.0263, -5e-3);
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.02)));
  static_cast<void>(sheet.tick(hand));
  const auto pointAt = [&](double t_s, const Vec3& inMesh) { return stretch(inMesh, t_s); };
  // The foot of where it landed, back in the mesh: the map of the plane is linear in x and y.
  const double t0 = 2e-3;
  const auto normalAt = [&](double t_s)
  {
    const Vec3 u = pointAt(t_s, { 1, 0, 0 }) - pointAt(t_s, Vec3::Zero());
    const Vec3 v = pointAt(t_s, { 0, 1, 0 }) - pointAt(t_s, Vec3::Zero());
    return Vec3(u.cross(v).normalized());
  };
  const Vec3 foot = sheet.state.contact.x_W - radius * normalAt(t0);
  const Eigen::Matrix2d map{ { 1 + t0, 0.3 * t0 }, { 0.0, 1 - 0.4 * t0 } };
  const Eigen::Vector2d inMesh = map.inverse() * foot.head<2>();
  for (int i = 3; i <= 300; ++i)
  {
    const TickOutput out = sheet.tick(hand);
    ASSERT_EQ(out.state.friction, FrictionState::Sticks) << "tick " << i;
    const Vec3 held = pointAt(1e-3 * i, { inMesh.x(), inMesh.y(), 0 }) + radius * normalAt(1e-3 * i);
    ASSERT_LE((out.state.proxy_W.p - held).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(Bending, AHandBetweenASheetThatComesAndAWallPassesNeither)
{
  const double radius = GetParam(), wall = 0.02;
  const auto come = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 0.06 * t_s * std::exp(-v.head<2>().squaredNorm() / (0.05 * 0.05))); };
  Bender sheet(sheetOf(20, 425), come, at20Hz);
  sheet.addStanding(shifted(sheetOf(7, 426), { 0, 0, wall }));
  sheet.parameters.contact.radius_u = radius;
  static_cast<void>(sheet.tick({ 0.0011, 0.0013, 0.01 }));
  for (int i = 2; i <= 330; ++i) // the top stands at 0.0198 then
  {
    const double swing = 0.02 * std::sin(0.05 * i);
    const Vec3 x = sheet.tick({ 0.0011, 0.0013, 0.01 + swing }).state.proxy_W.p;
    ASSERT_GT(x.z(), heightAt(sheet.mesh(), x)) << "tick " << i;
    ASSERT_LT(x.z(), wall) << "tick " << i;
  }
}

TEST_P(Bending, TrianglesThatPassThroughHavingNoAreaHoldTheHandAsWell)
{
  const double radius = GetParam();
  // One side of a fold runs through its crease line and comes out on the other side of it: flat halfway, exactly.
  TriangleMesh fold;
  fold.vertices_W = { { -0.1, 0, 0 }, { 0.1, 0, 0 }, { 0, 0.1, 0 }, { 0, -0.1, 0 } };
  fold.triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
  const auto turn = [](const Vec3& v, double t_s) { return v.y() < 0.0 ? Vec3(v.x(), v.y() + 2.0 * t_s, v.z()) : v; };
  Bender sheet(fold, turn, 100);
  sheet.parameters.contact.radius_u = radius;
  const Vec3 hand(0.0011, 0.03, -1e-3);
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.02)));
  for (int i = 2; i <= 100; ++i)
  {
    const Vec3 x = sheet.tick(hand).state.proxy_W.p;
    ASSERT_TRUE(x.allFinite()) << "tick " << i;
    ASSERT_LE((x - Vec3(hand.x(), hand.y(), radius)).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(Bending, ASnapshotThatComesEarlyStartsFromWhereTheSurfaceIsFelt)
{
  const double radius = GetParam();
  // Snapshots every 20 ticks that each announce a path of 20 ticks; every other one is cut short.
  Bender sheet(
    sheetOf(20, 427), [](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, 0.05 * t_s)); }, 20);
  sheet.parameters.contact.radius_u = radius;
  const Vec3 hand(0.0031, 0.0023, radius - 1e-3);
  expectNoStepWhereWaysAreCutShort(sheet, hand, 0.05);
}

TEST_P(Bending, NothingIsAllocatedAndNothingLockedInATick)
{
  const auto wave = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 5e-3 * std::sin(twoPi * (v.x() / 0.08 - 2.0 * t_s))); };
  Bender sheet(sheetOf(40, 428), wave, 10);
  sheet.parameters.contact.radius_u = GetParam();
  sheet.parameters.contact.friction = { 0.3, 0.2 };
  EXPECT_EQ(disturbancesUnderAStroke(sheet), 0u);
}

/// Sweeps through the first surface of a scene at a moment of its path against the same sweeps through a tree that is
/// built of the same vertices. Returns how many hit.
std::size_t compareWithBuilt(const Scene& scene, double share, Random& random)
{
  const Surface& surface = scene.surfaces()[0];
  TriangleMesh felt = surface.tree->mesh();
  for (std::size_t i = 0; i < felt.vertices_W.size(); ++i)
  {
    felt.vertices_W[i] = alongWay(surface.from->vertices_W[i], felt.vertices_W[i], share);
  }
  const auto built = sceneOf(felt);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const Vec3 from_W = random.inCube(0.08), to_W = random.inCube(0.08);
    const SweepQuery query = straightQuery(from_W, to_W, i % 2 == 0 ? 0.0 : 2e-3);
    const SweepHit a = sweepBall(MovingScene(scene, share), query, 1000000), b = sweepBall(*built, query, 1000000);
    EXPECT_EQ(a.hit, b.hit) << share << ", " << i;
    EXPECT_NEAR(a.t, b.t, 1e-10) << share << ", " << i; // rounded otherwise: vertices have other numbers
    hits += a.hit ? 1 : 0;
  }
  return hits;
}

std::vector<Vec3> shaken(std::vector<Vec3> places_W, Random& random)
{
  std::for_each(places_W.begin(), places_W.end(), [&](Vec3& v) { v = 1.1 * v + 2e-3 * random.direction(); });
  return places_W;
}

TEST(BentSurface, AnswersAtAnyMomentAsATreeThatWasBuiltThere)
{
  Random random(testSeed(429));
  const auto first = std::make_shared<const SurfaceTree>(cleanMesh(makeIcosphere(3, 0.05)).mesh);
  const std::vector<Vec3> begin = first->mesh().vertices_W;
  const VertexWay way{ 7, { &begin } };
  Surface surface{ "it", first->refitted(shaken(begin, random), nullptr, &way).tree, {} };
  surface.from = std::make_shared<const VertexStart>(begin, 0);
  const Scene scene(1, { surface }, 0.05);
  std::size_t hits = 0;
  for (const double share : { 0.0, 0.13, 0.5, 0.87, 1.0 })
  {
    hits += compareWithBuilt(scene, share, random);
  }
  EXPECT_GT(hits, testCount(2000) / 2);
}

TEST(BentSurface, AnswersSoWhereSnapshotsComeEarlyAndWhereTheSameOneComesAgain)
{
  Random random(testSeed(430));
  SceneBuilder builder;
  SurfaceInput input{ "it", std::make_shared<const TriangleMesh>(makeIcosphere(3, 0.03)), {} };
  std::shared_ptr<const Scene> felt = builder.build({ input }).scene;
  for (const double left : { 1.0, 0.25, 0.6, 0.0, 0.9 }) // where the hand is on each path when the next snapshot comes
  {
    input.mesh = std::make_shared<const TriangleMesh>(
      TriangleMesh{ shaken(input.mesh->vertices_W, random), input.mesh->triangles });
    felt = movingFrom(*felt, left, builder.build({ input }, felt.get()).scene, 0.05);
    felt = movingFrom(*felt, 0.3, builder.build({ input }, felt.get()).scene, 0.05); // the same again
    for (const double share : { 0.0, 0.4, 0.99 })
    {
      EXPECT_GT(compareWithBuilt(*felt, share, random), testCount(2000) / 100);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, Bending, testing::Values(0.0, 1e-3));

} // namespace
} // namespace palpate::test
