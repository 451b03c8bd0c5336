// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/mechanism/solve/ConstraintProblem.h"
#include "haptics/mechanism/solve/EndlessWay.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Linear.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Solver
{
  std::unique_ptr<ConstraintProblem> problem = std::make_unique<ConstraintProblem>();
  std::unique_ptr<ConstraintScratch> room = std::make_unique<ConstraintScratch>();
  ConstraintForces forces;

  void begin(int rows, int ways)
  {
    this->problem->resize(rows, ways);
    this->problem->cones = 0;
    this->problem->compliance.setZero();
    this->problem->free.setZero();
    this->problem->along.setZero();
    this->problem->load.setZero();
    this->problem->lowest.setConstant(-unlimited);
    this->problem->highest.setConstant(unlimited);
    this->forces.force_N.setZero(rows);
  }
  void solve()
  {
    const AllocationGuard guard;
    solveConstraints(*this->problem, *this->room, this->forces);
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_FALSE(this->forces.capped);
  }
};

/// Rows of every kind and bodies that nothing elastic holds; the first rows hold these, so that there is one answer.
void makeRandom(Random& random, Solver& solver)
{
  const int ways = static_cast<int>(random.below(4));
  const int bounded = 1 + static_cast<int>(random.below(5));
  const int rows = ways + bounded;
  solver.begin(rows, ways);
  ConstraintProblem& p = *solver.problem;
  Eigen::MatrixXd spread(rows, rows + 2);
  for (Eigen::Index i = 0; i < spread.size(); ++i)
  {
    spread.data()[i] = random.uniform(-1.0, 1.0);
  }
  p.compliance = spread * spread.transpose() / rows;
  for (int i = 0; i < rows; ++i)
  {
    p.free[i] = random.uniform(-1.0, 1.0);
    for (int w = 0; w < ways; ++w)
    {
      p.along(i, w) = random.uniform(-1.0, 1.0);
    }
    if (i >= ways)
    {
      const bool pushes = random.below(2) == 0;
      const double dry = random.uniform(0.05, 0.6);
      p.lowest[i] = pushes ? 0.0 : -dry;
      p.highest[i] = pushes ? unlimited : dry;
    }
  }
  for (int w = 0; w < ways; ++w)
  {
    p.load[w] = random.uniform(-0.5, 0.5);
  }
}

/// Forces where all constraints hold, found among all combinations of rows that are active or at a bound.
std::optional<Eigen::VectorXd> forcesByTryingAll(const ConstraintProblem& p)
{
  const int n = p.count;
  int states = 1;
  for (int i = 0; i < n; ++i)
  {
    states *= 3;
  }
  for (int code = 0; code < states; ++code)
  {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n + p.ways, n + p.ways);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + p.ways);
    m.topRightCorner(n, p.ways) = p.along;
    m.bottomLeftCorner(p.ways, n) = Eigen::MatrixXd(p.along).transpose();
    right.tail(p.ways) = -Eigen::VectorXd(p.load);
    bool possible = true;
    for (int i = 0, rest = code; i < n; ++i, rest /= 3)
    {
      const double bound = rest % 3 == 1 ? p.lowest[i] : p.highest[i];
      if (rest % 3 == 0)
      {
        m.row(i).head(n) = p.compliance.row(i);
        right[i] = -p.free[i];
        continue;
      }
      possible = possible && std::isfinite(bound);
      m.row(i).setZero();
      m(i, i) = 1.0;
      right[i] = bound;
    }
    const std::optional<Eigen::VectorXd> solution = test::solvedUniquely(m, right);
    if (!possible || !solution)
    {
      continue;
    }
    const Eigen::VectorXd& x = *solution;
    const Eigen::VectorXd moved =
      Eigen::VectorXd(p.free) + Eigen::MatrixXd(p.compliance) * x.head(n) + Eigen::MatrixXd(p.along) * x.tail(p.ways);
    bool met = true;
    for (int i = 0; i < n; ++i)
    {
      met = met && x[i] >= p.lowest[i] - 1e-10 && x[i] <= p.highest[i] + 1e-10;
      met = met && (moved[i] >= -1e-10 || x[i] >= p.highest[i] - 1e-10);
      met = met && (moved[i] <= 1e-10 || x[i] <= p.lowest[i] + 1e-10);
    }
    if (met)
    {
      return x.head(n);
    }
  }
  return std::nullopt;
}

