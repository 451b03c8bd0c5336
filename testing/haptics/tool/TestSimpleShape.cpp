// SPDX-License-Identifier: GPL-3.0-or-later
// Row 63: a mesh that is a ball or a needle to within a bound, and the force with the ball in its place.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "Tools.h"
#include "haptics/tool/mesh/SimpleShape.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr double ballRadius_mm = 10.0, within = 0.02;

/// How near the centre of a convex mesh about the origin its planes come.
double inradius(const TriangleMesh& mesh)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
  {
    const Vec3& a = mesh.vertices_W[t[0]];
    least = std::min(least, std::abs(a.dot((mesh.vertices_W[t[1]] - a).cross(mesh.vertices_W[t[2]] - a).normalized())));
  }
  return least;
}

/// A needle along x: the ball's two halves, drawn apart. Its vertices that lie in the middle belong to both.
TriangleMesh needle(double length_mm)
{
  TriangleMesh mesh =
    rotated(makeIcosphere(4, ballRadius_mm), Quat(Eigen::AngleAxisd(0.1, Vec3(0.3, 0.5, 0.8).normalized())));
  for (Vec3& v : mesh.vertices_W)
  {
    v.x() += v.x() > 0.0 ? 0.5 * length_mm : -0.5 * length_mm;
  }
  return mesh;
}

} // namespace

TEST(SimpleShape, OfAnIcosphereIsABallBetweenItsCornersAndItsPlanes)
{
  const Vec3 centre(3, -4, 5);
  for (const int levels : { 2, 3, 4 })
  {
    const TriangleMesh mesh = makeIcosphere(levels, ballRadius_mm);
    const double inner = inradius(mesh);
    const auto shape = simpleShapeOf(shifted(mesh, centre), within);
    const bool near = 0.5 * (ballRadius_mm - inner) <= within * 0.5 * (ballRadius_mm + inner);
    ASSERT_EQ(shape.has_value(), near) << levels;
    if (shape)
    {
      EXPECT_EQ(shape->kind, SimpleShape::Kind::Ball);
      EXPECT_LE((shape->from_B - centre).norm(), 1e-9);
      EXPECT_NEAR(shape->radius_u, 0.5 * (ballRadius_mm + inner), 1e-9);
      EXPECT_NEAR(shape->bound_u, 0.5 * (ballRadius_mm - inner), 1e-9);
    }
  }
}

TEST(SimpleShape, OfABallThatIsDrawnApartIsANeedle)
{
  const auto shape = simpleShapeOf(cleanMesh(needle(60.0)).mesh, within);
  ASSERT_TRUE(shape.has_value());
  EXPECT_EQ(shape->kind, SimpleShape::Kind::Needle);
  EXPECT_NEAR((shape->to_B - shape->from_B).norm(), 60.0, 2.0 * shape->bound_u);
  EXPECT_NEAR(shape->radius_u, ballRadius_mm, 2.0 * shape->bound_u);
  EXPECT_LE(shape->from_B.tail<2>().norm(), shape->bound_u);
}

TEST(SimpleShape, OfACubeOfHalfABallAndOfABallWithAHoleIsNone)
{
  EXPECT_FALSE(simpleShapeOf(makeBox(Vec3::Constant(-1), Vec3::Constant(1)), within));
  TriangleMesh holed = makeIcosphere(4, ballRadius_mm);
  holed.triangles.pop_back();
  EXPECT_FALSE(simpleShapeOf(holed, within));
  holed.triangles.resize(holed.triangles.size() / 2);
  EXPECT_FALSE(simpleShapeOf(cleanMesh(holed).mesh, within));
  EXPECT_FALSE(simpleShapeOf({}, within));
  EXPECT_FALSE(makeTool(makeBox(Vec3::Constant(-1), Vec3::Constant(1))).value.simple);
}

TEST(SimpleShape, ABallIsWhereItsMeshIsToWithinTheBoundRow63)
{
  const double slant = 45.0 * degree_rad;
  const TriangleMesh groove = makeGroove(slant, 50.0);
  const TriangleMesh mesh = makeIcosphere(4, ballRadius_mm);
  const auto shape = simpleShapeOf(mesh, within);
  ASSERT_TRUE(shape.has_value());
  JudgedTool tool(mesh, groove, 0);
  const Vec3 start_W(0, 1, 30);
  ASSERT_EQ(tool.move.place({ start_W, Quat::Identity() }), "");
  Probe ball(sceneOf(groove), shape->radius_u, start_W);
  for (int i = 0; i <= 60; ++i)
  {
    const Vec3 hand_W(8.0 * std::sin(0.2 * i), 1.0, 30.0 - 0.5 * i);
    tool.move.update({ hand_W, Quat::Identity() }, plenty);
    ball.to(hand_W);
    // Each wall holds either centre at its own distance, by the bound different; in the corner of both that is
    // 1 / sin of half their angle times it.
    EXPECT_LE(
      (tool.move.pose_W().p - ball.x_W()).norm(), (shape->bound_u + tool.tool.restGap_u()) / std::sin(slant) + 1e-6)
      << i;
  }
  ASSERT_TRUE(tool.tool.simple);
  EXPECT_NEAR(tool.tool.simple->radius_u, shape->radius_u, 1e-9);
  EXPECT_NE(describe(*tool.tool.simple).find("a ball of radius 9.9"), std::string::npos) << describe(*shape);
  EXPECT_LT(ball.x_W().z(), 20.0) << "it is in the groove";
}

} // namespace palpate::test
