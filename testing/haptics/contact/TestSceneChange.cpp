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

TEST_P(SceneChange, UnderFrictionTheSameSurfaceAgainChangesNothing)
{
  const double r = GetParam();
  const NoisySphere sphere(5000, 1.0);
  Probe steady(sceneOf(sphere.mesh()), r, slideStart_W(sphere));
  steady.plan().friction = { 0.5, 0.3 };
  Probe swapped = steady;
  int slips = 0;
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    if (i % 10 == 0)
    {
      swapped.changeScene(sceneOf(sphere.mesh()));
    }
    const ContactResult expected = steady.to(slideOver(sphere, i).p_W), result = swapped.to(slideOver(sphere, i).p_W);
    ASSERT_LE((swapped.x_W() - steady.x_W()).norm(), 1e-9) << "tick " << i;
    ASSERT_EQ(result.friction, expected.friction) << "tick " << i;
    slips += result.friction == FrictionState::Slips ? 1 : 0;
  }
  EXPECT_GT(slips, 0);
}

TEST_P(SceneChange, FrictionHoldsAndTrailsOnAFinerPlaneAsBefore)
{
  const double r = GetParam(), depth = 0.5, step = 0.01;
  const FrictionPlan mu{ 0.5, 0.3 };
  Random random(testSeed(133));
  Probe probe(sceneOf(makeSheet({ 4, 2, 5, 5, 0.3 }, random)), r, { 0, 0.2, 1 });
  probe.plan().friction = mu;
  probe.to({ 0, 0.2, r - depth });
  for (int i = 0; i < 60; ++i)
  {
    probe.changeScene(sceneOf(makeSheet({ 4, 2, 6 + i % 20, 6 + i % 20, 0.3 }, random)));
    const double x = (i + 0.5) * step; // 0.25 lies between two of them: there it breaks away, once
    const bool sticks = x < mu.statical * depth;
    const ContactResult result = probe.to({ x, 0.2, r - depth });
    EXPECT_EQ(result.friction, sticks ? FrictionState::Sticks : FrictionState::Slips) << x;
    const Vec3 expected_W(sticks ? 0.0 : x - mu.kinetic * depth, 0.2, r);
    ASSERT_LE((probe.x_W() - expected_W).norm(), 1e-9) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, SceneChange, ::testing::Values(0.0, 0.1));

} // namespace
} // namespace palpate::test