/// The largest number that is summed up in a row: no solver is better than its rounding.
double termsOf(const ConstraintProblem& p, const ConstraintForces& f)
{
  const Eigen::VectorXd forces = Eigen::VectorXd(f.force_N).cwiseAbs();
  const Eigen::VectorXd ways = Eigen::VectorXd(f.way_u).cwiseAbs();
  return (Eigen::MatrixXd(p.compliance).cwiseAbs() * forces + Eigen::MatrixXd(p.along).cwiseAbs() * ways).maxCoeff();
}

TEST(SolveConstraints, RowsOfEveryKindHaveTheForcesThatAreFoundByTryingAllStates)
{
  Random random(testSeed(2001));
  Solver solver;
  int balanced = 0;
  int atBound = 0;
  for (std::size_t trial = 0; trial < testCount(600); ++trial)
  {
    makeRandom(random, solver);
    const auto expected = forcesByTryingAll(*solver.problem);
    ASSERT_TRUE(expected) << trial;
    solver.solve();
    EXPECT_LE((Eigen::VectorXd(solver.forces.force_N) - *expected).cwiseAbs().maxCoeff(),
      1e-9 * (1.0 + expected->cwiseAbs().maxCoeff()))
      << trial;
    EXPECT_LE(solver.forces.residual_u, 1e-12 * (1.0 + termsOf(*solver.problem, solver.forces))) << trial;
    EXPECT_LE(solver.forces.unbalanced_N, 1e-12 * (1.0 + expected->cwiseAbs().maxCoeff())) << trial;
    balanced += solver.problem->ways > 0;
    for (int i = 0; i < solver.problem->count; ++i)
    {
      atBound += std::abs(solver.forces.force_N[i]) == solver.problem->highest[i];
    }
  }
  EXPECT_GT(balanced, static_cast<int>(testCount(600) / 2));
  EXPECT_GT(atBound, static_cast<int>(testCount(600) / 10));
}

TEST(SolveConstraints, ARowThatFollowsFromOthersChangesNothingForTheHand)
{
  Random random(testSeed(2002));
  for (std::size_t trial = 0; trial < testCount(100); ++trial)
  {
    // A point held by a spring of 1 N/u, in three directions; then also in two that follow from these.
    Eigen::Matrix<double, 5, 3> j;
    j.topRows<3>() = Mat3::Identity();
    j.row(3) = random.direction().transpose();
    j.row(4) = random.direction().transpose();
    const Vec3 off = random.inCube(1.0);
    Vec3 hand[2];
    for (const int rows : { 3, 5 })
    {
      Solver solver;
      solver.begin(rows, 0);
      solver.problem->compliance = j.topRows(rows) * j.topRows(rows).transpose();
      solver.problem->free = j.topRows(rows) * off;
      solver.solve();
      hand[rows == 5] = j.topRows(rows).transpose() * Eigen::VectorXd(solver.forces.force_N);
      EXPECT_LE(solver.forces.residual_u, 1e-14);
    }
    EXPECT_LE((hand[0] - hand[1]).norm(), 1e-14);
    EXPECT_LE((hand[0] + off).norm(), 1e-14);
  }
}

