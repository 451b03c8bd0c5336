// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/MultiresolutionCurve.h"
#include "testing/support/Polylines.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

TEST(MultiresolutionCurve, TheBoundOfEveryLevelIsNeverBelowTheTrueDistance)
{
  test::Random random(test::testSeed(651));
  for (std::size_t i = 0; i < test::testCount(20); ++i)
  {
    const MultiresolutionCurve curve(test::wavyLine(random.next(), 2 + random.below(400), i % 2 == 0));
    for (int level = 0; level < curve.levels(); ++level)
    {
      const std::vector<Vec3> coarse_W = test::pick(curve.points_W(), curve.level(level));
      ASSERT_LE(test::hausdorffFromBelow(curve.points_W(), coarse_W), curve.bound_u(level) + 1e-14)
        << "case " << i << " level " << level;
    }
    ASSERT_EQ(curve.level(curve.levels() - 1).size(), curve.points_W().size());
    ASSERT_EQ(curve.bound_u(curve.levels() - 1), 0.0);
  }
}

// Of a run of an arc of the angle a the middle is farthest, by R (1 - cos(a / 2)).
TEST(MultiresolutionCurve, OnAnArcTheBoundIsTheSagitta)
{
  const int segments = 1024;
  const double arc = 2.0;
  std::vector<Vec3> arc_W;
  for (int i = 0; i <= segments; ++i)
  {
    arc_W.emplace_back(std::cos(arc * i / segments), std::sin(arc * i / segments), 0.0);
  }
  const MultiresolutionCurve curve(arc_W);
  ASSERT_EQ(curve.levels(), 11);
  for (int level = curve.levels() - 2; level >= 0; --level)
  {
    ASSERT_NEAR(curve.bound_u(level), 1.0 - std::cos(arc / (1 << level) / 2), 1e-12) << level;
  }
}

// Points off a line by up to a, at random: whatever segment stands for a run of them is within a of the line as well.
TEST(MultiresolutionCurve, OfNoiseTheBoundIsNoMoreThanTwiceItsSizeAtAnyLevel)
{
  test::Random random(test::testSeed(652));
  const double noise_u = 0.25;
  std::vector<Vec3> noisy_W;
  for (int i = 0; i <= 4096; ++i)
  {
    noisy_W.emplace_back(0.01 * i, random.uniform(-noise_u, noise_u), 0.0);
  }
  const MultiresolutionCurve curve(noisy_W);
  for (int level = 0; level < curve.levels(); ++level)
  {
    ASSERT_LE(curve.bound_u(level), 2 * noise_u) << level;
  }
}

TEST(MultiresolutionCurve, IsCoarseFarFromTheHandAndFineNearIt)
{
  const MultiresolutionCurve curve(test::wavyLine(7, 4097, false));
  const double limit_u = 1e-4, reach_u = 0.05, growth = 0.02;
  const Vec3 here_W = curve.points_W()[2000];
  const std::vector<std::uint32_t> chosen = curve.choose({ here_W, limit_u, reach_u, growth });
  const std::vector<Vec3> chosen_W = test::pick(curve.points_W(), chosen);
  for (const Vec3& p_W : curve.points_W())
  {
    const double away_u = (p_W - here_W).norm();
    const double allowed_u = away_u <= reach_u ? limit_u : limit_u + growth * (away_u - reach_u);
    ASSERT_LE(test::distanceToPolyline(p_W, chosen_W), allowed_u + 1e-14) << away_u;
  }
  const std::size_t everywhere = curve.choose({ here_W, limit_u, 1e9, 0.0 }).size();
  EXPECT_LT(chosen.size(), everywhere / 2);
  EXPECT_EQ(curve.choose({ { 1e6, 0, 0 }, limit_u, reach_u, growth }).size(), 2u); // far away it is one segment
}

// The hand goes along the curve and the choice is made anew at every step: within reach of both nothing moves by more
// than the limit, which times the stiffness is the force of a change of level.
TEST(MultiresolutionCurve, AChangeOfLevelMovesNothingThatCanBeTouchedByMoreThanTheLimit)
{
  const MultiresolutionCurve curve(test::wavyLine(8, 2049, false));
  const double limit_u = 2e-3, reach_u = 0.1, step_u = 0.03;
  std::vector<Vec3> before_W;
  int changes = 0;
  for (double x = -2.0; x < 2.0; x += step_u)
  {
    const Vec3 focus_W(x, 0.4 + 0.5 * std::sin(3 * x), 0);
    const std::vector<Vec3> now_W = test::pick(curve.points_W(), curve.choose({ focus_W, limit_u, reach_u, 0.1 }));
    changes += !before_W.empty() && now_W != before_W ? 1 : 0;
    for (std::size_t i = 1; !before_W.empty() && i < now_W.size(); ++i)
    {
      for (const double share : { 0.0, 0.25, 0.5, 0.75 })
      {
        const Vec3 p_W = now_W[i - 1] + share * (now_W[i] - now_W[i - 1]);
        if ((p_W - focus_W).norm() < reach_u - 3 * step_u)
        {
          ASSERT_LE(test::distanceToPolyline(p_W, before_W), limit_u + 1e-14) << x;
        }
      }
    }
    before_W = now_W;
  }
  EXPECT_GT(changes, 20);
}

TEST(MultiresolutionCurve, OfFewerThanTwoPointsIsNothing)
{
  EXPECT_EQ(MultiresolutionCurve().levels(), 0);
  EXPECT_EQ(MultiresolutionCurve({ Vec3::Zero() }).levels(), 0);
  EXPECT_TRUE(MultiresolutionCurve({ Vec3::Zero() }).choose({}).empty());
}

} // namespace
} // namespace palpate
