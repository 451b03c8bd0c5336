// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/session/mechanism/BallMesh.h"

namespace palpate::test
{
namespace
{

TEST(BallMesh, IsClosedOnItsSphereAndMeetsEachAxisInAVertex)
{
  constexpr double radius_u = 3.0;
  const TriangleMesh ball = ballMesh(radius_u);
  for (const Vec3& p : ball.vertices_W)
  {
    EXPECT_NEAR(p.norm(), radius_u, 1e-14 * radius_u);
  }
  EXPECT_EQ(makeRigidMesh(ball).problem, "");
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 1.0, -1.0 })
    {
      EXPECT_NE(std::ranges::find(ball.vertices_W, Vec3(side * radius_u * Vec3::Unit(axis))), ball.vertices_W.end());
    }
  }
  for (const auto& [a, b, c] : ball.triangles)
  {
    const Vec3 n = (ball.vertices_W[b] - ball.vertices_W[a]).cross(ball.vertices_W[c] - ball.vertices_W[a]);
    EXPECT_GE(n.normalized().dot(ball.vertices_W[a]), (1.0 - 1.0 / 250.0) * radius_u) << "right-handed, and so near";
  }
}

} // namespace
} // namespace palpate::test