/// By how much forces on the last three rows miss the laws of Signorini and Coulomb.
double coneMissed(const ConstraintProblem& p, const ConstraintForces& f, int first, double friction)
{
  const Vec3 force = f.force_N.segment<3>(first);
  const Vec3 moved = f.moved_u.segment<3>(first);
  const double across = force.tail<2>().norm();
  double most = std::max({ -moved[0], -force[0], across - friction * force[0], std::abs(force[0] * moved[0]) });
  if (across < friction * force[0] * (1.0 - 1e-9))
  {
    most = std::max(most, moved.tail<2>().norm());
  }
  else if (force[0] > 0.0)
  {
    most = std::max(most, (force.tail<2>() * moved.tail<2>().norm() + moved.tail<2>() * across).norm() / across);
  }
  EXPECT_EQ(p.count, f.force_N.size());
  return most;
}

/// Rows without bounds and one with, up to two degrees of freedom and one or two cones with different friction.
void makeRubbing(Random& random, Solver& solver)
{
  const int ways = static_cast<int>(random.below(3));
  const int plain = ways + 1;
  const int cones = 1 + static_cast<int>(random.below(2));
  const int n = plain + 3 * cones;
  solver.begin(n, ways);
  ConstraintProblem& p = *solver.problem;
  Eigen::MatrixXd spread(n, n + 2);
  for (Eigen::Index i = 0; i < spread.size(); ++i)
  {
    spread.data()[i] = random.uniform(-1.0, 1.0);
  }
  p.compliance = spread * spread.transpose() / n + 0.3 * Eigen::MatrixXd::Identity(n, n);
  p.cones = cones;
  for (int i = 0; i < n; ++i)
  {
    p.free[i] = random.uniform(-1.0, 1.0);
    for (int w = 0; w < ways; ++w)
    {
      p.along(i, w) = random.uniform(-1.0, 1.0);
    }
  }
  p.highest[ways] = 0.2;
  p.lowest[ways] = -0.2;
  for (int c = 0; c < cones; ++c)
  {
    p.friction[static_cast<std::size_t>(c)] = random.uniform(0.1, 0.6);
  }
}

/// In ticks, each of which begins where the body came to in the one before, until its constraints are met. Returns how
/// many.
int goOn(Solver& solver)
{
  constexpr int most = 300;
  for (int tick = 1; tick <= most; ++tick)
  {
    solveConstraints(*solver.problem, *solver.room, solver.forces);
    if (!solver.forces.capped)
    {
      return tick;
    }
    solver.problem->free += solver.problem->along * solver.forces.way_u;
  }
  return most;
}

TEST(SolveConstraints, ConesBesideRowsAndFreeWaysMeetCoulombsLawEachWithItsOwnFriction)
{
  Random random(testSeed(2003));
  int sticks = 0;
  int slips = 0;
  for (std::size_t trial = 0; trial < testCount(200); ++trial)
  {
    Solver solver;
    makeRubbing(random, solver);
    (void)goOn(solver);
    const ConstraintProblem& p = *solver.problem;
    EXPECT_FALSE(solver.forces.capped) << trial;
    const double size = 1.0 + solver.forces.force_N.lpNorm<Eigen::Infinity>();
    EXPECT_LE(solver.forces.unbalanced_N, 1e-11 * size);
    for (int i = 0; i < p.bounded(); ++i)
    {
      const double force = solver.forces.force_N[i];
      const bool free = std::abs(force) < p.highest[i] * (1.0 - 1e-12);
      EXPECT_LE(free ? std::abs(solver.forces.moved_u[i]) : 0.0, 1e-11 * size) << trial;
    }
    for (int c = 0; c < p.cones; ++c)
    {
      const int first = p.bounded() + 3 * c;
      const double friction = p.friction[static_cast<std::size_t>(c)];
      EXPECT_LE(coneMissed(p, solver.forces, first, friction), 1e-11 * size) << trial;
      const double normal = solver.forces.force_N[first];
      const bool inside = solver.forces.force_N.segment<2>(first + 1).norm() < (1.0 - 1e-9) * friction * normal;
      sticks += normal > 0.0 && inside;
      slips += normal > 0.0 && !inside;
    }
  }
  EXPECT_GT(sticks, 0);
  EXPECT_GT(slips, 0);
}

