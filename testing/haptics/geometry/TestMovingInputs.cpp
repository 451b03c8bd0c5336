// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes built one after another of surfaces that move: surfaces that are built anew or refitted, and the start of
// their motions.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/geometry/mesh/PolyLines.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

SurfaceInput input(const TriangleMesh& mesh)
{
  return { "sheet", std::make_shared<TriangleMesh>(mesh), {} };
}

/// A sheet as views give it, every triangle with corners of its own: cleaning welds them.
TriangleMesh unweldedSheet()
{
  Random random(testSeed(801));
  return unwelded(makeSheet({ 1.0, 1.0, 8, 8, 0.3 }, random));
}

TriangleMesh warped(TriangleMesh mesh)
{
  for (Vec3& p_W : mesh.vertices_W)
  {
    p_W.z() += 0.1 * std::sin(3.0 * p_W.x()) * p_W.y();
  }
  return mesh;
}

TEST(MovingInputs, TheSameTrianglesWithVerticesElsewhereAreRefitted)
{
  SceneBuilder builder;
  const TriangleMesh flat = unweldedSheet();
  const auto first = builder.build({ input(flat) }).scene;
  const SceneBuildResult second = builder.build({ input(warped(flat)) });
  EXPECT_TRUE(second.reports[0].refitted);
  const SurfaceTree &before = *first->surfaces()[0].tree, &now = *second.scene->surfaces()[0].tree;
  EXPECT_EQ(now.topologyHash(), before.topologyHash());
  EXPECT_EQ(now.mesh().vertices_W, warped(before.mesh()).vertices_W);
}

TEST(MovingInputs, ARefittedTreeTakesTheMemoryOfTheOneBeforeTheLast)
{
  SceneBuilder builder;
  const TriangleMesh flat = unweldedSheet();
  const SurfaceData* taken = nullptr;
  {
    const auto first = builder.build({ input(flat) }).scene;
    taken = &first->surfaces()[0].tree->data();
  }
  const auto second = builder.build({ input(warped(flat)) }).scene;
  const auto third = builder.build({ input(flat) }).scene;
  EXPECT_EQ(&third->surfaces()[0].tree->data(), taken);
}

/// How many triangles have a copy of that corner of theirs.
std::ptrdiff_t copies(const TriangleMesh& mesh, std::size_t vertex)
{
  return std::ranges::count(mesh.vertices_W, mesh.vertices_W[vertex]);
}

/// The first corner that is not the one corner of a single triangle, as two of the four corners of a sheet are.
std::size_t sharedCorner(const TriangleMesh& mesh)
{
  std::size_t vertex = 0;
  while (vertex + 1 < mesh.vertices_W.size() && copies(mesh, vertex) == 1)
  {
    ++vertex;
  }
  return vertex;
}

TEST(MovingInputs, ASurfaceThatTearsOrLosesTrianglesIsBuiltAnew)
{
  const TriangleMesh flat = unweldedSheet();
  TriangleMesh torn = flat, fewer = flat, collapsed = flat, broken = flat;
  const std::size_t shared = sharedCorner(flat);
  ASSERT_GT(copies(flat, shared), 1);
  torn.vertices_W[shared].z() += 0.1; // its neighbours' copies of that corner stay
  fewer.triangles.pop_back();
  collapsed.vertices_W[1] = collapsed.vertices_W[0];
  broken.vertices_W[0].x() = std::numeric_limits<double>::quiet_NaN();
  for (const TriangleMesh& next : { torn, fewer, collapsed, broken })
  {
    SceneBuilder builder;
    ASSERT_TRUE(builder.build({ input(flat) }).scene);
    const SceneBuildResult second = builder.build({ input(next) });
    EXPECT_FALSE(second.reports[0].refitted);
    EXPECT_EQ(second.scene->contentHash(), SceneBuilder().build({ input(next) }).scene->contentHash());
  }
}

TEST(MovingInputs, TrianglesThatWereDroppedForTheirPlaceComeBackWhenTheyHaveAnArea)
{
  TriangleMesh flat = unweldedSheet(), collapsed = flat;
  collapsed.vertices_W[1] = collapsed.vertices_W[0];
  SceneBuilder builder;
  ASSERT_EQ(builder.build({ input(collapsed) }).reports[0].clean.collinear, 1u);
  const SceneBuildResult second = builder.build({ input(flat) });
  EXPECT_EQ(second.reports[0].clean.trianglesOut, flat.triangles.size());
}

