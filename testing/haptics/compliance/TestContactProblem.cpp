// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/compliance/servo/SubgridForce.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Linear.h"
#include "testing/support/RandomContacts.h"

namespace palpate::test
{
namespace
{

/// Contacts with normal compliance `w` [mm/N] alone, pressed in by `depth` [mm].
ContactForces gapsOf(const Eigen::MatrixXd& w, const Eigen::VectorXd& depth)
{
  const auto problem = std::make_unique<ContactProblem>();
  problem->resize(static_cast<int>(depth.size()));
  problem->compliance.setZero();
  problem->free.setZero();
  for (int i = 0; i < problem->count; ++i)
  {
    problem->free[3 * i] = -depth[i];
    for (int j = 0; j < problem->count; ++j)
    {
      problem->compliance(3 * i, 3 * j) = w(i, j);
    }
  }
  ContactForces forces;
  solveGaps(*problem, forces);
  return forces;
}

TEST(ContactProblem, TwoContactsThatShareComplianceGetLessThanEachAlone)
{
  const Eigen::MatrixXd w = (Eigen::MatrixXd(2, 2) << 1.0, 0.6, 0.6, 1.0).finished();
  const ContactForces forces = gapsOf(w, Eigen::Vector2d(1.0, 1.0));
  EXPECT_NEAR(forces.force_N[0], 1.0 / 1.6, 1e-15);
  EXPECT_NEAR(forces.force_N[3], 1.0 / 1.6, 1e-15);
}

TEST(ContactProblem, OfThreeInARowTheMiddleOneOpens)
{
  const Eigen::MatrixXd w = (Eigen::MatrixXd(3, 3) << 1.0, 0.9, 0.8, 0.9, 1.0, 0.9, 0.8, 0.9, 1.0).finished();
  const ContactForces forces = gapsOf(w, Vec3(1.0, 0.5, 1.0));
  EXPECT_NEAR(forces.force_N[0], 5.0 / 9.0, 1e-15);
  EXPECT_EQ(forces.force_N[3], 0.0);
  EXPECT_NEAR(forces.force_N[6], 5.0 / 9.0, 1e-15);
}

TEST(ContactProblem, ContactsThatAreNotIndependentAreHeldAllTheSame)
{
  const ContactForces forces = gapsOf(Eigen::MatrixXd::Ones(4, 4), Eigen::Vector4d(1.0, 1.0, 0.5, 1.0));
  EXPECT_NEAR(forces.force_N[0] + forces.force_N[3] + forces.force_N[6] + forces.force_N[9], 1.0, 1e-15);
  EXPECT_LE(forces.residual_u, 1e-15);
}

/// A ball on a spring of 1 N/mm among n rigid planes, which leave some place free: their normals are not independent.
struct PlanesAndDevice
{
  Eigen::MatrixXd normals;
  Eigen::VectorXd depth; ///< of the device behind each plane

