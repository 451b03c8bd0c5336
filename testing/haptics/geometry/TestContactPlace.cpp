// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/geometry/measure/ContactPlace.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Meshes.h"

namespace palpate::test::places
{
namespace
{

SurfaceInput input(const std::string& name, const TriangleMesh& mesh)
{
  return { name, std::make_shared<const TriangleMesh>(mesh), Material() };
}

TEST(ContactPlace, IsOnTheNearestSurfaceWithItsNormalToTheSideOfTheProxyAndTheWallBehindIt)
{
  const auto scene = SceneBuilder()
                       .build({ input("far", makeBox(Vec3(10, 10, 10), Vec3(11, 11, 11))),
                         input("plate", makeBox(Vec3(-5, -5, 0), Vec3(5, 5, 0.25))) })
                       .scene;
  const auto above = placeOf(*scene, Vec3(1, 2, 0.25), Vec3(1, 2, 0.1));
  ASSERT_TRUE(above);
  EXPECT_EQ(above->surface, "plate");
  EXPECT_EQ(above->p_W, Vec3(1, 2, 0.25));
  EXPECT_EQ(above->normal_W, Vec3(0, 0, 1));
  ASSERT_TRUE(above->curvature && above->thickness_u);
  EXPECT_EQ(above->curvature->largest_per_u, 0.0);
  EXPECT_DOUBLE_EQ(*above->thickness_u, 0.25);

  const auto within = placeOf(*scene, Vec3(1, 2, 0.25), Vec3(1, 2, 0.4)); // pressed from inside the plate
  ASSERT_TRUE(within);
  EXPECT_EQ(within->normal_W, Vec3(0, 0, -1));
  EXPECT_FALSE(within->thickness_u) << "outwards there is no wall";

  const auto ball = placeOf(*scene, Vec3(1, 2, 0.75), Vec3(1, 2, 0.7)); // the centre of a ball of 0.5
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->p_W, Vec3(1, 2, 0.25));
  EXPECT_EQ(ball->normal_W, Vec3(0, 0, 1));
}

TEST(ContactPlace, OfATurnedSurfaceIsInTheSceneFrame)
{
  SurfaceInput plate = input("plate", makeBox(Vec3(-5, -5, 0), Vec3(5, 5, 0.25)));
  plate.pose_WS.q = Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitY())); // z to x
  plate.pose_WS.p = Vec3(100, 0, 0);
  const auto scene = SceneBuilder().build({ plate }).scene;
  const auto place = placeOf(*scene, Vec3(100.25, 1, 2), Vec3(100.1, 1, 2));
  ASSERT_TRUE(place);
  EXPECT_NEAR((place->p_W - Vec3(100.25, 1, 2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((place->normal_W - Vec3::UnitX()).norm(), 0.0, 1e-12);
  ASSERT_TRUE(place->thickness_u);
  EXPECT_NEAR(*place->thickness_u, 0.25, 1e-12);
}

TEST(ContactPlace, OfATubeIsOnItsLineWithoutCurvatureOrWall)
{
  TriangleMesh line;
  line.vertices_W = { { 0, 0, 0 }, { 10, 0, 0 } };
  line.triangles = { { 0, 1, 1 } };
  SurfaceInput tube = input("tube", line);
  tube.lineRadius_u = 0.5;
  const auto scene = SceneBuilder().build({ tube, input("box", makeBox(Vec3(3, -1, 0.6), Vec3(5, 1, 2))) }).scene;
  const auto place = placeOf(*scene, Vec3(4, 0, 0.5), Vec3(4, 0, 0.4)); // on the tube; nearer to the box than its line
  ASSERT_TRUE(place);
  EXPECT_EQ(place->surface, "tube");
  EXPECT_EQ(place->p_W, Vec3(4, 0, 0));
  EXPECT_EQ(place->normal_W, Vec3(0, 0, 1));
  EXPECT_FALSE(place->curvature || place->thickness_u);
}

TEST(ContactPlace, IsNoneInAnEmptyScene)
{
  EXPECT_FALSE(placeOf(Scene(), Vec3::Zero(), Vec3::Zero()));
}

} // namespace
} // namespace palpate::test::places
