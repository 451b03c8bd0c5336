// SPDX-License-Identifier: GPL-3.0-or-later
// Row 8: a plate much thinner than the push keeps the side from which it was touched.
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr double plateSpring_N_per_m = 1000.0;
constexpr double thickness_m = 0.5e-3;

TriangleMesh plate()
{
  return makeBox({ -0.05, -0.05, -thickness_m }, { 0.05, 0.05, 0 });
}

class ThinPlate : public ::testing::TestWithParam<double>
{
};

TEST_P(ThinPlate, TheForceGrowsAlongTheEntryNormalFarBeyondTheThickness)
{
  const double r = GetParam();
  PathChecker checker(plate(), r, 1e-15);
  Probe probe(sceneOf(plate()), r, { 0.003, 0.004, 0.01 }, &checker);
  for (int step = 0; step <= 500; ++step) // 10 um each, to 5 mm
  {
    const double depth_m = 1e-5 * step;
    probe.to({ 0.003, 0.004, r - depth_m });
    const Vec3 force = probe.force(plateSpring_N_per_m);
    ASSERT_NEAR(force.z(), plateSpring_N_per_m * depth_m, 1e-9) << "depth " << depth_m << " m"; // so 0.01 N a step
    ASSERT_LE(force.head<2>().norm(), 1e-9) << "depth " << depth_m << " m";
  }
  EXPECT_EQ(probe.finding(), "");
}

TEST_P(ThinPlate, BothSidesHoldTheirOwn)
{
  const double r = GetParam();
  Probe below(sceneOf(plate()), r, { 0.003, 0.004, -0.01 });
  below.to({ 0.003, 0.004, 0.005 });
  EXPECT_NEAR(below.x_W().z(), -thickness_m - r, 1e-12);
}

TEST_P(ThinPlate, ReleaseIsFree)
{
  const double r = GetParam();
  Probe probe(sceneOf(plate()), r, { 0.003, 0.004, 0.01 });
  probe.to({ 0.003, 0.004, -0.005 });
  const Vec3 out(0.003, 0.004, 0.02);
  EXPECT_EQ(probe.to(out).contacts, 0);
  EXPECT_EQ(probe.x_W(), out);
}

INSTANTIATE_TEST_SUITE_P(Row8, ThinPlate, ::testing::Values(0.0, 0.25e-3, 1e-3));

} // namespace
} // namespace palpate::test
