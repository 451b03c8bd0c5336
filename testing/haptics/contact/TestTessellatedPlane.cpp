// SPDX-License-Identifier: GPL-3.0-or-later
// Row 14: the inner edges of a tessellated plane cannot be felt.
#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr double planeSpring_N_per_m = 1000.0;
constexpr double depth_m = 2e-3;

struct Case
{
  const char* name;
  double radius_m;
  Vec3 normal;
};

class TessellatedPlane : public ::testing::TestWithParam<Case>
{
};

TEST_P(TessellatedPlane, ASlideOfOneMetreHasNoLateralForceAndNoRipple)
{
  const auto& [name, r, normal] = GetParam();
  Random random(testSeed(81));
  const TriangleMesh flat = makeSheet({ 1.2, 1.2, 200, 200, 0.35 }, random);
  const Quat q = shortestTurn(Vec3::UnitZ(), normal);
  Probe probe(sceneOf(rotated(flat, q)), r, q * Vec3(-0.5, -0.05, 0.01));
  double lateral_N = 0.0, ripple_N = 0.0;
  const std::size_t ticks = testCount(10000); // 0.1 mm each
  for (std::size_t i = 0; i <= ticks; ++i)
  {
    const double s = static_cast<double>(i) / static_cast<double>(ticks);
    const ContactResult result = probe.to(q * Vec3(-0.5 + s, -0.05 + 0.1 * s, r - depth_m));
    const Vec3 force = q.conjugate() * probe.force(planeSpring_N_per_m);
    lateral_N = std::max(lateral_N, force.head<2>().norm());
    ripple_N = std::max(ripple_N, std::fabs(force.z() - planeSpring_N_per_m * depth_m)); // F_n = K p = 2 N
    ASSERT_EQ(result.contacts, 1) << "tick " << i;
  }
  EXPECT_LE(lateral_N, 1e-9);
  EXPECT_LE(ripple_N, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Row14, TessellatedPlane,
  ::testing::Values(Case{ "Point", 0.0, Vec3::UnitZ() }, Case{ "Ball", 1e-3, Vec3::UnitZ() },
    Case{ "PointTilted", 0.0, Vec3(0.3, -0.5, 0.8).normalized() },
    Case{ "BallTilted", 1e-3, Vec3(0.3, -0.5, 0.8).normalized() }),
  [](const auto& info) { return info.param.name; });

} // namespace
} // namespace palpate::test
