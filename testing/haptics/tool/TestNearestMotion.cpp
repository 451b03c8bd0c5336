// SPDX-License-Identifier: GPL-3.0-or-later
// Row 28: the motion nearest to the wished one. The oracle tries every set of rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "haptics/tool/motion/Turn.h"
#include "haptics/tool/solve/NearestMotion.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

Vec6 vec6(const Vec3& a, const Vec3& b)
{
  Vec6 v;
  v << a, b;
  return v;
}

/// Row of a contact at r from the centre with normal n, for a lever.
MotionRow contactRow(const Vec3& r, const Vec3& n, double bound, double lever)
{
  const Vec6 j = vec6(n, r.cross(n) / lever);
  return { j / j.norm(), bound / j.norm() };
}

/// The nearest point of each subset's plane; the nearest one that respects all rows is the answer. Independent sets
/// alone, by a full-pivoting decomposition.
std::optional<Vec6> byEnumeration(const std::vector<MotionRow>& rows, const Vec6& wish)
{
  std::optional<Vec6> best;
  for (unsigned set = 0; set < 1u << rows.size(); ++set)
  {
    Eigen::MatrixXd j(0, 6);
    Eigen::VectorXd b(0);
    for (unsigned k = 0; k < rows.size(); ++k)
    {
      if (set >> k & 1)
      {
        j.conservativeResize(j.rows() + 1, 6);
        b.conservativeResize(b.size() + 1);
        j.row(j.rows() - 1) = rows[k].j.transpose();
        b[b.size() - 1] = rows[k].bound - rows[k].j.dot(wish);
      }
    }
    Vec6 y = wish;
    if (j.rows() > 0)
    {
      y += j.completeOrthogonalDecomposition().solve(b);
    }
    const bool holds =
      std::all_of(rows.begin(), rows.end(), [&](const MotionRow& row) { return row.j.dot(y) >= row.bound - 1e-12; });
    if (holds && (!best || (y - wish).squaredNorm() < (*best - wish).squaredNorm()))
    {
      best = y;
    }
  }
  return best;
}

std::vector<MotionRow> randomRows(Random& random, std::size_t count, bool parallel)
{
  std::vector<MotionRow> rows;
  const Vec3 shared = random.direction();
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vec3 n = parallel ? shared : random.direction();
    rows.push_back(contactRow(random.inCube(1.0), n, random.uniform(-0.2, 0.1), 0.6));
  }
  return rows;
}

/// Largest violation by a solution: broken rows, pull, and a part of y - wish that no row gives.
double residual(const std::vector<MotionRow>& rows, const Vec6& wish, const NearestMotion& found)
{
  double worst = 0.0;
  Vec6 rest = found.y - wish;
  for (const MotionRow& row : rows)
  {
    worst = std::max(worst, row.bound - row.j.dot(found.y));
  }
  for (int i = 0; i < found.count; ++i)
  {
    const MotionRow& row = rows[found.row[i]];
    rest -= found.pressure[i] * row.j;
    worst = std::max({ worst, -found.pressure[i], std::abs(row.j.dot(found.y) - row.bound) });
  }
  return std::max(worst, rest.norm());
}

/// A cube of 2 h on the plane z = 0, mass 0.1 kg: its four lower corners.
std::vector<MotionRow> cubeOnPlane(double h, double lever)
{
  std::vector<MotionRow> rows;
  for (const double x : { -h, h })
  {
    for (const double y : { -h, h })
    {
      rows.push_back(contactRow(Vec3(x, y, -h), Vec3::UnitZ(), 0.0, lever));
    }
  }
  return rows;
}

constexpr double cubeHalf_m = 0.02, cubeMass_kg = 0.1;
const double cubeLever_m = std::sqrt(2.0 / 3.0) * cubeHalf_m; // inertia m (2h)^2 / 6

struct GaussCase
{
  Vec6 wished, expected;
};

Vec6 gauss(const Vec6& acceleration)
{
  Vec6 white = acceleration;
  white.tail<3>() *= cubeLever_m;
  Vec6 y = nearestMotion(cubeOnPlane(cubeHalf_m, cubeLever_m), white).y;
  y.tail<3>() /= cubeLever_m;
  return y;
}

} // namespace

