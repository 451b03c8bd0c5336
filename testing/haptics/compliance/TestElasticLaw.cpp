// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/compliance/material/ElasticLaw.h"
#include "haptics/compliance/material/PrincipalStretches.h"
#include "testing/support/Linear.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr std::array laws{ ElasticModel::Linear, ElasticModel::CoRotational, ElasticModel::NeoHookean };

Mat3 randomMatrix(Random& random, double size)
{
  Mat3 m;
  m << random.direction(), random.direction(), random.direction();
  return size * m;
}

/// dP/dF on the columns of F one below the other.
Eigen::Matrix<double, 9, 9> onColumns(const StressDerivative& d)
{
  Eigen::Matrix<double, 9, 9> all;
  for (int j = 0; j < 3; ++j)
  {
    for (int l = 0; l < 3; ++l)
    {
      all.block<3, 3>(3 * j, 3 * l) = d.between(d.v.row(j).transpose(), d.v.row(l).transpose());
    }
  }
  return all;
}

TEST(ElasticLaw, StressIsTheSlopeOfEnergyAndItsDerivativeTheSlopeOfStress)
{
  Random random(testSeed(182));
  const ElasticModuli moduli = moduliOf(1.0, 0.4, 1.0).value;
  constexpr double h = 1e-5;
  for (int trial = 0; trial < static_cast<int>(testCount(30)); ++trial)
  {
    const Mat3 f = 1.05 * Mat3::Identity() + randomMatrix(random, 0.02); // drawn out a little: nothing is cut off
    for (const ElasticModel law : laws)
    {
      const Mat3 stress = stressOf(law, moduli, f);
      const Eigen::Matrix<double, 9, 9> derivative = onColumns(stressDerivative(law, moduli, f));
      for (int i = 0; i < 9; ++i)
      {
        Mat3 step = Mat3::Zero();
        step.reshaped()[i] = h;
        const double slope = (energyDensity(law, moduli, f + step) - energyDensity(law, moduli, f - step)) / (2 * h);
        EXPECT_NEAR(stress.reshaped()[i], slope, 1e-8);
        const Mat3 change = (stressOf(law, moduli, f + step) - stressOf(law, moduli, f - step)) / (2 * h);
        EXPECT_LE((derivative.col(i) - change.reshaped()).norm(), 1e-8);
      }
    }
  }
}

TEST(ElasticLaw, NoDirectionIsSoftEnoughToGoUp)
{
  Random random(testSeed(183));
  const ElasticModuli moduli = moduliOf(1.0, 0.45, 1.0).value;
  for (int trial = 0; trial < static_cast<int>(testCount(100)); ++trial)
  {
    const Mat3 f = randomMatrix(random, 1.0); // squeezed, mirrored, anything
    for (const ElasticModel law : laws)
    {
      const Eigen::VectorXd slopes = test::eigenvaluesOf(onColumns(stressDerivative(law, moduli, f)));
      EXPECT_GE(slopes[0], -1e-12 * slopes[8]);
    }
  }
}

TEST(ElasticLaw, StretchesAndTurnsMakeUpAnyMatrix)
{
  Random random(testSeed(216));
  for (int trial = 0; trial < static_cast<int>(testCount(300)); ++trial)
  {
    Mat3 f = randomMatrix(random, random.uniform(1e-6, 1e3));
    const int rank = trial % 5;
    f.col(0) = rank == 1 ? Vec3(f.col(1) + f.col(2)) : Vec3(f.col(0)); // flat
    f = rank == 2 ? Mat3(f.col(0) * f.col(1).transpose()) : f;         // a line
    f = rank == 3 ? Mat3(Mat3::Identity() * f.norm()) : f;             // nothing to choose a direction by
    f = trial == 4 ? Mat3(Mat3::Zero()) : f;
    const PrincipalStretches p = principalStretches(f);
    EXPECT_LE((p.u * p.s.asDiagonal() * p.v.transpose() - f).norm(), 1e-14 * f.norm());
    for (const Mat3& turn : { p.u, p.v })
    {
      EXPECT_LE((turn * turn.transpose() - Mat3::Identity()).norm(), 1e-14);
      EXPECT_GT(turn.determinant(), 0.0);
    }
    EXPECT_GE(p.s[0], p.s[1]);
    EXPECT_GE(p.s[1], std::abs(p.s[2]) - 1e-14 * p.s[0]);
  }
}

