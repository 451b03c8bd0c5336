// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "haptics/session/plan/AskedParameters.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

HapticParameters withBall(double radius_u)
{
  HapticParameters parameters;
  parameters.contact.radius_u = radius_u;
  return parameters;
}

BuiltScene allowing(double largest_u)
{
  BuiltScene scene;
  scene.largestRadius_u = largest_u;
  return scene;
}

/// The servo takes its commands.
void ask(AskedParameters& parameters, const HapticParameters& asked, const BuiltScene& scene)
{
  parameters.taken(asked, parameters.told(asked, scene));
}

TEST(AskedParameters, TellABallNoLargerThanTheSceneAllowsAndRememberTheOneAskedFor)
{
  AskedParameters parameters{ HapticParameters() };
  ask(parameters, withBall(5.0), allowing(2.0));
  EXPECT_EQ(parameters.asked().contact.radius_u, 5.0);
  EXPECT_EQ(parameters.touch(allowing(2.0)).plan.radius_u, 2.0);
  EXPECT_FALSE(parameters.otherBall(allowing(2.0)).has_value()) << "the servo has it";
  const auto larger = parameters.otherBall(allowing(3.0));
  ASSERT_TRUE(larger.has_value());
  EXPECT_EQ(larger->contact.radius_u, 3.0);
  EXPECT_TRUE(parameters.otherBall(allowing(3.0)).has_value()) << "until the servo has taken it";
  parameters.ballTaken(*larger);
  EXPECT_FALSE(parameters.otherBall(allowing(3.0)).has_value());
  EXPECT_EQ(parameters.otherBall(allowing(std::numeric_limits<double>::infinity()))->contact.radius_u, 5.0);
}

TEST(AskedParameters, WithoutTheLimitTheBallIsTheOneAskedFor)
{
  AskedParameters parameters{ HapticParameters() };
  parameters.limitRadius = false;
  ask(parameters, withBall(5.0), allowing(2.0));
  EXPECT_EQ(parameters.touch(allowing(2.0)).plan.radius_u, 5.0);
  parameters.limitRadius = true;
  EXPECT_EQ(parameters.otherBall(allowing(2.0))->contact.radius_u, 2.0);
}

DeviceInfo inSpace()
{
  DeviceInfo info;
  info.deviceClass = DeviceClass::Point3D;
  return info;
}

TEST(AskedParameters, FollowThePlaneOfASceneOnceAndLetTheBallAlone)
{
  AskedParameters parameters{ HapticParameters() };
  ask(parameters, withBall(5.0), allowing(2.0));
  BuiltScene plane = allowing(1.0);
  plane.plane_WP = Pose{ Vec3(0, 0, 3), Quat::Identity() };
  const auto told = parameters.otherPlane(plane, inSpace());
  ASSERT_TRUE(told.has_value());
  EXPECT_TRUE(told->guide.on);
  EXPECT_EQ(told->guide.point_W, plane.plane_WP->p);
  EXPECT_EQ(told->contact.radius_u, 2.0) << "not in the tick of a swap, in which a pressed hand changes over";
  EXPECT_EQ(parameters.asked().contact.radius_u, 5.0);
  EXPECT_FALSE(parameters.otherPlane(plane, inSpace()).has_value());
  parameters.plane.guide = false;
  EXPECT_FALSE(parameters.otherPlane(plane, inSpace())->guide.on);
  parameters.plane.guide = true;
  EXPECT_TRUE(parameters.otherPlane(plane, inSpace())->guide.on);
  EXPECT_FALSE(parameters.otherPlane(allowing(1.0), inSpace())->guide.on) << "no plane any more";
}

TEST(AskedParameters, SayByWhatASceneOfTubesIsTouched)
{
  AskedParameters parameters{ withBall(0.0) };
  SurfaceInput lines;
  lines.name = "lines";
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices_W = { { 0, 0, 0 }, { 1, 0, 0 } };
  mesh->triangles = { { 0, 1, 1 } };
  lines.mesh = mesh;
  lines.lineRadius_u = 2.0;
  lines.material.frictionStatic = lines.material.frictionKinetic = 0.5;
  BuiltScene scene = allowing(7.0);
  scene.scene = SceneBuilder().build({ lines }).scene;
  ASSERT_NE(scene.scene, nullptr);
  const TouchChoice touch = parameters.touch(scene);
  EXPECT_EQ(touch.plan.radius_u, 2e-3) << "a point is a ball of a thousandth of the thinnest curve";
  EXPECT_EQ(touch.asked_u, 0.0);
  EXPECT_EQ(touch.largest_u, 7.0);
  EXPECT_TRUE(touch.frictionFromData);
}

} // namespace
} // namespace palpate
