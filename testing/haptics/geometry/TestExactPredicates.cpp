// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/ExactPredicates.h"

#include <cmath>
#include <limits>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Rational::Point_3 exact(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

/// +1 where (b - a) x (c - a) points at d: CGAL's orientation is the sign of the same determinant.
int exactOrientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c), exact(d)));
}

/// A coordinate on a coarse grid, moved by a few units in the last place or not at all.
double nearGrid(Random& random)
{
  double value = 0.125 * random.below(9) + 1.0;
  for (std::uint32_t steps = random.below(3); steps > 0; --steps)
  {
    value = std::nextafter(value, random.below(2) == 0 ? 0.0 : 9.0);
  }
  return value;
}

Vec3 pointNearGrid(Random& random)
{
  const double x = nearGrid(random), y = nearGrid(random);
  return { x, y, nearGrid(random) };
}

TEST(ExactPredicates, TheSideOfAPlaneFollowsTheRightHand)
{
  EXPECT_EQ(orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
  EXPECT_EQ(orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, -1e-200 }), -1);
  EXPECT_EQ(orientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 7, -3, 0 }), 0);
}

TEST(ExactPredicates, TheSideIsThatOfRationalArithmeticCloseToThePlane)
{
  Random random(testSeed(21));
  int zeros = 0;
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const Vec3 a = pointNearGrid(random), b = pointNearGrid(random), c = pointNearGrid(random),
               d = pointNearGrid(random);
    const int truth = exactOrientation(a, b, c, d);
    ASSERT_EQ(orientation(a, b, c, d), truth) << "case " << i;
    zeros += truth == 0;
  }
  EXPECT_GT(zeros, 0); // the hard cases were among them
}

TEST(ExactPredicates, TheSideIsThatOfRationalArithmeticForCombinationsOfVeryDifferentSize)
{
  Random random(testSeed(22));
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(80)) - 40);
    const Vec3 a = random.inCube(size), b = a + random.inCube(1e-3), c = a + random.inCube(size);
    const Vec3 d = a + random.uniform() * (b - a) + random.uniform() * (c - a);
    ASSERT_EQ(orientation(a, b, c, d), exactOrientation(a, b, c, d)) << "case " << i;
  }
}

TEST(ExactPredicates, TheSideInThePlaneIsThatOfRationalArithmetic)
{
  using Plane = Rational::Point_2;
  Random random(testSeed(23));
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const Vec3 a = pointNearGrid(random), b = pointNearGrid(random), c = pointNearGrid(random);
    const int truth =
      static_cast<int>(CGAL::orientation(Plane(a.x(), a.y()), Plane(b.x(), b.y()), Plane(c.x(), c.y())));
    ASSERT_EQ(orientation2(a.x(), a.y(), b.x(), b.y(), c.x(), c.y()), truth) << "case " << i;
  }
}

TEST(ExactPredicates, TheNormalOfANeedleIsThatOfRationalArithmeticRoundedOnce)
{
  Random random(testSeed(25));
  for (std::size_t i = 0; i < testCount(5000); ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(80)) - 40);
    const Vec3 a = random.inCube(size), b = a + random.inCube(size);
    const Vec3 c = a + random.uniform() * (b - a) + std::pow(10.0, random.uniform(-20, 0)) * random.inCube(size);
    const auto truth = CGAL::cross_product(exact(b) - exact(a), exact(c) - exact(a));
    const Vec3 found = exactCross(a, b, c);
    for (int k = 0; k < 3; ++k)
    {
      const auto error = CGAL::abs(CGAL::Exact_rational(found[k]) - truth[k]);
      const CGAL::Exact_rational allowed(2 * std::numeric_limits<double>::epsilon());
      ASSERT_TRUE(error <= allowed * CGAL::abs(truth[k])) << "case " << i;
    }
  }
}

TEST(ExactPredicates, CollinearMeansExactlyOnOneLine)
{
  Random random(testSeed(24));
  for (std::size_t i = 0; i < testCount(5000); ++i)
  {
    const Vec3 a = pointNearGrid(random), step = (pointNearGrid(random) - a) * 0.25;
    const Vec3 b = a + step, c = a + 2 * step;
    ASSERT_EQ(exactlyCollinear(a, b, c), CGAL::collinear(exact(a), exact(b), exact(c))) << "case " << i;
  }
  EXPECT_TRUE(exactlyCollinear({ 1, 2, 3 }, { 1, 2, 3 }, { 4, 5, 6 }));
  EXPECT_FALSE(exactlyCollinear({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 1e-200 }));
}

} // namespace
} // namespace palpate::test
