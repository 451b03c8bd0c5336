// SPDX-License-Identifier: GPL-3.0-or-later
// Plane worlds: which plane lines lie in, and the walls they become.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/geometry/mesh/PolyLines.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// A closed curve with a thousand points, placed.
TriangleMesh curveIn(const Pose& plane_WP, double size_u)
{
  PolyLines curve;
  curve.lines.emplace_back();
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    const double angle_rad = 0.0062 * i, r_u = size_u * (1 + 0.3 * std::sin(5 * angle_rad));
    curve.points_W.push_back(plane_WP.p + plane_WP.q * Vec3(r_u * std::cos(angle_rad), r_u * std::sin(angle_rad), 0));
    curve.lines.back().push_back(i);
  }
  return segmentsOf(curve);
}

/// How far points may be off a plane that were written as single numbers: four units of the last place of the largest.
double floatRounding_u(const TriangleMesh& segments)
{
  double largest_u = 0.0;
  for (const Vec3& p_W : segments.vertices_W)
  {
    largest_u = std::max(largest_u, p_W.cwiseAbs().maxCoeff());
  }
  return 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest_u;
}

TEST(CurveSet, LinesInThePlaneZ0GiveItExactly)
{
  const std::optional<Pose> plane_WP = planeOf(curveIn({}, 3.0));
  ASSERT_TRUE(plane_WP.has_value());
  EXPECT_EQ(plane_WP->p, Vec3(Vec3::Zero()));
  EXPECT_EQ(plane_WP->q.coeffs(), Quat::Identity().coeffs());
}

TEST(CurveSet, SlicesAcrossTheAxesHaveTheirXToTheRightAndTheirYUp)
{
  const Mat3 acrossX = (Mat3() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();  // x_P = y, y_P = z
  const Mat3 acrossY = (Mat3() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished(); // x_P = x, y_P = z
  const std::pair<Mat3, Vec3> slices[] = { { Mat3::Identity(), { 0, 0, 4 } }, { acrossX, { -2, 0, 0 } },
    { acrossY, { 0, 7, 0 } } };
  for (const auto& [axes, place_W] : slices)
  {
    const std::optional<Pose> plane_WP = planeOf(curveIn({ place_W, Quat(axes) }, 3.0));
    ASSERT_TRUE(plane_WP.has_value());
    EXPECT_LE((plane_WP->q.toRotationMatrix() - axes).norm(), 1e-15);
    EXPECT_LE((plane_WP->p - place_W).norm(), 1e-15);
  }
}

TEST(CurveSet, CurvesInAnyPlaneAreFoundInItAndTheWallsStandAcrossIt)
{
  test::Random random(test::testSeed(12));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const Pose placed_WP{ random.inCube(50.0), Quat(Eigen::AngleAxisd(random.uniform(0, 6), random.direction())) };
    const TriangleMesh segments = curveIn(placed_WP, 3.0);
    const std::optional<Pose> plane_WP = planeOf(segments);
    ASSERT_TRUE(plane_WP.has_value());
    ASSERT_NEAR(std::fabs((plane_WP->q * Vec3::UnitZ()).dot(placed_WP.q * Vec3::UnitZ())), 1.0, 1e-12);
    const PlaneCurves plane = curvesInPlane(segments, *plane_WP);
    ASSERT_EQ(plane.refusal, "");
    const TriangleMesh walls = raiseWalls(plane.curves, 0.5, *plane_WP);
    const double rounding_u = floatRounding_u(segments);
    for (std::size_t v = 0; v < segments.vertices_W.size(); ++v)
    {
      const Vec3 middle_W = 0.5 * (walls.vertices_W[2 * v] + walls.vertices_W[2 * v + 1]);
      ASSERT_LE((middle_W - segments.vertices_W[v]).norm(), rounding_u);
      ASSERT_NEAR((walls.vertices_W[2 * v + 1] - walls.vertices_W[2 * v]).norm(), 1.0, 1e-12);
    }
  }
}

TEST(CurveSet, LinesInSpaceLieInNoPlaneAndSlantedOnesOfNoneDoNot)
{
  TriangleMesh segments = curveIn({}, 3.0);
  segments.vertices_W[500].z() = 0.1;
  EXPECT_FALSE(planeOf(segments).has_value());
  EXPECT_NE(curvesInPlane(segments).refusal.find("point 500"), std::string::npos);
  EXPECT_FALSE(planeOf({ { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } }, { { 0, 1, 1 }, { 1, 2, 2 } } }).has_value());
  EXPECT_FALSE(planeOf({}).has_value());
}