/// A body of the size of its lever that springs hold softly and that stands on soft feet with friction.
void makeStanding(Random& random, Solver& solver, int feet)
{
  constexpr int ways = 6;
  solver.begin(ways + 3 * feet, ways);
  ConstraintProblem& p = *solver.problem;
  p.cones = feet;
  const double soft = std::pow(10.0, random.uniform(0.0, 2.0));
  for (int i = 0; i < ways; ++i)
  {
    p.along(i, i) = 1.0;
    p.compliance(i, i) = soft;
    p.free[i] = random.uniform(-1.0, 1.0);
    p.load[i] = random.uniform(-0.3, 0.3);
  }
  p.load[2] -= 1.0;
  for (int c = 0; c < feet; ++c)
  {
    const int first = ways + 3 * c;
    const Vec3 at = random.inCube(1.0);
    const Vec3 n = (Vec3::UnitZ() + random.inCube(0.5)).normalized();
    const Vec3 across = n.unitOrthogonal();
    p.friction[static_cast<std::size_t>(c)] = random.uniform(0.1, 0.9);
    p.compliance.diagonal().segment<3>(first).setConstant(std::pow(10.0, random.uniform(-1.5, 0.5)));
    p.free[first] = random.uniform(-0.2, 0.2);
    for (int k = 0; const Vec3& along : { n, across, Vec3(n.cross(across)) })
    {
      p.along.row(first + k++) << along.transpose(), at.cross(along).transpose();
    }
  }
}

/// Of forces and places: the scale of a comparison, with that of a few newtons.
double sizeOf(const ConstraintForces& f)
{
  return 1.0 + f.force_N.lpNorm<Eigen::Infinity>() + f.way_u.lpNorm<Eigen::Infinity>();
}

double unbalancedOf(const ConstraintProblem& p, const ConstraintForces& f)
{
  Eigen::VectorXd sum = p.load;
  sum += Eigen::MatrixXd(p.along).transpose() * Eigen::VectorXd(f.force_N);
  return sum.cwiseAbs().maxCoeff();
}

TEST(SolveConstraints, ABodyThatOnlyBalanceHoldsRubsOnItsFeetByCoulombsLaw)
{
  Random random(testSeed(2004));
  int sticks = 0;
  int slips = 0;
  int opens = 0;
  std::size_t atOnce = 0;
  for (std::size_t trial = 0; trial < testCount(300); ++trial)
  {
    const int feet = 1 + static_cast<int>(random.below(5));
    Solver solver;
    makeStanding(random, solver, feet);
    atOnce += goOn(solver) == 1;
    const ConstraintProblem& p = *solver.problem;
    const double size = sizeOf(solver.forces);
    EXPECT_FALSE(solver.forces.capped) << trial;
    EXPECT_LE(unbalancedOf(p, solver.forces), 1e-12 * size) << trial;
    for (int c = 0; c < feet; ++c)
    {
      const int first = 6 + 3 * c;
      const double friction = p.friction[static_cast<std::size_t>(c)];
      EXPECT_LE(coneMissed(p, solver.forces, first, friction), 1e-12 * size) << trial;
      const double normal = solver.forces.force_N[first];
      const bool inside = solver.forces.force_N.segment<2>(first + 1).norm() < (1.0 - 1e-9) * friction * normal;
      sticks += normal > 0.0 && inside;
      slips += normal > 0.0 && !inside;
      opens += normal == 0.0;
    }
  }
  EXPECT_GE(atOnce, testCount(300) - testCount(300) / 50) << "a body is dropped from anywhere";
  EXPECT_GT(sticks, 0);
  EXPECT_GT(slips, 0);
  EXPECT_GT(opens, 0);
}

/// Whether forces are within their bounds and cones.
bool areWithinBounds(const ConstraintProblem& p, const ConstraintForces& f)
{
  bool within = f.force_N.allFinite() && f.moved_u.allFinite() && f.way_u.allFinite();
  for (int i = 0; i < p.bounded(); ++i)
  {
    within = within && f.force_N[i] >= p.lowest[i] && f.force_N[i] <= p.highest[i];
  }
  for (int c = 0; c < p.cones; ++c)
  {
    const Vec3 force = f.force_N.segment<3>(p.bounded() + 3 * c);
    const double friction = p.friction[static_cast<std::size_t>(c)];
    within = within && force.tail<2>().norm() <= friction * force[0] * (1.0 + 1e-12);
  }
  return within;
}

