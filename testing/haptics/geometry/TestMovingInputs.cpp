// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes built one after another of surfaces that move: what is built anew, what is refitted, and from where it moves.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/geometry/SceneBuilder.h"
#include "haptics/geometry/SceneMotion.h"
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
  const TriangleMesh sheet = makeSheet({ 1.0, 1.0, 8, 8, 0.3 }, random);
  TriangleMesh apart;
  for (const auto& triangle : sheet.triangles)
  {
    const auto first = static_cast<std::uint32_t>(apart.vertices_W.size());
    for (const std::uint32_t corner : triangle)
    {
      apart.vertices_W.push_back(sheet.vertices_W[corner]);
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  return apart;
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

TEST(MovingInputs, ASurfaceThatTearsOrLosesTrianglesIsBuiltAnew)
{
  const TriangleMesh flat = unweldedSheet();
  TriangleMesh torn = flat, fewer = flat, collapsed = flat, broken = flat;
  torn.vertices_W[0].z() += 0.1; // its neighbours' copies of that corner stay
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
  // The next snapshot comes at a quarter of that way.
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

} // namespace
} // namespace palpate::test