TEST(ElasticLaw, AtRestAllLawsAreHookes)
{
  const ElasticModuli moduli = moduliOf(1.0, 0.4, 1.0).value;
  const Eigen::Matrix<double, 9, 9> hooke = onColumns(stressDerivative(ElasticModel::Linear, moduli, Mat3::Identity()));
  for (const ElasticModel law : laws)
  {
    EXPECT_LE(stressOf(law, moduli, Mat3::Identity()).norm(), 1e-15);
    EXPECT_NEAR(energyDensity(law, moduli, Mat3::Identity()), 0.0, 1e-15);
    EXPECT_LE((onColumns(stressDerivative(law, moduli, Mat3::Identity())) - hooke).norm(), 1e-14);
  }
}

/// Stress along x of a bar that is `length` times as long, with free sides, by bisection for their stretch.
double pulled(ElasticModel law, const ElasticModuli& moduli, double length, double& side)
{
  double low = 0.2;
  double high = 3.0;
  Mat3 stress;
  for (int i = 0; i < 200; ++i)
  {
    side = 0.5 * (low + high);
    stress = stressOf(law, moduli, Vec3(length, side, side).asDiagonal());
    (stress(1, 1) > 0.0 ? high : low) = side;
  }
  return stress(0, 0);
}

TEST(ElasticLaw, ABarWithFreeSidesFollowsItsClosedForm)
{
  const double nu = 0.4;
  const ElasticModuli moduli = moduliOf(1.0, nu, 1.0).value;
  for (const double length : { 0.6, 0.9, 1.1, 1.5 })
  {
    double side = 0.0;
    for (const ElasticModel law : { ElasticModel::Linear, ElasticModel::CoRotational })
    {
      EXPECT_NEAR(pulled(law, moduli, length, side), length - 1.0, 1e-12);
      EXPECT_NEAR(side, 1.0 - nu * (length - 1.0), 1e-12);
    }
    // Of psi = mu/2 (I - 3) + la/2 (J - al)^2 - mu/2 ln(I + 1): sides without stress give J - al in terms of s, and
    // that put into the stress along x leaves mu (1 - 1/(I + 1)) (l - s^2/l).
    const double along = pulled(ElasticModel::NeoHookean, moduli, length, side);
    const double mu = 4.0 / 3.0 * moduli.mu;
    const double lambda = moduli.lambda + 5.0 / 6.0 * moduli.mu;
    const double shear = mu * (1.0 - 1.0 / (length * length + 2.0 * side * side + 1.0));
    EXPECT_NEAR(along, shear * (length - side * side / length), 1e-12);
    EXPECT_NEAR(lambda * (length * side * side - 1.0 - 0.75 * mu / lambda) * length, -shear, 1e-12);
  }
}

TEST(ElasticLaw, WhatIsNoSolidIsRefusedInWords)
{
  for (const double young : { 0.0, -1.0, std::nan(""), 1e12, HUGE_VAL })
  {
    EXPECT_NE(moduliOf(young, 0.3, 1.0).problem.find("above 0 and below 1e12 Pa"), std::string::npos) << young;
  }
  for (const double nu : { 0.5, 0.7, -0.1, std::nan("") })
  {
    EXPECT_NE(moduliOf(1e4, nu, 1.0).problem.find("from 0 to below 0.5"), std::string::npos) << nu;
  }
  EXPECT_EQ(moduliOf(1e4, 0.49, 1e-3).problem, "");
  EXPECT_NEAR(moduliOf(1e6, 0.0, 1e-3).value.mu, 0.5, 1e-15); // a newton on a square millimetre is 1e6 Pa
}

} // namespace
} // namespace palpate::test