TEST(MovingInputs, AnotherPoseOfTheSameMeshKeepsItsTree)
{
  SceneBuilder builder;
  SurfaceInput sheet = input(unweldedSheet());
  const auto first = builder.build({ sheet }).scene;
  sheet.pose_WS.p = Vec3(0, 0, 1);
  const auto second = builder.build({ sheet }).scene;
  EXPECT_FALSE(first->moves());
  EXPECT_TRUE(second->moves());
  EXPECT_EQ(second->surfaces()[0].tree, first->surfaces()[0].tree);
  EXPECT_EQ(second->geometryHash(), first->geometryHash());
}

TEST(MovingInputs, AMotionBeginsWhereTheSurfaceIsFeltAndEndsWhereItIsShown)
{
  SceneBuilder builder;
  SurfaceInput sheet = input(unweldedSheet());
  const auto at = [&](double z)
  {
    sheet.pose_WS.p = Vec3(0, 0, z);
    return builder.build({ sheet }).scene;
  };
  const auto first = movingFrom(*at(0.0), 1.0, at(2.0), 0.1);
  ASSERT_EQ(first->motion_s(), 0.1);
  EXPECT_EQ(first->surfaces()[0].motion.begin_WS.p.z(), 0.0);
  // The next snapshot comes at a quarter of that motion.
  const auto second = movingFrom(*first, 0.25, at(3.0), 0.1);
  EXPECT_EQ(second->surfaces()[0].motion.begin_WS.p.z(), 0.25 * 2.0);
  EXPECT_EQ(second->surfaces()[0].motion.end_WS.p.z(), 3.0);
}

TEST(MovingInputs, WhatIsNewOrStandsStillDoesNotMove)
{
  SceneBuilder builder;
  const auto flat = builder.build({ input(unweldedSheet()) }).scene;
  EXPECT_EQ(movingFrom(*flat, 1.0, flat, 0.1), flat);
  SurfaceInput other = input(makeIcosphere(1, 1.0));
  other.pose_WS.p = Vec3(0, 0, 1);
  const auto next = builder.build({ other }).scene;
  EXPECT_EQ(movingFrom(*flat, 1.0, next, 0.1), next);
}

/// Builds a sheet after another, each in motion from where the one before is felt.
class Series
{
public:
  std::shared_ptr<const Scene> next(const TriangleMesh& mesh, double share)
  {
    const auto built = this->builder.build({ input(mesh) }, this->felt.get()).scene;
    this->felt = this->felt ? movingFrom(*this->felt, share, built, 0.05) : built;
    return this->felt;
  }
  SceneBuilder builder;
  std::shared_ptr<const Scene> felt;
};

TEST(MovingInputs, VerticesBeginWhereTheyAreFeltAlsoIfASnapshotComesEarly)
{
  Series series;
  const TriangleMesh flat = unweldedSheet(), bent = warped(flat), more = warped(bent);
  const auto first = series.next(flat, 1.0), second = series.next(bent, 1.0), third = series.next(more, 0.4);
  EXPECT_FALSE(first->moves());
  ASSERT_TRUE(second->bends());
  ASSERT_TRUE(third->bends());
  const auto placesOf = [](const std::shared_ptr<const Scene>& scene) -> const std::vector<Vec3>&
  { return scene->surfaces()[0].tree->mesh().vertices_W; };
  EXPECT_EQ(second->surfaces()[0].from->vertices_W, placesOf(first));
  EXPECT_EQ(second->continuesGeometry(), first->geometryHash());
  EXPECT_EQ(third->continuesGeometry(), second->geometryHash());
  for (std::size_t i = 0; i < placesOf(first).size(); ++i)
  {
    const Vec3 felt_W = 0.6 * placesOf(first)[i] + 0.4 * placesOf(second)[i];
    ASSERT_LE((third->surfaces()[0].from->vertices_W[i] - felt_W).norm(), 1e-15);
  }
}

