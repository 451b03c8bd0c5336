// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 23, 24 and 26: Coulomb friction of the trailing god-object.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/support/Corners.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double K = 1000.0; // N/m; scenes in metres

std::shared_ptr<const Scene> floorScene()
{
  test::Random random(test::testSeed(81));
  return test::sceneOf(test::makeSheet({ 0.4, 0.4, 20, 20, 0.3 }, random));
}

test::Probe pressed(
  const std::shared_ptr<const Scene>& scene, const FrictionPlan& friction, double depth, double radius = 0.0)
{
  test::Probe probe(scene, radius, { 0, 0, 0.01 + radius });
  probe.plan().friction = friction;
  probe.to({ 0, 0, radius - depth });
  return probe;
}

class FrictionOnAPlane : public testing::TestWithParam<double>
{
};

TEST_P(FrictionOnAPlane, BreaksAwayAtTheStaticConeAndTrailsByTheKineticOne)
{
  const double radius = GetParam(), d = 2e-3, mu_s = 0.5, mu_k = 0.3;
  test::Probe probe = pressed(floorScene(), { mu_s, mu_k }, d, radius);
  const double step = 1e-5;
  bool slipped = false;
  for (int i = 1; i <= 400; ++i)
  {
    const double way = i * step;
    const ContactResult result = probe.to({ way, 0, radius - d });
    const Vec3 force = probe.force(K);
    EXPECT_NEAR(force.z(), K * d, 1e-9);
    EXPECT_NEAR(force.y(), 0.0, 1e-9);
    slipped = slipped || way > mu_s * d + 1e-9;
    EXPECT_EQ(result.friction, slipped ? FrictionState::Slips : FrictionState::Sticks) << way;
    // Before: the spring to the place it sticks at, up to mu_s K d = 1 N. After: mu_k K d = 0.6 N.
    EXPECT_NEAR(force.x(), slipped ? -mu_k * K * d : -K * way, 1e-9) << way;
  }
}

TEST_P(FrictionOnAPlane, LosesTheEnergyOfItsHysteresisLoop)
{
  const double radius = GetParam(), d = 2e-3, mu = 0.3, A = 5e-3;
  test::Probe probe = pressed(floorScene(), { mu, mu }, d, radius);
  const int quarter = 20000;
  double energy = 0.0, before = 0.0;
  Vec3 forceBefore = probe.force(K);
  for (int i = 1; i <= 9 * quarter; ++i) // the first quarter only leads to the loop
  {
    const double phase = static_cast<double>(i % (4 * quarter)) / quarter;
    const double way = A * (phase <= 1 ? phase : phase <= 3 ? 2 - phase : phase - 4);
    probe.to({ way, 0, radius - d });
    const Vec3 force = probe.force(K);
    energy -= i > 5 * quarter ? 0.5 * (force.x() + forceBefore.x()) * (way - before) : 0.0;
    before = way;
    forceBefore = force;
  }
  const double loop = 4 * mu * K * d * (A - mu * d);
  EXPECT_NEAR(energy, loop, 1e-6 * loop);
}

TEST_P(FrictionOnAPlane, NeverGivesBackWhatItTookWhileItSlips)
{
  const double radius = GetParam(), d = 2e-3;
  test::Probe probe = pressed(floorScene(), { 0.4, 0.25 }, d, radius);
  test::Random random(test::testSeed(82));
  Vec3 p(0, 0, radius - d), x = probe.x_W();
  for (std::size_t i = 0; i < test::testCount(5000); ++i)
  {
    p += Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0) * 2e-4;
    p = p.cwiseMax(-0.1).cwiseMin(0.1);
    p.z() = radius - d * random.uniform(0.5, 1.5);
    const ContactResult result = probe.to(p);
    if (result.friction == FrictionState::Slips)
    {
      const Vec3 moved = probe.x_W() - x;
      // Force on the hand and displacement of the contact point over the surface: friction resists it.
      EXPECT_LE(probe.force(K).head<2>().dot(moved.head<2>()), 1e-15) << "tick " << i;
    }
    x = probe.x_W();
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, FrictionOnAPlane, testing::Values(0.0, 1e-3));