  PlanesAndDevice(Random& random, int n) : normals(n, 3), depth(n)
  {
    const Vec3 free = 2.0 * Vec3::UnitZ();
    for (int i = 0; i < n; ++i)
    {
      this->normals.row(i) = (Vec3::UnitZ() + 0.95 * random.direction()).normalized().transpose();
      this->depth[i] = this->normals.row(i).dot(free) - random.uniform(0.0, 0.3);
    }
  }
};

/// The gaps where the constraints hold, found among all sets of up to three planes: more are not independent.
Eigen::VectorXd gapsByTryingAll(const PlanesAndDevice& p)
{
  const Eigen::MatrixXd w = p.normals * p.normals.transpose();
  const int n = static_cast<int>(p.depth.size());
  Eigen::VectorXd best = Eigen::VectorXd::Constant(n, -1.0);
  for (int set = 0; set < 1 << n; ++set)
  {
    std::vector<int> in;
    for (int i = 0; i < n; ++i)
    {
      if (set >> i & 1)
      {
        in.push_back(i);
      }
    }
    if (in.size() > 3)
    {
      continue;
    }
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
    if (!in.empty())
    {
      force(in) = test::solved(w(in, in), p.depth(in));
    }
    const Eigen::VectorXd gaps = w * force - p.depth;
    if (force.minCoeff() >= 0.0 && gaps.minCoeff() > best.minCoeff())
    {
      best = gaps;
    }
  }
  return best;
}

TEST(ContactProblem, AmongFourToSixRigidPlanesAllLawsHoldAsWhereEverySetIsTried)
{
  Random random(testSeed(193));
  int crowded = 0; // the device is behind more planes than can hold it
  for (std::size_t trial = 0; trial < testCount(1500); ++trial)
  {
    const PlanesAndDevice planes(random, 4 + static_cast<int>(trial % 3));
    const Eigen::MatrixXd w = planes.normals * planes.normals.transpose();
    const ContactForces found = gapsOf(w, planes.depth);
    Eigen::VectorXd force(planes.depth.size());
    for (Eigen::Index i = 0; i < force.size(); ++i)
    {
      force[i] = found.force_N[3 * i];
    }
    const Eigen::VectorXd gaps = w * force - planes.depth;
    const double size = 1.0 + w.cwiseAbs().sum() * force.maxCoeff();
    EXPECT_GE(force.minCoeff(), 0.0);
    EXPECT_GE(gaps.minCoeff(), -1e-13 * size) << trial;
    EXPECT_LE(force.cwiseProduct(gaps).cwiseAbs().maxCoeff(), 1e-12 * size * (1.0 + force.maxCoeff())) << trial;
    EXPECT_LE((gaps - gapsByTryingAll(planes)).cwiseAbs().maxCoeff(), 1e-9 * size) << trial;
    EXPECT_LE(found.residual_u, 1e-13 * size);
    crowded += (planes.depth.array() > 0.0).count() > 3;
  }
  EXPECT_GT(crowded, static_cast<int>(testCount(1500) / 2));
}

TEST(ContactProblem, APlaneThatContradictsTheOthersGetsNoForceAndTheyKeepTheirs)
{
  // Two walls that face each other 1 mm apart and overlap: nothing is outside of both.
  const Eigen::MatrixXd w = (Eigen::MatrixXd(2, 2) << 1.0, -1.0, -1.0, 1.0).finished();
  const ContactForces forces = gapsOf(w, Eigen::Vector2d(2.0, -1.0));
  EXPECT_EQ(forces.force_N[0], 2.0);
  EXPECT_EQ(forces.force_N[3], 0.0);
  EXPECT_NEAR(forces.residual_u, 1.0, 1e-15); // and it is said
}

TEST(ContactProblem, UpToTenContactsWithFrictionAreSolvedToRounding)
{
  Random random(testSeed(188));
  const auto problem = std::make_unique<ContactProblem>();
  const auto room = std::make_unique<FrictionScratch>();
  int sticking = 0;
  int slipping = 0;
  for (std::size_t trial = 0; trial < testCount(120); ++trial)
  {
    for (const int n : { 1, 2, 3, 5, 10 })
    {
      makeRandomContacts(random, n, *problem);
      ContactForces forces;
      forces.force_N.setZero(3 * n);
      const AllocationGuard guard;
      solveFriction(*problem, *room, forces);
      EXPECT_EQ(guard.allocations(), 0u);
      EXPECT_LE(missed(*problem, forces.force_N), 1e-12) << n << " contacts";
      for (int c = 0; c < n; ++c)
      {
        const double normal = forces.force_N[3 * c];
        const bool inside = forces.force_N.segment<2>(3 * c + 1).norm() < 0.4999 * normal;
        sticking += normal > 0.0 && inside;
        slipping += normal > 0.0 && !inside;
      }
    }
  }
  EXPECT_GT(sticking, 0);
  EXPECT_GT(slipping, 0);
}

TEST(ContactProblem, FortyContactsAreSweptCloseToTheirLaws)
{
  Random random(testSeed(189));
  const auto problem = std::make_unique<ContactProblem>();
  const auto room = std::make_unique<FrictionScratch>();
  for (int trial = 0; trial < 5; ++trial)
  {
    makeRandomContacts(random, ContactProblem::most, *problem);
    ContactForces forces;
    forces.force_N.setZero(3 * ContactProblem::most);
    solveFriction(*problem, *room, forces);
    EXPECT_LE(missed(*problem, forces.force_N), 1e-5);
  }
}

TEST(ContactProblem, GapsCloseUnderTangentialForcesThatStay)
{
  Random random(testSeed(191));
  const auto problem = std::make_unique<ContactProblem>();
  for (std::size_t trial = 0; trial < testCount(60); ++trial)
  {
    constexpr int n = 8;
    makeRandomContacts(random, n, *problem);
    ContactForces forces;
    forces.force_N.setZero(3 * n);
    for (int c = 0; c < n; ++c)
    {
      forces.force_N.segment<2>(3 * c + 1) = Eigen::Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    }
    const Eigen::VectorXd before = forces.force_N;
    closeGaps(*problem, forces);
    const Eigen::VectorXd f = forces.force_N;
    const Eigen::VectorXd moved = Eigen::VectorXd(problem->free) + Eigen::MatrixXd(problem->compliance) * f;
    for (int c = 0; c < n; ++c)
    {
      EXPECT_EQ(Eigen::Vector2d(f.segment<2>(3 * c + 1)), Eigen::Vector2d(before.segment<2>(3 * c + 1)));
      EXPECT_GE(f[3 * c], 0.0);
      EXPECT_GE(moved[3 * c], -1e-12);
      EXPECT_LE(f[3 * c] * moved[3 * c], 1e-12);
    }
  }
}

TEST(SubgridForce, ItsCubeRootIsThatOfTheLibrary)
{
  for (double x = 1e-12; x < 1e6; x *= 1.37)
  {
    EXPECT_NEAR(cubeRoot(x) / std::cbrt(x), 1.0, 1e-15);
  }
  EXPECT_EQ(cubeRoot(0.0), 0.0);
}

TEST(SubgridForce, ItsSlopeIsThatOfItsDepthAndIsNeverNegative)
{
  const SubgridSpring spring{ 2e-3, 1e-3 };
  for (double force = 1e-4; force < 20.0; force *= 1.5)
  {
    const double h = 1e-6 * force;
    const double slope = (subgridDepth(spring, force + h).depth_u - subgridDepth(spring, force - h).depth_u) / (2 * h);
    EXPECT_NEAR(subgridDepth(spring, force).slope, slope, 1e-7 * (1.0 + slope));
    EXPECT_GE(subgridDepth(spring, force).slope, 0.0);
  }
}

/// A spring with knots that rises, its first piece as of Hertz.
SubgridSpring springWithKnots(Random& random)
{
  SubgridSpring spring{ 2e-3, 1e-3 };
  spring.step = random.uniform(0.05, 0.2);
  for (std::size_t k = 1; k < SubgridSpring::knots; ++k)
  {
    const double grows = random.uniform(0.0, 1e-4);
    spring.depth_u[k] = spring.depth_u[k - 1] + grows;
    spring.rise[k] = random.uniform(0.0, 1.0) * grows / spring.step;
    spring.rise[k - 1] = k == 1 ? 0.0 : std::min(spring.rise[k - 1], 3.0 * grows / spring.step);
  }
  spring.rise[1] = std::min(spring.rise[1], 3.0 * spring.depth_u[1] / spring.step);
  return spring;
}

TEST(SubgridForce, WithKnotsDepthRisesWithoutAStepAndItsEnergyIsItsIntegral)
{
  Random random(testSeed(281));
  for (std::size_t i = 0; i < testCount(20); ++i)
  {
    const SubgridSpring spring = springWithKnots(random);
    const double end_N = std::pow(spring.step * (SubgridSpring::knots - 1), 3);
    double energy_Nu = 0.0;
    double before_u = 0.0;
    constexpr int steps = 4000;
    for (int k = 1; k <= steps; ++k)
    {
      const double force = 1.3 * end_N * k / steps;
      const double width = 1.3 * end_N / steps;
      const SubgridDepth at = subgridDepth(spring, force);
      EXPECT_GE(at.depth_u, before_u - 1e-18);
      EXPECT_GE(at.slope, 0.0);
      const double h = 1e-4 * width;
      const double slope =
        (subgridDepth(spring, force + h).depth_u - subgridDepth(spring, force - h).depth_u) / (2 * h);
      EXPECT_NEAR(at.slope, slope, 1e-5 * (at.slope + 1e-3));
      // Simpson's rule, beyond the first steps, in which depth goes as no polynomial of the force.
      const double middle_u = subgridDepth(spring, force - 0.5 * width).depth_u;
      const double part_Nu = width / 6.0 * (before_u + 4.0 * middle_u + at.depth_u);
      energy_Nu = k < 40 ? subgridEnergy(spring, force) : energy_Nu + part_Nu;
      before_u = at.depth_u;
    }
    EXPECT_NEAR(subgridEnergy(spring, 1.3 * end_N), energy_Nu, 1e-6 * energy_Nu);
    const double first_N = 1e-3 * end_N; // and there by its own derivative
    const double derivative =
      (subgridEnergy(spring, 1.001 * first_N) - subgridEnergy(spring, 0.999 * first_N)) / (0.002 * first_N);
    EXPECT_NEAR(derivative, subgridDepth(spring, first_N).depth_u, 1e-5 * derivative);
  }
}

} // namespace
} // namespace palpate::test