TEST(MovingInputs, AWayGoesOnInANewSceneOfTheSameVertices)
{
  Series series;
  const TriangleMesh flat = unweldedSheet(), bent = warped(flat);
  static_cast<void>(series.next(flat, 1.0));
  const SurfaceInput same = input(bent);
  const auto moving = movingFrom(*series.felt, 1.0, series.builder.build({ same }, series.felt.get()).scene, 0.05);
  const auto again = movingFrom(*moving, 0.5, series.builder.build({ same }, moving.get()).scene, 0.05);
  ASSERT_TRUE(again->bends());
  EXPECT_EQ(again->surfaces()[0].tree, moving->surfaces()[0].tree);
  for (std::size_t i = 0; i < again->surfaces()[0].from->vertices_W.size(); ++i)
  {
    const Vec3 &end = moving->surfaces()[0].tree->mesh().vertices_W[i],
               &begin = moving->surfaces()[0].from->vertices_W[i];
    ASSERT_LE((again->surfaces()[0].from->vertices_W[i] - 0.5 * (begin + end)).norm(), 1e-15);
  }
  EXPECT_FALSE(movingFrom(*moving, 1.0, series.builder.build({ same }, moving.get()).scene, 0.05)->bends())
    << "arrived";
}

TEST(MovingInputs, AWayGoesOnThoughTheSameVerticesWereBuiltAnewByOneWhoKnewNothingOfIt)
{
  Series series;
  const TriangleMesh flat = unweldedSheet(), bent = warped(flat);
  static_cast<void>(series.next(flat, 1.0));
  const auto moving = series.next(bent, 1.0);
  ASSERT_TRUE(moving->bends());
  const auto anew = SceneBuilder().build({ input(bent) }).scene;
  ASSERT_EQ(anew->geometryHash(), moving->geometryHash()) << "nobody would take it for another surface";
  const auto again = movingFrom(*moving, 0.5, anew, 0.05);
  ASSERT_TRUE(again->bends());
  for (std::size_t i = 0; i < again->surfaces()[0].from->vertices_W.size(); ++i)
  {
    const Vec3 &end = moving->surfaces()[0].tree->mesh().vertices_W[i],
               &begin = moving->surfaces()[0].from->vertices_W[i];
    ASSERT_LE((again->surfaces()[0].from->vertices_W[i] - 0.5 * (begin + end)).norm(), 1e-15);
  }
}

TEST(MovingInputs, WhatIsNotFeltWhereItWouldComeFromIsThereAtOnce)
{
  Series series;
  const TriangleMesh flat = unweldedSheet(), bent = warped(flat);
  const auto first = series.next(flat, 1.0);
  const auto straight = series.builder.build({ input(bent) }).scene; // nobody said from where
  EXPECT_FALSE(movingFrom(*first, 1.0, straight, 0.05)->moves());
  const auto second = series.next(warped(bent), 1.0); // comes from the first scene
  EXPECT_TRUE(second->bends());
  const auto third = series.builder.build({ input(bent) }, second.get()).scene;
  EXPECT_FALSE(movingFrom(*first, 1.0, third, 0.05)->moves()) << "the second is felt, not the first";
  SurfaceInput posed = input(warped(flat));
  posed.pose_WS.p = { 0, 0, 1 };
  posed.frame = 7;
  const auto fourth = series.builder.build({ posed }, third.get()).scene;
  EXPECT_FALSE(movingFrom(*third, 1.0, fourth, 0.05)->bends()) << "posed in another frame";
}