TEST(Friction, AnInclineHoldsForAMinuteBelowItsAngleAndNeverAboveUnderEncoderNoise)
{
  const double mu = 0.5, count = 50e-6, hundredth = 0.01 * std::numbers::pi / 180;
  for (const double off : { -hundredth, hundredth })
  {
    const double angle = std::atan(mu) + off;
    test::Random random(test::testSeed(83));
    const TriangleMesh plane = test::makePlane({ std::sin(angle), 0, std::cos(angle) }, 0.2, 8, random);
    test::Probe probe(test::sceneOf(plane), 0.0, { 0, 0, 0.01 });
    probe.plan().friction = { mu, mu };
    probe.to({ 0, 0, -0.005 }); // pulled straight down
    const Vec3 start = probe.x_W();
    const std::size_t ticks = test::testCount(60000);
    std::size_t slips = 0;
    for (std::size_t i = 0; i < ticks; ++i)
    {
      // One count along the pull: the cone limits the direction of the pull.
      const double noise = random.uniform() < 0.5 ? 0.0 : count;
      slips += probe.to({ 0, 0, -0.005 - noise }).friction == FrictionState::Slips;
    }
    if (off < 0)
    {
      EXPECT_EQ(slips, 0u);
      EXPECT_EQ(probe.x_W(), start); // not a bit of drift
    }
    else
    {
      EXPECT_GT(slips, 0u);
    }
  }
}

TEST(Friction, InACornerItActsAlongTheLineWithTheSumOfBothReactions)
{
  // Floor z >= 0 and wall x >= 0: pressed into both by a and b the reactions are a and b; free along y.
  TriangleMesh mesh = test::makeBox({ 0, -0.5, -0.1 }, { 0.5, 0.5, 0.0 });
  append(mesh, test::makeBox({ -0.1, -0.5, -0.1 }, { 0.0, 0.5, 0.5 }));
  const double a = 3e-3, b = 2e-3, mu_s = 0.4, mu_k = 0.25;
  test::Probe probe(test::sceneOf(mesh), 0.0, { 0.01, 0, 0.01 });
  probe.plan().friction = { mu_s, mu_k };
  probe.to({ -b, 0, -a });
  EXPECT_EQ(probe.to({ -b, 0, -a }).friction, FrictionState::Sticks); // arrived, at rest
  const double breakAway = mu_s * (a + b);
  EXPECT_EQ(probe.to({ -b, breakAway - 1e-6, -a }).friction, FrictionState::Sticks);
  EXPECT_EQ(probe.to({ -b, breakAway + 1e-6, -a }).friction, FrictionState::Slips);
  probe.to({ -b, 0.05, -a });
  EXPECT_NEAR(probe.force(K).y(), -mu_k * K * (a + b), 1e-9);
  EXPECT_NEAR(probe.force(K).z(), K * a, 1e-9);
  EXPECT_NEAR(probe.force(K).x(), K * b, 1e-9);
}

TEST(Friction, NeverCrossesASurfaceAndNeverHoldsTheHandInTheAir)
{
  test::Random random(test::testSeed(84));
  const TriangleMesh soup = test::makeSoup(60, 0.05, random);
  test::PathChecker checker(soup, 0.0);
  test::Probe probe(test::sceneOf(soup), 0.0, { 0, 0, 0.2 }, &checker);
  probe.plan().friction = { 0.6, 0.4 };
  Vec3 p(0, 0, 0.2);
  for (std::size_t i = 0; i < test::testCount(3000); ++i)
  {
    p += random.direction() * 2e-3;
    p = p.cwiseMax(-0.08).cwiseMin(0.08);
    const ContactResult result = probe.to(p);
    ASSERT_EQ(probe.finding(), "") << "tick " << i;
    if (result.contacts == 0 && !result.capped)
    {
      ASSERT_LE((probe.x_W() - p).norm(), 1e-15) << "tick " << i;
    }
  }
}

} // namespace
} // namespace palpate