TEST(NearestMotion, OfACubeOnAPlaneIsWhatGaussPrincipleSaysRow28)
{
  // Two cases of free sliding and free yaw; in the third it tips: about the lower edge x = -h or x = h the least
  // constraint has a_z = h alpha, and minimises m (a_z + 1)^2 + I (alpha - 75.1)^2.
  const double inertia = cubeMass_kg * 4.0 * cubeHalf_m * cubeHalf_m / 6.0;
  const double alpha = (inertia * 75.1 - cubeMass_kg * cubeHalf_m) / (inertia + cubeMass_kg * cubeHalf_m * cubeHalf_m);
  ASSERT_NEAR(alpha, 0.04, 1e-12); // the table's
  const std::array<GaussCase, 3> cases = { {
    { vec6({ 0.3, 0, -1 }, Vec3::Zero()), vec6({ 0.3, 0, 0 }, Vec3::Zero()) },
    { vec6({ 0, 0, -1 }, { 20, 60, 7 }), vec6(Vec3::Zero(), { 0, 0, 7 }) },
    { vec6({ 0, 0, -1 }, { 0, 75.1, 0 }), vec6({ 0, 0, alpha * cubeHalf_m }, { 0, alpha, 0 }) },
  } };
  for (const GaussCase& g : cases)
  {
    const Vec6 y = gauss(g.wished);
    EXPECT_LE((y - g.expected).norm(), 1e-12 * 75.1) << y.transpose();
    const Vec3 force_N = cubeMass_kg * (y - g.wished).head<3>();
    EXPECT_NEAR(force_N.z(), cubeMass_kg * (1.0 + g.expected[2]), 1e-12);
  }
}

TEST(NearestMotion, IsWhatTryingEverySetOfRowsFindsRow28)
{
  Random random(testSeed(2801));
  const std::size_t count = testCount(300);
  std::size_t feasible = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::vector<MotionRow> rows = randomRows(random, 1 + random.below(8), random.below(4) == 0);
    const Vec6 wish = vec6(random.inCube(1.0), random.inCube(1.0));
    const std::optional<Vec6> expected = byEnumeration(rows, wish);
    const NearestMotion found = nearestMotion(rows, wish);
    ASSERT_EQ(found.feasible, expected.has_value()) << "case " << i;
    if (expected)
    {
      ++feasible;
      ASSERT_LE((found.y - *expected).norm(), 1e-10) << "case " << i;
      ASSERT_LE(residual(rows, wish, found), 1e-12) << "case " << i;
    }
  }
  EXPECT_GT(feasible, count / 2);
}

TEST(NearestMotion, HasNoResidualWithUpToAThousandRowsManyOfThemParallelOrEqual)
{
  Random random(testSeed(2802));
  for (std::size_t i = 0; i < testCount(400); ++i)
  {
    const std::array<std::size_t, 5> sizes = { 8, 30, 100, 300, 1000 };
    std::vector<MotionRow> rows = randomRows(random, sizes[i % sizes.size()], i % 2 == 0);
    for (MotionRow& row : rows)
    {
      row.bound = std::min(row.bound, 0.0); // as after a shortage of space: to stay is always allowed
    }
    rows.push_back(rows.front());
    const Vec6 wish = vec6(random.inCube(1.0), random.inCube(1.0));
    const NearestMotion found = nearestMotion(rows, wish);
    ASSERT_TRUE(found.feasible);
    ASSERT_LE(residual(rows, wish, found), 1e-12);
  }
}

TEST(NearestMotion, SaysThatTwoRowsContradictEachOther)
{
  const std::vector<MotionRow> rows = { { Vec6::Unit(2), 1.0 }, { -Vec6::Unit(2), 1.0 } };
  EXPECT_FALSE(nearestMotion(rows, Vec6::Zero()).feasible);
}

TEST(NearestMotion, NeitherAllocatesNorLocks)
{
  Random random(testSeed(2803));
  const std::vector<MotionRow> rows = randomRows(random, 64, false);
  const Vec6 wish = vec6(random.inCube(1.0), random.inCube(1.0));
  const AllocationGuard guard;
  const NearestMotion found = nearestMotion(rows, wish);
  EXPECT_EQ(guard.allocations() + guard.locks(), 0u);
  EXPECT_LE(found.count, 6);
}

TEST(Turn, GoesThereAndBackForEveryAngleUpToHalfATurn)
{
  Random random(testSeed(2804));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    const double angle = i % 3 == 0 ? random.uniform(0.0, 1e-7) : random.uniform(0.0, std::numbers::pi - 1e-6);
    const Vec3 axis = random.direction();
    const Quat q = turnBy(angle * axis);
    const Quat expected(Eigen::AngleAxisd(angle, axis));
    EXPECT_LE((q.coeffs() - expected.coeffs()).norm(), 1e-15);
    EXPECT_LE((rotationVector(q) - angle * axis).norm(), 4e-15);
    EXPECT_EQ(rotationVector(Quat(-q.coeffs())), rotationVector(q));
  }
}

} // namespace palpate::test