TEST(SolveConstraints, WhatExceedsItsWorkSaysSoAndItsForcesAreWithinTheirBounds)
{
  Random random(testSeed(2005));
  constexpr std::uint32_t mostOfATurn = 3000; // a solve that has begun is ended
  std::size_t said = 0;
  for (std::size_t trial = 0; trial < testCount(300); ++trial)
  {
    Solver solver;
    const std::uint32_t kind = random.below(3);
    kind == 0 ? makeRandom(random, solver) : kind == 1 ? makeRubbing(random, solver) : makeStanding(random, solver, 5);
    const ConstraintProblem& p = *solver.problem;
    const ConstraintProblem::Numbers start = solver.forces.force_N;
    if (goOn(solver) > 1)
    {
      continue;
    }
    const ConstraintProblem::Numbers met_N = solver.forces.force_N;
    const std::uint32_t needed = solver.forces.work;
    for (const std::uint32_t budget : { 0u, 1u, needed / 4, needed / 2, needed - 1, needed })
    {
      solver.forces.force_N = start;
      solveConstraints(p, *solver.room, solver.forces, budget);
      EXPECT_LE(solver.forces.work, budget + mostOfATurn);
      EXPECT_TRUE(areWithinBounds(p, solver.forces)) << trial;
      const bool isMet = (solver.forces.force_N - met_N).lpNorm<Eigen::Infinity>() <= 1e-9 * sizeOf(solver.forces) &&
                         solver.forces.unbalanced_N <= 1e-11 * sizeOf(solver.forces);
      EXPECT_TRUE(solver.forces.capped || isMet) << trial << ", " << budget << " of " << needed;
      EXPECT_FALSE(solver.forces.capped && budget == needed) << trial;
      said += solver.forces.capped;
    }
  }
  EXPECT_GT(said, testCount(300));
}

/// No compliance and no constraint without friction: whether a body rests is told by balance alone. On three feet
/// around it in one plane, with the load in that plane, it does up to the angle of its friction.
TEST(SolveConstraints, ABodyThatItsFrictionHoldsIsNeverFoundToBeEndless)
{
  Random random(testSeed(2806));
  std::size_t proven = 0;
  for (std::size_t trial = 0; trial < testCount(300); ++trial)
  {
    constexpr int feet = 3, ways = 6;
    Solver solver;
    solver.begin(3 * feet, ways);
    ConstraintProblem& p = *solver.problem;
    p.cones = feet;
    const double friction = random.uniform(0.1, 1.0);
    const double slope = std::atan(friction) * random.uniform(0.5, 1.5);
    p.load << std::sin(slope), 0.0, -std::cos(slope), Vec3::Zero();
    for (int c = 0; c < feet; ++c)
    {
      p.friction[static_cast<std::size_t>(c)] = friction;
      const double angle = 2.0 * M_PI * c / feet;
      const Vec3 at(std::cos(angle), std::sin(angle), 0.0); // in the plane of the load: it cannot tip
      for (int k = 0; const Vec3& along : { Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()) })
      {
        p.along.row(3 * c + k++) << along.transpose(), at.cross(along).transpose();
      }
    }
    std::uint32_t work = 0;
    const bool slides = std::tan(slope) > friction;
    ConstraintProblem::Way slips = ConstraintProblem::Way::Zero(ways);
    slips[0] = 1.0;
    const bool found = isEndless(p, slips, work);
    EXPECT_FALSE(found && !slides) << trial << ": a proof of what is not so";
    proven += found;
  }
  EXPECT_GT(proven, testCount(300) / 10);
}

} // namespace
} // namespace palpate::test
