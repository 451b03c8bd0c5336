// SPDX-License-Identifier: GPL-3.0-or-later
// Row 15: fins make pockets that end at a vertex. A point that lies on the faces passes over the vertex; one that is
// kept off them by rounding, as a point must be, cannot come to it.
#include <algorithm>

#include <gtest/gtest.h>

#include "testing/support/Anywhere.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Stage.h"

namespace palpate::test
{
namespace
{

/// The valley z = 0.3 |y|, -1 <= x, y <= 1, of six triangles round the origin, vertex 0.
TriangleMesh makeValley()
{
  TriangleMesh mesh;
  mesh.vertices_W = { { 0, 0, 0 }, { -1, 0, 0 }, { -1, 1, 0.3 }, { -1, -1, 0.3 }, { 1, 1, 0.3 }, { 1, 0, 0 },
    { 1, -1, 0.3 } };
  mesh.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 6 }, { 0, 6, 5 }, { 0, 5, 4 }, { 0, 4, 2 } };
  return mesh;
}

/// A fin that stands on the edge from the origin to vertex `on` and leans over the bottom of the valley as far as
/// `tip`.
void addFin(TriangleMesh& valley, std::uint32_t on, const Vec3& tip)
{
  valley.triangles.push_back({ 0, on, static_cast<std::uint32_t>(valley.vertices_W.size()) });
  valley.vertices_W.push_back(tip);
}

/// From the bottom of the valley under the fins, which meet it at the origin, along it and past the origin. The hand
/// ends below the bottom, that is in the cone of its sides' normals: the point must end right above it.
void drawOutOf(const TriangleMesh& pocket, Random& random)
{
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const Anywhere place(random, 3.0);
    const TriangleMesh mesh = place(pocket);
    PathChecker checker(mesh, 0.0);
    Probe probe(sceneOf(mesh), 0.0, place({ -0.5, 0.0, 0.03 }), &checker);
    probe.to(place({ -0.5, 0.0, -0.1 }));
    probe.along(place({ 0.5, 0.0, -0.25 }), 20);
    probe.to(place({ 0.5, 0.0, -0.25 }));
    ASSERT_LE((probe.x_W() - place({ 0.5, 0.0, 0.0 })).norm(), 1e-12) << "place " << i;
    ASSERT_EQ(probe.finding(), "") << "place " << i;
  }
}

TEST(Pockets, APointIsDrawnOutOfThePocketUnderAFinOverTheVertexWhereItEnds)
{
  Random random(testSeed(111));
  TriangleMesh mesh = makeValley();
  addFin(mesh, 2, { -1, -0.5, 0.25 });
  drawOutOf(mesh, random);
}

TEST(Pockets, APointIsDrawnOutFromBetweenTwoFinsRoundTheFreeEdgeOfOne)
{
  Random random(testSeed(112));
  TriangleMesh mesh = makeValley();
  addFin(mesh, 2, { -1, -0.2, 0.26 }); // above
  addFin(mesh, 3, { -1, 0.3, 0.14 });  // below, its free edge under the other one
  drawOutOf(mesh, random);
}

/// The same while the surface turns and travels under the hand, which keeps to it.
TEST(Pockets, APointIsDrawnOutOfAPocketThatMoves)
{
  TriangleMesh mesh = makeValley();
  addFin(mesh, 2, { -1, -0.5, 0.25 });
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  Stage stage;
  stage.add(mesh,
    [&](double t) {
      return Pose{ Vec3(0.3, -0.2, 0.5) * t, Quat(Eigen::AngleAxisd(0.4 + 0.5 * t, axis)) };
    });
  const auto at = [&](int tick, const Vec3& v)
  {
    const Pose pose = stage.pose(0, 1e-3 * tick);
    return Vec3(pose.q * v + pose.p);
  };
  ContactPlan plan;
  plan.radius_u = 0.0;
  Actor actor(stage, plan, at(0, { -0.5, 0.0, 0.03 }));
  actor.tick(at(1, { -0.5, 0.0, -0.1 }));
  for (int tick = 2; tick <= 40; ++tick)
  {
    actor.tick(at(tick, { std::min(0.5, -0.5 + 0.05 * tick), 0.0, -0.25 }));
  }
  // Between snapshots, 16 ms apart, poses are interpolated: at 0.5 rad/s they are off by the sagitta of 8 mrad.
  EXPECT_LE((actor.inSurface(0) - Vec3(0.5, 0.0, 0.0)).norm(), 0.008 * 0.008 / 8);
}

/// A face is remembered as touched as long as the point is over it within rounding. From beside it, by less than that,
/// the straight path leads past its border and is free.
TEST(Pockets, APointBesideAFaceIsNotHeldByThePlaneOfIt)
{
  Random random(testSeed(113));
  TriangleMesh face;
  face.vertices_W = { { 0, -1, 0 }, { 0, 1, 0 }, { -2, 0, 0 } }; // its border is the y axis
  face.triangles = { { 0, 1, 2 } };
  const auto scene = sceneOf(face);
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const double height = random.uniform(1e-15, 3e-15), beside = random.uniform(5e-15, 1e-14);
    GodObjectState state;
    state.placed = true;
    state.x_W = state.device_W = { beside, random.uniform(-0.5, 0.5), height };
    state.features[0] = { 0, 0, 0, FeatureKind::Face, 1, false };
    state.count = 1;
    const Vec3 start_W = state.x_W, p_W(random.uniform(-0.8, -0.1), start_W.y(), -1.0); // z = 0 at x > beside - height
    PathChecker checker(face, 0.0);
    checker.segment(start_W, p_W);
    ASSERT_EQ(checker.finding(start_W), "") << "case " << i;
    (void)moveGodObject(*scene, {}, p_W, state, &checker);
    ASSERT_EQ(state.x_W, p_W) << "case " << i;
    ASSERT_EQ(checker.finding(start_W), "") << "case " << i;
  }
}

} // namespace
} // namespace palpate::test