TEST(CurveSet, MoreSegmentsThanCanBeFeltAreRefusedWithWhatToDo)
{
  TriangleMesh segments{ { { 0, 0, 0 }, { 1, 0, 0 } }, {} };
  segments.triangles.assign(mostSegments + 1, { 0, 1, 1 });
  EXPECT_NE(curvesInPlane(segments).refusal.find(std::to_string(mostSegments + 1) + " segments"), std::string::npos);
  EXPECT_NE(curvesInPlane(segments).refusal.find("Decimate Polyline"), std::string::npos); // it takes lines
  segments.triangles.pop_back();
  EXPECT_EQ(curvesInPlane(segments).refusal, "");
}

TEST(CurveSet, WhatSinglePrecisionRoundsIsInThePlaneAndWhatIsNotFiniteIsLeftToCleaning)
{
  TriangleMesh segments = curveIn({}, 3.0);
  for (Vec3& p : segments.vertices_W)
  {
    p = p.cast<float>().cast<double>();
    p.z() = 3e-7;
  }
  segments.vertices_W[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(curvesInPlane(segments).refusal, "");
  EXPECT_TRUE(planeOf(segments).has_value());
}

TEST(CurveSet, WallsAreHigherThanTheDiscAndElseNotMuchHigherThanSegmentsAreLong)
{
  const CurveSet curves{ { { 0, 0 }, { 3, 0 }, { 3, 1 } }, { { 0, 1 }, { 1, 2 } } }; // 2 on average
  const double low_u = wallHalfHeight(curves, 0.0), high_u = wallHalfHeight(curves, 10.0);
  EXPECT_GE(2 * low_u, 1.0);
  EXPECT_LE(low_u, 2.0);
  EXPECT_GT(high_u, 10.0);
  int exponent = 0;
  EXPECT_EQ(std::frexp(low_u, &exponent), 0.5) << "a power of two";
}

TEST(CurveSet, LoweredWallsAreTheLinesTheyWereRaisedFrom)
{
  test::Random random(test::testSeed(681));
  CurveSet curves;
  for (std::uint32_t i = 0; i < 100; ++i)
  {
    curves.points_W.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9));
    curves.segments.push_back({ i, random.below(100) });
  }
  const Pose slanted{ { 1, 2, 3 }, Quat(0.5, 0.5, -0.1, 0.7).normalized() };
  for (const Pose& plane_WP : { Pose(), slanted })
  {
    const double rounding_u = plane_WP.p.isZero(0.0) ? 0.0 : 1e-13;
    const CleanResult walls = cleanMesh(raiseWalls(curves, 0.25, plane_WP));
    const LoweredWalls lowered = lowerWalls(walls.mesh, plane_WP);
    EXPECT_NEAR(lowered.halfHeight_u, 0.25, rounding_u);
    std::size_t found = 0;
    for (const auto& [a, b] : lowered.curves.segments)
    {
      const auto is = [&](std::uint32_t i, std::uint32_t j)
      {
        return (curves.points_W[i] - lowered.curves.points_W[a]).norm() <= rounding_u &&
               (curves.points_W[j] - lowered.curves.points_W[b]).norm() <= rounding_u;
      };
      found += std::any_of(curves.segments.begin(), curves.segments.end(),
        [&](const auto& segment) { return is(segment[0], segment[1]) || is(segment[1], segment[0]); });
    }
    EXPECT_EQ(found, lowered.curves.segments.size());
    EXPECT_EQ(2 * found, walls.mesh.triangles.size());
  }
}

} // namespace
} // namespace palpate
