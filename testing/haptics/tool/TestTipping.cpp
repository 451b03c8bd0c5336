// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 29 and 60: a cube pressed on a plane and tilted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Tools.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate::test
{
namespace
{

constexpr double half_mm = 20.0;

struct Rest
{
  double tilt_rad, height_mm;
};

/// Nearest pose of the planar problem by a one-dimensional search: of an angle between 0 and the device's, the centre
/// is at the device's height or, if that is lower, where the lowest corner touches.
Rest nearestRest(double depth_mm, double tilt_rad, double lever_mm)
{
  const double device_mm = half_mm - depth_mm;
  const auto height = [](double t) { return half_mm * (std::cos(t) + std::sin(t)); };
  const auto cost = [&](double t)
  {
    const double lift = std::max(height(t) - device_mm, 0.0), turn = lever_mm * (t - tilt_rad);
    return lift * lift + turn * turn;
  };
  double low = 0.0, high = tilt_rad;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 200; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (cost(a) < cost(b) ? high : low) = cost(a) < cost(b) ? b : a;
  }
  const double tilt = 0.5 * (low + high);
  return { tilt, std::max(height(tilt), device_mm) };
}

struct TippedCube
{
  ToolMesh tool = makeTool(makeBox(Vec3::Constant(-half_mm), Vec3::Constant(half_mm))).value;
  std::shared_ptr<const BoxedMesh> plane;

  explicit TippedCube(int cells)
  {
    Random random(testSeed(2901));
    this->plane = makeToolScene(
      cleanMesh(makeSheet({ 200.0, 200.0, cells, cells, cells > 1 ? 0.3 : 0.0 }, random)).mesh, this->tool);
  }
};

/// Tilt about y, so that one lower edge stays down.
double tiltOf(const Pose& pose)
{
  return rotationVector(pose.q).y();
}

void expectTable(const TippedCube& scene, double lever_mm)
{
  for (const double depth_mm : { 1.0, 2.0, 5.0 })
  {
    for (const double tilt_deg : { 1.0, 5.0, 10.0, 20.0, 30.0, 40.0 })
    {
      ToolMove move(scene.tool, scene.plane, lever_mm);
      ASSERT_EQ(move.place({ Vec3(0.3, 0.2, half_mm + 1.0), Quat::Identity() }), "");
      const Pose device_W{ Vec3(0.3, 0.2, half_mm - depth_mm), turnBy(Vec3(0.0, tilt_deg * degree_rad, 0.0)) };
      ToolUpdate last;
      for (int i = 0; i < 20 && !last.converged; ++i)
      {
        last = move.update(device_W, 1u << 20);
      }
      const Rest expected = nearestRest(depth_mm, tilt_deg * degree_rad, lever_mm);
      EXPECT_TRUE(last.converged);
      EXPECT_NEAR(tiltOf(move.pose_W()) / degree_rad, expected.tilt_rad / degree_rad, 1e-4)
        << depth_mm << " " << tilt_deg;
      EXPECT_NEAR(move.pose_W().p.z() - scene.tool.restGap_u(), expected.height_mm, 1e-4)
        << depth_mm << " " << tilt_deg;
    }
  }
}

} // namespace

TEST(Tipping, OfACubePressedOnAPlaneOfTwoTrianglesIsThatOfTheNearestPoseInTheMassMetricRow29)
{
  const TippedCube scene(1);
  // The table's own rows: this test's search finds them.
  EXPECT_NEAR(nearestRest(1.0, 5.0 * degree_rad, scene.tool.gyration_u).tilt_rad / degree_rad, 0.29122, 1e-5);
  EXPECT_NEAR(nearestRest(5.0, 40.0 * degree_rad, scene.tool.gyration_u).height_mm, 23.51577, 1e-5);
  expectTable(scene, scene.tool.gyration_u);
}

TEST(Tipping, IsThatOfTheNearestPoseInTheMetricOfASpringRow29)
{
  const double lever_mm = 1e3 * std::sqrt(2.0 / 1000.0); // 2 N m/rad over 1000 N/m
  EXPECT_NEAR(nearestRest(5.0, 40.0 * degree_rad, lever_mm).tilt_rad / degree_rad, 38.86336, 1e-5);
  expectTable(TippedCube(1), lever_mm);
}

TEST(Tipping, IsTheSameOnAPlaneOfManyTrianglesRow29)
{
  const TippedCube scene(70);
  expectTable(scene, scene.tool.gyration_u);
}

TEST(Tipping, SweptBy10RadiansASecondNeverStallsAndIsTheNearestPoseInEveryUpdateRow62)
{
  constexpr double rate_rad_s = 10.0, update_s = 1e-3, depth_mm = 2.0;
  for (const double lever_mm : { 1e3 * std::sqrt(2.0 / 1000.0), TippedCube(1).tool.gyration_u })
  {
    const TippedCube scene(1);
    ToolMove move(scene.tool, scene.plane, lever_mm);
    ASSERT_EQ(move.place({ Vec3(0, 0, half_mm + 1.0), Quat::Identity() }), "");
    double worst_deg = 0.0;
    for (double tilt = 0.0; tilt < 40.0 * degree_rad; tilt += rate_rad_s * update_s)
    {
      const ToolUpdate done =
        move.update({ Vec3(0, 0, half_mm - depth_mm), turnBy(Vec3(0, tilt, 0)) }, ToolFollower::usualWork);
      EXPECT_TRUE(done.converged) << tilt;
      const double truth = nearestRest(depth_mm, tilt, lever_mm).tilt_rad;
      worst_deg = std::max(worst_deg, std::abs(tiltOf(move.pose_W()) - truth) / degree_rad);
    }
    EXPECT_LE(worst_deg, 2e-4);
  }
}

} // namespace palpate::test
