// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/Smoothing.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

const GridIndex block_n{ 24, 20, 22 };

/// A standard normal number (Box and Muller).
double normal(test::Random& random)
{
  return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) * std::cos(2.0 * std::numbers::pi * random.uniform());
}

TEST(Smoothing, LeavesALinearFieldAsItIsAtTheRimAndBesideWhatIsMissing)
{
  const auto linear = [](const Vec3& i) { return 3 * i.x() - 2 * i.y() + i.z(); }; // whole numbers: exact in floats
  std::vector<float> values = test::sampledValues(block_n, linear);
  values[12 + 24 * (10 + 20 * 11)] = NAN;
  const std::vector<float> after = smoothed(values, block_n, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_TRUE(values[i] == after[i] || (std::isnan(values[i]) && std::isnan(after[i]))) << i;
  }
}

TEST(Smoothing, MultipliesAWaveByTheSquareOfTheCosineOfHalfItsAngleAnAxis)
{
  // (1, 2, 1) / 4 on cos(k i): (1 + cos k) / 2.
  const double k = 0.9;
  const auto wave = [&](const Vec3& i) { return std::cos(k * i.x()) * std::cos(k * i.z()); };
  const std::vector<float> after = smoothed(test::sampledValues(block_n, wave), block_n, 2);
  const double factor = std::pow((1.0 + std::cos(k)) / 2.0, 4.0); // two axes, two passes
  for (int x = 2; x < block_n[0] - 2; ++x)
  {
    EXPECT_NEAR(after[x + 24 * (10 + 20 * 11)], factor * wave(Vec3(x, 10, 11)), 1e-6);
  }
}

TEST(Smoothing, MeasuresWhiteNoiseBySixTenthsOfItsDeviation)
{
  // f - smoothed f has the variance 1 - 2 w0 + sum w^2 with w0 = 1/8 and sum w^2 = (6/16)^3; the median of its size is
  // 0.6745 deviations. The surface is where the slope is 1 a spacing.
  test::Random random(test::testSeed(1603));
  const GridIndex large{ 48, 48, 48 };
  for (const double sigma : { 0.05, 0.2 })
  {
    const std::vector<float> values =
      test::sampledValues(large, [&](const Vec3& i) { return i.z() + sigma * normal(random); });
    const double truth = 0.6745 * std::sqrt(1.0 - 2.0 / 8.0 + std::pow(6.0 / 16.0, 3)) * sigma;
    // Some 2,300 points: the median is known to 1.25 / sqrt(2300), 2.6 %, one deviation.
    EXPECT_NEAR(measuredNoise(values, large, 23.5), truth, 0.1 * truth);
  }
}

TEST(Smoothing, MeasuresNoNoiseInALinearFieldAndNoneWhereThereIsNoSurface)
{
  const std::vector<float> values = test::sampledValues(block_n, [](const Vec3& i) { return i.z(); });
  EXPECT_EQ(measuredNoise(values, block_n, 7.5), 0.0);
  EXPECT_EQ(measuredNoise(values, block_n, 1000.0), 0.0);
  EXPECT_EQ(measuredNoise(std::vector<float>(values.size(), 2.0F), block_n, 2.0), 0.0);
}

TEST(Smoothing, TakesWavesAndBendsForDataHoweverFineTheyAre)
{
  // Waves along one axis of 3 radians a point, as VTK's Wavelet has them, move the surface by more than noise may.
  const GridIndex large{ 40, 40, 40 };
  const Vec3 middle(19.3, 19.1, 19.7);
  for (const double angle : { 0.9, 2.0, 3.0 })
  {
    const auto waves = [&](const Vec3& i) { return i.z() + 1.5 * std::sin(angle * i.x()); };
    EXPECT_EQ(measuredNoise(test::sampledValues(large, waves), large, 19.5), 0.0) << angle;
  }
  for (const double radius : { 1.5, 3.0, 15.0 })
  {
    const auto distance = [&](const Vec3& i) { return (i - middle).norm(); };
    const auto square = [&](const Vec3& i) { return (i - middle).squaredNorm(); };
    const auto box = [&](const Vec3& i) { return (i - middle).cwiseAbs().maxCoeff(); };
    EXPECT_EQ(measuredNoise(test::sampledValues(large, distance), large, radius), 0.0) << radius;
    EXPECT_EQ(measuredNoise(test::sampledValues(large, square), large, radius * radius), 0.0) << radius;
    EXPECT_EQ(measuredNoise(test::sampledValues(large, box), large, radius), 0.0) << radius;
  }
}

TEST(Smoothing, FindsNoiseOverABentSurfaceOnceItIsMostOfWhatSmoothingTakesAway)
{
  // r^2 / (2 R) bends by 1 / R along each axis: smoothing adds (1/4) of that an axis, 0.75 / R in all, alike
  // everywhere. Noise of deviation s leaves 0.896 s. Its share n of the squares makes the likeness 1 - 1.112 n: below
  // 1/3 for n > 0.6, which is s > 1.025 / R.
  test::Random random(test::testSeed(1604));
  const GridIndex large{ 48, 48, 48 };
  const double radius = 10.0, limit = 0.75 / radius / 0.896 * std::sqrt(0.6 / 0.4);
  const auto measured = [&](double sigma)
  {
    const auto ball = [&](const Vec3& i)
    { return (i - Vec3(23.5, 23.5, 23.5)).squaredNorm() / (2.0 * radius) + sigma * normal(random); };
    return measuredNoise(test::sampledValues(large, ball), large, 0.5 * radius);
  };
  EXPECT_EQ(measured(0.7 * limit), 0.0);
  EXPECT_GT(measured(1.4 * limit), 0.0);
}

} // namespace
} // namespace palpate
