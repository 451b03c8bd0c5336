// SPDX-License-Identifier: GPL-3.0-or-later
// A proxy pressed on a surface that is replaced stays on its side.
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

class SceneChange : public ::testing::TestWithParam<double>
{
};

TEST_P(SceneChange, TheSameSurfaceAgainChangesNothing)
{
  const double r = GetParam();
  const NoisySphere sphere(5000, 1.0);
  Probe steady(sceneOf(sphere.mesh()), r, slideStart_W(sphere)), swapped = steady;
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    if (i % 10 == 0)
    {
      swapped.changeScene(sceneOf(sphere.mesh()));
    }
    steady.to(slideOver(sphere, i).p_W);
    swapped.to(slideOver(sphere, i).p_W);
    ASSERT_LE((swapped.x_W() - steady.x_W()).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(SceneChange, OnAFinerPlaneTheProxyStaysWhereItIs)
{
  const double r = GetParam();
  Random random(testSeed(131));
  Probe probe(sceneOf(makeSheet({ 2, 2, 5, 5, 0.3 }, random)), r, { 0.1, 0.2, 1 });
  probe.to({ 0.1, 0.2, -0.5 });
  for (int cells = 6; cells < 60; ++cells)
  {
    probe.changeScene(sceneOf(makeSheet({ 2, 2, cells, cells, 0.3 }, random)));
    EXPECT_GT(probe.to({ 0.1, 0.2, -0.5 }).contacts, 0);
    ASSERT_LE((probe.x_W() - Vec3(0.1, 0.2, r)).norm(), 1e-12) << cells << " cells";
  }
}

TEST_P(SceneChange, WhenTheSurfaceIsGoneTheProxyGoesToTheDevice)
{
  const double r = GetParam();
  Random random(testSeed(132));
  Probe probe(sceneOf(makeSheet({ 2, 2, 5, 5, 0.3 }, random)), r, { 0.1, 0.2, 1 });
  probe.to({ 0.1, 0.2, -0.5 });
  probe.changeScene(std::make_shared<const Scene>());
  EXPECT_EQ(probe.to({ 0.1, 0.2, -0.5 }).contacts, 0);
  EXPECT_EQ(probe.x_W(), Vec3(0.1, 0.2, -0.5));
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, SceneChange, ::testing::Values(0.0, 0.1));

} // namespace
} // namespace palpate::test
