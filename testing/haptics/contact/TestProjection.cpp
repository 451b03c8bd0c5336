// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 11, 12 and 13: the nearest point under planes, against exact rational arithmetic.
#include "haptics/contact/planes/Projection.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/support/Corners.h"
#include "testing/support/QpOracle.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// The error of a dot product of numbers of size 1: four units in the last place.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

std::vector<PlaneRow> rowsOf(const Corner& corner)
{
  std::vector<PlaneRow> rows;
  for (const Vec3& n : corner.normals)
  {
    rows.push_back({ n, 0.0 });
  }
  return rows;
}

/// y - q must be the combination sum lambda_i n_i of at most three given rows, lambda >= 0.
void expectInNormalCone(
  const std::vector<PlaneRow>& rows, const Vec3& q, const ProjectionResult& result, double tolerance)
{
  ASSERT_LE(result.count, 3);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < result.count; ++k)
  {
    EXPECT_GE(result.lambda[k], 0.0);
    sum += result.lambda[k] * rows.at(static_cast<std::size_t>(result.active[k])).n;
  }
  EXPECT_LE((result.y - q - sum).norm(), tolerance);
}

TEST(Projection, NineCornersAreExact) // row 11
{
  for (const Corner& corner : corners())
  {
    SCOPED_TRACE(corner.name);
    const std::vector<PlaneRow> rows = rowsOf(corner);
    const ProjectionResult result = projectOntoPlanes(rows, corner.p_W, 0.0);
    ASSERT_TRUE(result.feasible);
    EXPECT_LE((result.y - corner.x_W).norm(), 1e-12);
    EXPECT_NEAR(1000 * (result.y - corner.p_W).norm(), corner.force_N, 1e-9);
    expectInNormalCone(rows, corner.p_W, result, 1e-15);
  }
}

TEST(Projection, AThousandOrdersOfTheRowsGiveTheSameBits) // row 11
{
  Random random(testSeed(41));
  for (const Corner& corner : corners())
  {
    SCOPED_TRACE(corner.name);
    std::vector<PlaneRow> rows = rowsOf(corner);
    const ProjectionResult first = projectOntoPlanes(rows, corner.p_W, 0.0);
    for (std::size_t i = 0; i < testCount(1000); ++i)
    {
      random.shuffle(rows);
      const ProjectionResult other = projectOntoPlanes(rows, corner.p_W, 0.0);
      ASSERT_EQ(other.y, first.y) << "shuffle " << i;
      ASSERT_EQ(other.count, first.count);
    }
  }
}

TEST(Projection, ATargetThatIsFreeIsReachedExactly)
{
  const std::vector<PlaneRow> rows = rowsOf(corners()[2]);
  const Vec3 q(0.1, 0.2, 0.3);
  const ProjectionResult result = projectOntoPlanes(rows, q, 0.0);
  EXPECT_EQ(result.y, q);
  EXPECT_EQ(result.count, 0);
  EXPECT_EQ(projectOntoPlanes({}, q, 0.0).y, q);
}

TEST(Projection, NearlyParallelPlanesKeepTheForce) // row 12
{
  for (int digits = 1; digits <= 12; ++digits)
  {
    const double angle = std::pow(10.0, -digits);
    SCOPED_TRACE("angle " + std::to_string(digits));
    const std::vector<PlaneRow> rows = { { { std::sin(angle / 2), 0, std::cos(angle / 2) }, 0.0 },
      { { -std::sin(angle / 2), 0, std::cos(angle / 2) }, 0.0 } };
    const ProjectionResult result = projectOntoPlanes(rows, { 0, 0, -1 }, 0.0);
    ASSERT_TRUE(result.feasible);
    // The planes meet in the line x = z = 0: y = 0, so the force is (0, 0, K).
    EXPECT_LE(result.y.norm(), 1e-9);
  }
}

TEST(Projection, NearlyParallelPlanesAgreeWithExactArithmeticForAnyTarget) // row 12
{
  Random random(testSeed(42));
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    const double angle = std::pow(10.0, random.uniform(-12, -1));
    const Vec3 n = random.direction(), across = n.cross(random.direction()).normalized();
    const std::vector<PlaneRow> rows = { { n, random.uniform(-1e-3, 1e-3) },
      { (n + angle * across).normalized(), random.uniform(-1e-3, 1e-3) * angle } };
    const Vec3 q = -random.uniform(0.1, 1.0) * n;
    const ExactProjection truth = projectExactly(rows, q);
    const ProjectionResult result = projectOntoPlanes(rows, q, rounding);
    ASSERT_TRUE(truth.feasible && result.feasible);
    // Two planes fix the corner across them only to rounding / angle; the force q -> y along n stays exact.
    const double worst = (truth.y - q).norm();
    for (const PlaneRow& row : rows)
    {
      EXPECT_GE(row.n.dot(result.y) - row.bound, -1e-9) << "case " << i << ", angle " << angle;
    }
    EXPECT_LE((result.y - q).norm(), worst * (1 + 1e-9)) << "case " << i << ", angle " << angle;
  }
}