TEST(MovingInputs, VerticesGoStraightInTheirFrameWhileItMovesAndBothBeginWhereTheyAreFelt)
{
  SceneBuilder builder;
  const auto at = [&](const TriangleMesh& mesh, double z, const Scene* felt)
  {
    SurfaceInput sheet = input(mesh);
    sheet.pose_WS.p.z() = z;
    sheet.frame = 7;
    return builder.build({ sheet }, felt).scene;
  };
  const TriangleMesh flat = unweldedSheet(), bent = warped(flat), more = warped(bent);
  const auto first = at(flat, 1.0, nullptr);
  const auto second = movingFrom(*first, 1.0, at(bent, 3.0, first.get()), 0.05);
  const auto third = movingFrom(*second, 0.25, at(more, 4.0, second.get()), 0.05);
  const Surface &is = second->surfaces()[0], &next = third->surfaces()[0];
  ASSERT_TRUE(is.from);
  EXPECT_EQ(is.from->vertices_W, first->surfaces()[0].tree->mesh().vertices_W);
  EXPECT_EQ(is.motion.begin_WS.p.z(), 1.0);
  EXPECT_EQ(is.motion.end_WS.p.z(), 3.0);
  EXPECT_EQ(second->continuesGeometry(), first->geometryHash());
  ASSERT_TRUE(next.from);
  EXPECT_EQ(next.motion.begin_WS.p.z(), 1.0 + 0.25 * 2.0);
  for (std::size_t i = 0; i < next.from->vertices_W.size(); ++i)
  {
    const Vec3 felt_S = 0.75 * is.from->vertices_W[i] + 0.25 * is.tree->mesh().vertices_W[i];
    ASSERT_LE((next.from->vertices_W[i] - felt_S).norm(), 1e-15);
  }
}

TEST(MovingInputs, OnlyASurfaceOnItsWayTakesTheRoomOfItAndTheContentIsTheSame)
{
  Series series;
  static_cast<void>(series.next(unweldedSheet(), 1.0));
  const SurfaceInput same = input(shifted(warped(unweldedSheet()), Vec3(0, 0, 1)));
  const auto height = [](const Scene& scene)
  { return scene.surfaceTree().bounds.high_W.z() - scene.surfaceTree().bounds.low_W.z(); };
  const auto next = series.builder.build({ same }, series.felt.get()).scene;
  const auto moving = movingFrom(*series.felt, 1.0, next, 0.05);
  EXPECT_TRUE(series.builder.knows({ same }));
  EXPECT_NE(next->surfaces()[0].tree->wayName(), 0u);
  SceneBuilder fromNowhere;
  static_cast<void>(fromNowhere.build({ input(unweldedSheet()) }));
  EXPECT_EQ(next->geometryHash(), fromNowhere.build({ same }).scene->geometryHash());
  EXPECT_LT(height(*next), 0.2);
  EXPECT_GT(height(*moving), 1.0);
}

TEST(MovingInputs, TheMeshOfATreeInItsOrderIsThatTreeAgain)
{
  SceneBuilder builder;
  const TriangleMesh flat = unweldedSheet();
  static_cast<void>(builder.build({ input(flat) }));
  const auto refitted = builder.build({ input(warped(flat)) }).scene;
  SurfaceInput ordered = input(refitted->surfaces()[0].tree->mesh());
  ordered.ordered = true;
  const auto again = SceneBuilder().build({ ordered }).scene;
  ASSERT_TRUE(again);
  EXPECT_EQ(again->geometryHash(), refitted->geometryHash());
  TriangleMesh broken = *ordered.mesh;
  broken.triangles[3][2] = 1000000;
  ordered.mesh = std::make_shared<TriangleMesh>(broken);
  EXPECT_EQ(SceneBuilder().build({ ordered }).reports[0].refusal, "triangle 3 is invalid after cleaning");
}

TEST(MovingInputs, LinesInTheirOrderWithARadiusThatCannotBeAreRefusedAsAnyOthers)
{
  SurfaceInput lines = input(segmentsOf({ { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY() }, { { 0, 1, 2 } } }));
  lines.lineRadius_u = 0.1;
  lines = input(SceneBuilder().build({ lines }).scene->surfaces()[0].tree->mesh());
  for (const double radius_u : { std::numeric_limits<double>::quiet_NaN(), -0.1, 0.0, 1e-12, 0.1 })
  {
    lines.lineRadius_u = radius_u;
    lines.ordered = false;
    const SceneBuildResult cleaned = SceneBuilder().build({ lines });
    lines.ordered = true;
    const SceneBuildResult ordered = SceneBuilder().build({ lines });
    EXPECT_EQ(ordered.reports[0].refusal, cleaned.reports[0].refusal);
    EXPECT_EQ(ordered.scene != nullptr, radius_u == 0.1) << radius_u;
  }
}

} // namespace
} // namespace palpate::test
