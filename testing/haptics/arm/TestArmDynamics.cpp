// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "haptics/arm/ArmDynamics.h"
#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/support/Arms.h"

namespace palpate
{
namespace
{

/// Work of a torque along a closed path of the joints, by the trapezium rule, which is exact to rounding for a periodic
/// integrand with 256 points [J].
template<class Torque>
double workAround(const JointVector& middle, const Torque& torque)
{
  constexpr int points = 256;
  double work = 0.0;
  for (int i = 0; i < points; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / points;
    JointVector q = middle, way = JointVector::Zero(middle.size());
    for (Eigen::Index k = 0; k < middle.size(); ++k)
    {
      const double phase = 2.0 * static_cast<double>(k); // so that the path encloses an area
      q[k] += 0.1 * std::cos(angle + phase);
      way[k] = -0.1 * std::sin(angle + phase) * 2.0 * std::numbers::pi / points;
    }
    work += torque(q).dot(way);
  }
  return work;
}

TEST(ArmDynamics, GravityTakesNoWorkOnAClosedWay)
{
  for (const ArmPlan& plan : test::allArms())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(881));
    std::size_t closed = 0;
    for (std::size_t i = 0; i < test::testCount(50); ++i)
    {
      const JointVector middle = test::randomJoints(arm, random);
      bool closes = true;
      const double work = workAround(middle,
        [&](const JointVector& q)
        {
          closes = closes && arm.posture(q).exists && conditionOf(arm, arm.posture(q)) < 5.0;
          return gravityTorqueOf(arm, q);
        });
      closed += closes ? 1 : 0;
      EXPECT_TRUE(!closes || std::fabs(work) <= 1e-12) << work;
    }
    EXPECT_GT(4 * closed, test::testCount(50)) << "too few ways close"; // of a chain of six joints half do
  }
}

TEST(ArmDynamics, GravityIsTheGradientOfHeightAndTheVendorsFormulaIsNot)
{
  const ArmPlan plan = knownArm("woodenhaptics-2015").value;
  const Arm arm(plan);
  const auto& lengths = std::get<WoodenGeometry>(plan.geometry);
  const double g = 9.81, mB = 0.17, cB = 0.051, mC = 0.11, cC = 0.091;
  test::Random random(test::testSeed(882));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const JointVector q = test::randomJoints(arm, random);
    const JointVector torque = gravityTorqueOf(arm, q);
    // The motors balance gravity: -g sin B (mB cB + mC Lb), +g mC cC sin C.
    EXPECT_NEAR(-torque[1], -g * std::sin(q[1]) * (mB * cB + mC * lengths.upper_m), 1e-15);
    EXPECT_NEAR(-torque[2], g * mC * cC * std::sin(q[2]), 1e-15);
    constexpr double h = 1e-5;
    for (int k = 0; k < 3; ++k)
    {
      JointVector high = q, low = q;
      high[k] += h;
      low[k] -= h;
      EXPECT_NEAR(torque[k], -(test::heightEnergyOf(arm, high) - test::heightEnergyOf(arm, low)) / (2 * h), 1e-9);
    }
  }
  JointVector middle(3);
  middle << 0.0, 0.3, 0.5; // their cross derivatives differ by g mC (cB + cC) cos C
  const double vendors = workAround(middle,
    [&](const JointVector& q)
    {
      JointVector torque = JointVector::Zero(3);
      torque[1] = g * (mB * cB * std::sin(q[1]) + mC * (cB + cC) * std::sin(q[2]));
      torque[2] = g * mC * cC * std::sin(q[2]);
      return torque;
    });
  EXPECT_GT(std::fabs(vendors), 1e-3) << "what is no gradient gives energy on a closed way";
}

TEST(ArmDynamics, InertiaIsThatOfTheKineticEnergyOfItsRodsAndRotors)
{
  for (const ArmPlan& plan : test::allArms())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(883));
    for (std::size_t i = 0; i < test::testCount(50); ++i)
    {
      const JointVector q = test::randomJoints(arm, random);
      JointVector rate(arm.joints());
      for (int k = 0; k < arm.joints(); ++k)
      {
        rate[k] = random.uniform(-1, 1);
      }
      // Rods cut into 2000 points; velocities by differences.
      constexpr double h = 1e-6;
      constexpr int pieces = 2000;
      double energy = 0.0;
      for (const ArmMass& mass : plan.masses)
      {
        const auto velocity = [&](const Vec3& at)
        {
          return Vec3(
            (arm.linkPoint(q + h * rate, mass.link, at).p - arm.linkPoint(q - h * rate, mass.link, at).p) / (2 * h));
        };
        const Vec3 begin = velocity(mass.from), end = velocity(mass.to);
        for (int piece = 0; piece < pieces; ++piece)
        {
          energy += 0.5 * mass.mass_kg / pieces * (begin + (piece + 0.5) / pieces * (end - begin)).squaredNorm();
        }
      }
      const JointVector motors = arm.ungears() * rate;
      for (int k = 0; k < arm.joints(); ++k)
      {
        energy += 0.5 * plan.joints[static_cast<std::size_t>(k)].rotor_kg_m2 * motors[k] * motors[k];
      }
      EXPECT_NEAR(0.5 * rate.dot(inertiaOf(arm, q) * rate), energy, 1e-6 * energy);
    }
  }
}

TEST(ArmMeasures, HaveTheForceOfTheirWorstDirectionAndTheManipulabilityOfTheirJacobian)
{
  for (const ArmPlan& original : test::allArms())
  {
    SCOPED_TRACE(original.name);
    ArmPlan plan = original;
    plan.maxForce_N = std::numeric_limits<double>::infinity();
    const Arm arm(plan);
    test::Random random(test::testSeed(884));
    for (std::size_t i = 0; i < test::testCount(20); ++i)
    {
      const JointVector q = test::randomJoints(arm, random);
      const ArmMeasures measures = measure(arm, q);
      double least = 1e300;
      for (int k = 0; k < 4000; ++k)
      {
        Vec3 n = random.direction();
        n.z() = arm.directions() == 2 ? 0.0 : n.z();
        least = std::min(least, largestForce(arm, arm.posture(q), plan.base_D.q * n.normalized()));
      }
      // The directions are random samples: the worst direction lies between them.
      EXPECT_LE(measures.leastForce_N, least * (1.0 + 1e-12));
      EXPECT_GE(measures.leastForce_N, 0.97 * least);
      if (arm.motors() == arm.directions())
      {
        // As much as a ball of speeds of the joints is stretched: the determinant (Yoshikawa 1985).
        const Mat3 turn = plan.base_D.q.toRotationMatrix().transpose();
        Mat3 moved = Mat3::Zero();
        moved.leftCols(arm.motors()) = turn * arm.jacobian(q).topLeftCorner(3, arm.motors());
        const double stretched =
          arm.directions() == 3 ? std::fabs(moved.determinant()) : std::fabs(moved.topLeftCorner<2, 2>().determinant());
        EXPECT_NEAR(measures.manipulability, stretched, 1e-12 + 1e-9 * stretched);
      }
      EXPECT_NEAR(measures.condition, conditionOf(arm, arm.posture(q)), 1e-6 * measures.condition);
    }
  }
}

} // namespace
} // namespace palpate