TEST(Projection, TheWedgeHasTheMultipliersThatFightEachOther) // row 13
{
  const double s = 0.5, c = std::sqrt(3.0) / 2;
  const std::vector<PlaneRow> rows = { { { 0, 0, 1 }, 0.0 }, { { s, 0, -c }, 0.0 } };
  const ProjectionResult result = projectOntoPlanes(rows, { -4, 1, 1 }, 0.0);
  // x - p = (4, 0, -1) = l1 (0, 0, 1) + l2 (s, 0, -c): l2 = 4 / s = 8, l1 = 8 c - 1 = 5.928...
  ASSERT_EQ(result.count, 2);
  const bool floorFirst = result.active[0] == 0;
  EXPECT_NEAR(result.lambda[floorFirst ? 0 : 1], 8 * c - 1, 1e-12);
  EXPECT_NEAR(result.lambda[floorFirst ? 1 : 0], 8.0, 1e-12);
  EXPECT_NEAR((result.y - Vec3(-4, 1, 1)).norm(), std::sqrt(17.0), 1e-12);
}

TEST(Projection, WedgesDownToATenthOfADegreeAgreeWithExactArithmetic) // row 13
{
  Random random(testSeed(43));
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    const double a = random.uniform(0.1, 90.0) * std::numbers::pi / 180;
    const std::vector<PlaneRow> rows = { { { 0, 0, 1 }, 0.0 }, { { std::sin(a), 0, -std::cos(a) }, 0.0 } };
    const Vec3 q(-random.uniform(0.1, 1.0), random.uniform(-1, 1), random.uniform(-0.01, 0.01));
    const ProjectionResult result = projectOntoPlanes(rows, q, rounding);
    ASSERT_TRUE(result.feasible) << "case " << i << ", angle " << a;
    EXPECT_LE((result.y - projectExactly(rows, q).y).norm(), 1e-12) << "case " << i << ", angle " << a;
  }
}

TEST(Projection, RandomPlanesAgreeWithExactArithmetic) // row 11
{
  Random random(testSeed(44));
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    std::vector<PlaneRow> rows;
    const std::uint32_t count = 1 + random.below(8);
    for (std::uint32_t k = 0; k < count; ++k)
    {
      Vec3 n = random.direction();
      n.z() = std::fabs(n.z()) + 0.2; // all face up: there is a free point
      rows.push_back({ n.normalized(), random.uniform(-0.1, 0.1) });
    }
    rows.push_back(rows[random.below(count)]); // and one twice
    const Vec3 q = random.inCube(1.0) - Vec3(0, 0, 1);
    const ExactProjection truth = projectExactly(rows, q);
    const ProjectionResult result = projectOntoPlanes(rows, q, rounding);
    ASSERT_TRUE(truth.feasible);
    ASSERT_TRUE(result.feasible) << "case " << i;
    EXPECT_LE((result.y - truth.y).norm(), 1e-12) << "case " << i;
    expectInNormalCone(rows, q, result, 1e-12);
  }
}

TEST(Projection, PlanesThatLeaveNoRoomAreReportedInfeasible)
{
  const std::vector<PlaneRow> slab = { { { 0, 0, 1 }, 1.0 }, { { 0, 0, -1 }, 1.0 } };
  EXPECT_FALSE(projectOntoPlanes(slab, Vec3::Zero(), 1e-12).feasible);
  EXPECT_FALSE(projectExactly(slab, Vec3::Zero()).feasible);
  std::vector<PlaneRow> shut; // four faces of a tetrahedron seen from inside, each pushed beyond the opposite corner
  for (const Vec3& n : { Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1) })
  {
    shut.push_back({ n.normalized(), 0.5 });
  }
  EXPECT_FALSE(projectOntoPlanes(shut, Vec3(0.1, 0.2, 0.3), 1e-12).feasible);
  EXPECT_FALSE(projectExactly(shut, Vec3(0.1, 0.2, 0.3)).feasible);
}

TEST(Projection, TwentyFourPlanesAreWithinItsBounds)
{
  std::vector<PlaneRow> rows;
  for (int k = 0; k < 24; ++k)
  {
    const double a = 2 * std::numbers::pi * k / 24;
    rows.push_back({ Vec3(std::cos(a), std::sin(a), 1).normalized(), 0.0 });
  }
  EXPECT_LE(projectOntoPlanes(rows, { 0.01, 0.02, -1 }, 0.0).y.norm(), 1e-12); // all meet in the origin
}

} // namespace
} // namespace palpate::test
