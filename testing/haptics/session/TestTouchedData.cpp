// SPDX-License-Identifier: GPL-3.0-or-later
// From data to a scene to the ball that touches it, and a hand's path along that.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/path/PathTouch.h"
#include "haptics/session/scene/TouchedData.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using ::testing::HasSubstr;

/// A polyline as segments (a, b, b).
TouchedLines linesOf(const std::vector<Vec3>& points_W)
{
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices_W = points_W;
  for (std::uint32_t i = 0; i + 1 < points_W.size(); ++i)
  {
    mesh->triangles.push_back({ i, i + 1, i + 1 });
  }
  return { "lines", mesh };
}

TEST(TouchedData, LinesAreTubesOfTheRadiusThatIsAskedFor)
{
  TouchedLines lines = linesOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 3 } });
  lines.fields = std::make_shared<const MaterialFields>();
  const LineSurface tubes = tubesOf(lines, 0.25);
  ASSERT_TRUE(tubes.input.has_value());
  EXPECT_EQ(tubes.input->name, "lines (lines)");
  EXPECT_EQ(tubes.input->lineRadius_u, 0.25);
  EXPECT_EQ(tubes.input->mesh, lines.segments);
  EXPECT_EQ(tubes.input->fields, lines.fields);
  EXPECT_FALSE(tubes.plane_WP.has_value());
}

TEST(TouchedData, MoreLinesThanCanBeToldApartAreRefusedAsTubesAndAsWalls)
{
  auto many = std::make_shared<TriangleMesh>();
  many->vertices_W = { { 0, 0, 0 }, { 1, 0, 0 } };
  many->triangles.assign(mostSegments + 1, { 0, 1, 1 });
  for (const LineSurface& surface : { tubesOf({ "many", many }, 1.0), wallsAcross({ "many", many }, 1.0) })
  {
    EXPECT_FALSE(surface.input.has_value());
    EXPECT_THAT(surface.problem, HasSubstr(std::to_string(mostSegments)));
  }
}

/// Every corner of a wall is straight above or below its line by one height, which is more than the ball.
TEST(TouchedData, LinesInAPlaneAreWallsAcrossIt)
{
  test::Random random(test::testSeed(1403));
  constexpr double ball_u = 0.3;
  const Quat turn = shortestTurn(Vec3::UnitZ(), random.direction());
  const Vec3 shift = random.inCube(5.0);
  std::vector<Vec3> points_W;
  for (const Vec3& p : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0), Vec3(-1, 1, 0) })
  {
    points_W.push_back(turn * p + shift);
  }
  const LineSurface walls = wallsAcross(linesOf(points_W), ball_u);
  ASSERT_TRUE(walls.input.has_value()) << walls.problem;
  ASSERT_TRUE(walls.plane_WP.has_value());
  EXPECT_EQ(walls.input->name, "lines (walls)");
  EXPECT_EQ(walls.input->mesh->triangles.size(), 2 * (points_W.size() - 1));
  const Vec3 normal = turn * Vec3::UnitZ();
  EXPECT_NEAR(std::fabs(normal.dot(walls.plane_WP->q * Vec3::UnitZ())), 1.0, 1e-9);
  const double height_u = std::fabs(normal.dot(walls.input->mesh->vertices_W.front() - shift));
  EXPECT_GT(height_u, ball_u);
  for (const Vec3& corner : walls.input->mesh->vertices_W)
  {
    EXPECT_NEAR(std::fabs(normal.dot(corner - shift)), height_u, 1e-9);
    const Vec3 foot = corner - normal.dot(corner - shift) * normal;
    const auto near = [&foot](const Vec3& p) { return (p - foot).norm() < 1e-9; };
    EXPECT_TRUE(std::any_of(points_W.begin(), points_W.end(), near));
  }
}

