// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/session/plan/FittedMap.h"

namespace palpate
{
namespace
{

BuiltScene boxOf(const Vec3& low_W, const Vec3& high_W)
{
  BuiltScene scene;
  scene.bounds = { low_W.x(), high_W.x(), low_W.y(), high_W.y(), low_W.z(), high_W.z() };
  return scene;
}

TEST(FittedMap, TheCornersOfTheSceneAreAsFarFromTheDevicesOriginAsItReaches)
{
  const Vec3 low_W(1.0, -2.0, 3.0), high_W(7.0, 4.0, 9.0);
  DeviceInfo device;
  device.workspaceRadius_m.value = 0.08;
  WorkspaceMap before;
  before.q_WD = Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()));
  const WorkspaceMap map = fittedMap(before, boxOf(low_W, high_W), device);
  EXPECT_NEAR(map.toDevice(low_W).norm(), 0.08, 1e-15);
  EXPECT_NEAR(map.toDevice(high_W).norm(), 0.08, 1e-15);
  EXPECT_EQ(map.q_WD.coeffs(), before.q_WD.coeffs());
}

TEST(FittedMap, ADeviceThatMovesInAPlaneIsTurnedIntoThatOfAPlaneWorldOnly)
{
  BuiltScene world = boxOf(Vec3::Zero(), Vec3::Ones());
  world.plane_WP = Pose{ Vec3::Zero(), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX())) };
  DeviceInfo inPlane;
  inPlane.abilities.sensedAxes = 2;
  EXPECT_EQ(fittedMap({}, world, inPlane).q_WD.coeffs(), world.plane_WP->q.coeffs());
  EXPECT_EQ(fittedMap({}, world, DeviceInfo()).q_WD.coeffs(), Quat::Identity().coeffs());
  world.plane_WP.reset();
  EXPECT_EQ(fittedMap({}, world, inPlane).q_WD.coeffs(), Quat::Identity().coeffs());
}

} // namespace
} // namespace palpate
