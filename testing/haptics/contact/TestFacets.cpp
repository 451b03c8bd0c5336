// SPDX-License-Identifier: GPL-3.0-or-later
// Row 17: effect of facets on the force on a sphere of radius 50 mm at 1 mm below the true sphere.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/support/Facets.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr double radius_mm = 50.0;
constexpr double depth_mm = 1.0;

/// A row of the table: triangles, largest error of the force's magnitude, largest jump of its direction.
struct FacetCase
{
  int levels;
  double magnitudePercent;
  double jumpDegrees;
};

class Facets : public ::testing::TestWithParam<FacetCase>
{
};

TEST_P(Facets, RubbingAGreatCircleShowsTheErrorOfTheTable)
{
  const TriangleMesh mesh = makeIcosphere(GetParam().levels, radius_mm);
  const Vec3 through = worstOf(mesh).faceNormal;
  const Vec3 along = through.unitOrthogonal();
  Probe probe(sceneOf(mesh), 0.0, 60.0 * through);
  double largest = 0.0;
  const std::size_t ticks = testCount(4000);
  for (std::size_t i = 0; i < ticks; ++i)
  {
    const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(ticks);
    const ContactResult result = probe.to((radius_mm - depth_mm) * (std::cos(a) * through + std::sin(a) * along));
    ASSERT_GT(result.contacts, 0) << "tick " << i;
    largest = std::max(largest, std::fabs(probe.force(1.0).norm() - depth_mm) / depth_mm);
  }
  // The force is 1 N/mm times depth on the true sphere, short by the sagitta of the face.
  EXPECT_NEAR(largest, (radius_mm - worstOf(mesh).faceRadius_u) / depth_mm, 1e-9);
  EXPECT_NEAR(100 * largest, GetParam().magnitudePercent, 0.02 * GetParam().magnitudePercent);
}

TEST_P(Facets, TheDirectionJumpsByTheAngleBetweenFaces)
{
  const TriangleMesh mesh = makeIcosphere(GetParam().levels, radius_mm);
  const WorstFacets worst = worstOf(mesh);
  const double step_mm = 1e-3;
  Probe probe(sceneOf(mesh), 0.0, 1.2 * worst.edgeMiddle);
  double jump_rad = 0.0;
  Vec3 before = Vec3::Zero();
  for (int i = -200; i <= 200; ++i) // the force turns before or behind the edge by depth times half the angle
  {
    const Vec3 direction = (worst.edgeMiddle + step_mm * i * worst.edgeAcross).normalized();
    probe.to((radius_mm - depth_mm) * direction);
    const Vec3 now = probe.force(1.0).normalized();
    jump_rad = i == -200 ? 0.0 : std::max(jump_rad, std::atan2(now.cross(before).norm(), now.dot(before)));
    before = now;
  }
  EXPECT_NEAR(jump_rad, worst.edgeAngle_rad, 1e-9);
  EXPECT_NEAR(jump_rad * 180 / std::numbers::pi, GetParam().jumpDegrees, 0.02 * GetParam().jumpDegrees);
}

INSTANTIATE_TEST_SUITE_P(Row17, Facets,
  ::testing::Values(FacetCase{ 2, 88.8, 11.4 }, FacetCase{ 3, 22.6, 5.75 }, FacetCase{ 4, 5.69, 2.88 },
    FacetCase{ 5, 1.42, 1.44 }, FacetCase{ 6, 0.36, 0.72 }),
  [](const auto& info) { return std::to_string(20 << (2 * info.param.levels)) + "Triangles"; });

} // namespace
} // namespace palpate::test