TEST(TouchedData, LinesThatLieInNoPlaneOrNotInTheOneThatIsAskedForAreNoWalls)
{
  const TouchedLines space = linesOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 } });
  EXPECT_THAT(wallsAcross(space, 0.1).problem, HasSubstr("lie in no plane"));
  const TouchedLines high = linesOf({ { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 } });
  EXPECT_EQ(wallsAcross(high, 0.1).problem, "");
  EXPECT_NE(wallsAcross(high, 0.1, Pose()).problem, "");
  EXPECT_FALSE(wallsAcross(high, 0.1, Pose()).input.has_value());
}

SurfaceInput inputOf(const std::string& name, const TriangleMesh& mesh)
{
  SurfaceInput input;
  input.name = name;
  input.mesh = std::make_shared<const TriangleMesh>(mesh);
  return input;
}

TEST(TouchedData, ASceneIsThereOnlyWithEveryOneOfItsSurfaces)
{
  const SurfaceInput box = inputOf("box", test::makeBox({ 0, 0, 0 }, { 1, 1, 1 }));
  TriangleMesh nothing;
  nothing.vertices_W = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  nothing.triangles = { { 0, 1, 2 } }; // of no area
  const WholeScene whole = wholeScene({ box, inputOf("ball", test::makeIcosphere(1, 1.0)) });
  ASSERT_NE(whole.scene, nullptr);
  EXPECT_EQ(whole.scene->surfaces().size(), 2U);
  EXPECT_EQ(whole.refused + whole.refusal, "");
  const WholeScene part = wholeScene({ box, inputOf("none", nothing) });
  EXPECT_EQ(part.scene, nullptr);
  EXPECT_EQ(part.refused, "none");
  EXPECT_NE(part.refusal, "");
  EXPECT_EQ(part.reports.size(), 2U);
}

TEST(TouchedData, TheBallIsAsLargeAsAskedForUnlessTheLimitIsKept)
{
  const auto scene = test::sceneOf(test::makeIcosphere(6, 1.0));
  ContactPlan asked;
  asked.radius_u = 1e3;
  const ChosenBall free = chooseBall(*scene, asked, false), kept = chooseBall(*scene, asked, true);
  EXPECT_EQ(free.plan.radius_u, 1e3);
  EXPECT_FALSE(free.limit.kept());
  EXPECT_LT(kept.limit.largest_u, 1e3);
  EXPECT_EQ(kept.plan.radius_u, kept.limit.largest_u);
  asked.radius_u = 0.5 * kept.limit.largest_u;
  EXPECT_EQ(chooseBall(*scene, asked, true).plan.radius_u, asked.radius_u);
}

/// Into the plane z = 0 at uneven times: F = K d + b v with the speed of each step, so each tick is as long as it was.
TEST(PathTouch, EachTickIsAsLongAsTheTimeSinceTheOneBefore)
{
  test::Random random(test::testSeed(1404));
  HapticParameters parameters;
  parameters.damping_Ns_per_m = 3.0;
  parameters.velocity.method = VelocityMethod::BackwardDifference;
  PathTouch touch(test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random)), parameters, 0.5);
  double time_s = 1.0, depth_u = -0.01;
  EXPECT_EQ(touch.next(time_s, { Vec3(0, 0, -depth_u), Quat::Identity() }).force_W, Vec3(Vec3::Zero()));
  for (const double dt_s : { 0.02, 0.01, 0.04, 0.03 })
  {
    constexpr double deeper_u = 0.015;
    time_s += dt_s;
    depth_u += deeper_u;
    const HapticState state = touch.next(time_s, { Vec3(0, 0, -depth_u), Quat::Identity() });
    const double expected_N = parameters.stiffness_N_per_m * depth_u + parameters.damping_Ns_per_m * deeper_u / dt_s;
    EXPECT_NEAR(state.force_W.z(), expected_N, 1e-9) << dt_s;
    EXPECT_EQ(state.time_s, time_s);
  }
}

} // namespace
} // namespace palpate
