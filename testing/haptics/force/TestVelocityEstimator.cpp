// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/force/VelocityEstimator.h"
#include "testing/haptics/force/SamplingPeriod.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::T;

Vec3 quantised(const Vec3& p, double step)
{
  return step > 0.0 ? Vec3((p / step).array().floor() * step) : p;
}

TEST(VelocityEstimator, IsZeroForTheFirstSampleAndTheBackwardDifferenceForTheSecond)
{
  for (const VelocityMethod method : { VelocityMethod::BackwardDifference, VelocityMethod::AdaptiveWindow })
  {
    VelocityHistory history;
    const VelocityFilter filter{ method };
    EXPECT_EQ(estimateVelocity(filter, { 1, 2, 3 }, T, history), Vec3::Zero());
    const Vec3 v(0.1, -0.2, 0.05);
    EXPECT_LE((estimateVelocity(filter, Vec3(1, 2, 3) + v * T, T, history) - v).norm(), 1e-11);
  }
}

TEST(VelocityEstimator, AdaptiveWindowErrsByLessThanTwoEncoderStepsOverItsWindowAtConstantSpeed)
{
  test::Random random(test::testSeed(71));
  const double step = 50e-6;
  const VelocityFilter filter{ VelocityMethod::AdaptiveWindow, step };
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const Vec3 v = random.uniform(0.0, 0.5) * random.direction(), start = random.inCube(0.05);
    VelocityHistory history;
    Vec3 estimate = Vec3::Zero();
    for (int k = 0; k < 40; ++k)
    {
      estimate = estimateVelocity(filter, quantised(start + k * T * v, step), T, history);
    }
    // Both ends of the window are off by less than one step; a line that both explain is explained throughout.
    EXPECT_LT((estimate - v).cwiseAbs().maxCoeff(), 2 * step / (filter.window * T) + 1e-12) << "case " << i;
  }
}

TEST(VelocityEstimator, AWindowEndsWhereTheHandTurned)
{
  const double step = 50e-6, speed = 0.2;
  const VelocityFilter filter{ VelocityMethod::AdaptiveWindow, step };
  VelocityHistory history;
  Vec3 estimate = Vec3::Zero();
  const auto place = [&](double way) { estimate = estimateVelocity(filter, { way, 0, 0 }, T, history); };
  for (int k = 0; k <= 20; ++k)
  {
    place(k * T * speed);
  }
  for (int k = 1; k <= 3; ++k)
  {
    place((20 - k) * T * speed);
  }
  // A line over the turn misses it by 2 speed T, eight encoder steps: only the three ticks since count.
  EXPECT_NEAR(estimate.x(), -speed, 1e-12);
}

TEST(VelocityEstimator, LowPassFollowsAStepWithItsTimeConstant)
{
  VelocityFilter filter{ VelocityMethod::LowPass };
  filter.lowPass_s = 0.01;
  VelocityHistory history;
  const double v = 0.3;
  static_cast<void>(estimateVelocity(filter, Vec3::Zero(), T, history));
  Vec3 estimate;
  const int ticks = 25;
  for (int k = 1; k <= ticks; ++k)
  {
    estimate = estimateVelocity(filter, { k * T * v, 0, 0 }, T, history);
  }
  // v (1 - q^n) with the pole q = tau / (tau + T)
  EXPECT_NEAR(estimate.x(), v * (1.0 - std::pow(0.01 / 0.011, ticks)), 1e-12);
}

TEST(VelocityEstimator, MissedPeriodsCountWithTheirRealLength)
{
  VelocityHistory history;
  const VelocityFilter filter{ VelocityMethod::AdaptiveWindow, 1e-6 };
  const double v = 0.1;
  double t = 0.0;
  Vec3 estimate = Vec3::Zero();
  for (const double dt : { T, T, 5 * T, T, 2 * T, T })
  {
    t += dt;
    estimate = estimateVelocity(filter, { v * t, 0, 0 }, dt, history);
  }
  EXPECT_NEAR(estimate.x(), v, 1e-12);
}

} // namespace
} // namespace palpate
