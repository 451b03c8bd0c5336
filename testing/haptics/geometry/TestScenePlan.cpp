// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/ScenePlan.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

ScenePlan planOf(const TriangleMesh& mesh, const TouchConditions& conditions = {})
{
  return planTouch(SurfaceTree(cleanMesh(mesh).mesh), conditions);
}

/// How far the faces of an inscribed sphere dip under it: R less the distance of the lowest face from the centre.
double dipOf(const TriangleMesh& mesh, double radius)
{
  double nearest = radius;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3 &p = mesh.vertices_W[a], &q = mesh.vertices_W[b], &r = mesh.vertices_W[c];
    nearest = std::min(nearest, std::abs((q - p).cross(r - p).normalized().dot(p)));
  }
  return radius - nearest;
}

/// A pipe along z: `around` strips, each cut in `along` rectangles of two triangles.
TriangleMesh pipe(double radius, double length, std::uint32_t around, std::uint32_t along)
{
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= along; ++j)
  {
    for (std::uint32_t i = 0; i < around; ++i)
    {
      const double a = 2 * std::numbers::pi * i / around;
      mesh.vertices_W.emplace_back(radius * std::cos(a), radius * std::sin(a), length * j / along);
      const std::uint32_t next = (i + 1) % around;
      if (j < along)
      {
        mesh.triangles.push_back({ j * around + i, j * around + next, (j + 1) * around + next });
        mesh.triangles.push_back({ j * around + i, (j + 1) * around + next, (j + 1) * around + i });
      }
    }
  }
  return mesh;
}

TEST(ScenePlan, KnowsHowFarTheFacesOfASphereDipUnderIt) // row 17: 5.83 R / N
{
  constexpr double radius = 50.0;
  for (int levels = 2; levels <= 6; ++levels)
  {
    const TriangleMesh mesh = makeIcosphere(levels, radius);
    const double dip = dipOf(mesh, radius);
    EXPECT_NEAR(planOf(mesh).deviation_u, dip, 0.03 * dip) << levels;
    if (levels >= 4)
    {
      EXPECT_NEAR(planOf(mesh).deviation_u, 5.83 * radius / static_cast<double>(mesh.triangles.size()), 0.03 * dip)
        << levels;
    }
  }
}

TEST(ScenePlan, KnowsTheSagittaOfAPipeHoweverLongItsTrianglesAre)
{
  constexpr double radius = 10.0;
  constexpr std::uint32_t around = 64;
  const double sagitta = radius * (1 - std::cos(std::numbers::pi / around));
  for (const std::uint32_t along : { 2U, 10U, 200U })
  {
    EXPECT_NEAR(planOf(pipe(radius, 20.0, around, along)).deviation_u, sagitta, 0.01 * sagitta) << along;
  }
}

TEST(ScenePlan, FlatFacesAndSharpEdgesDeviateFromNothing)
{
  Random random(testSeed(71));
  const ScenePlan sheet = planOf(makePlane(Vec3::UnitZ(), 1.0, 20, random));
  EXPECT_EQ(sheet.deviation_u, 0.0);
  EXPECT_EQ(sheet.sharpEdges, 0U);
  EXPECT_FALSE(sheet.felt);
  const ScenePlan box = planOf(makeBox({ -1, -1, -1 }, { 1, 1, 1 }));
  EXPECT_EQ(box.deviation_u, 0.0);
  EXPECT_EQ(box.sharpEdges, 12U);
}

TEST(ScenePlan, SaysHowManyTrianglesWouldSuffice) // row 17: N >= 5.83 R / (0.07 p), 4200 for 50 mm and 1 mm
{
  TouchConditions conditions;
  conditions.scale_u_per_m = 1000.0;                                             // the scene is in millimetres
  for (const auto& [levels, felt] : { std::pair(3, true), std::pair(4, false) }) // 1280 and 5120 triangles
  {
    const ScenePlan plan = planOf(makeIcosphere(levels, 50.0), conditions);
    EXPECT_EQ(plan.felt, felt);
    EXPECT_NEAR(static_cast<double>(plan.trianglesNeeded), 5.83 * 50.0 / (0.07 * 1.0), 0.05 * 4164);
    EXPECT_DOUBLE_EQ(plan.deviation_m, plan.deviation_u / 1000);
    EXPECT_DOUBLE_EQ(plan.forceError, plan.deviation_m / 1e-3);
    EXPECT_NE(plan.sentence().find(felt ? "would feel smooth" : "below the perceptible force"), std::string::npos);
  }
}

TEST(ScenePlan, WhatTheDeviceDoesNotResolveIsNotFelt)
{
  TouchConditions conditions;
  conditions.scale_u_per_m = 1000.0;
  const TriangleMesh mesh = makeIcosphere(3, 50.0);
  conditions.resolution_m = 1.01 * planOf(mesh, conditions).deviation_m;
  EXPECT_FALSE(planOf(mesh, conditions).felt);
  EXPECT_LE(planOf(mesh, conditions).trianglesNeeded, mesh.triangles.size());
}

TEST(ScenePlan, DoesNotDependOnSizeOrOrder)
{
  Random random(testSeed(72));
  const TriangleMesh mesh = makeIcosphere(3, 50.0);
  const double deviation = planOf(mesh).deviation_u;
  EXPECT_NEAR(planOf(scaled(mesh, 1e-9)).deviation_u, 1e-9 * deviation, 1e-18 * deviation);
  EXPECT_EQ(planOf(shuffled(mesh, random)).deviation_u, deviation);
}

TEST(ScenePlan, RefusesConditionsThatMeanNothing)
{
  const TriangleMesh mesh = makeIcosphere(1, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { 0.0, -1.0, nan })
  {
    TouchConditions scale, penetration;
    scale.scale_u_per_m = bad;
    penetration.penetration_m = bad;
    EXPECT_THROW((void)planOf(mesh, scale), std::invalid_argument);
    EXPECT_THROW((void)planOf(mesh, penetration), std::invalid_argument);
  }
  TouchConditions stiffness;
  stiffness.stiffness_N_per_m = nan;
  EXPECT_THROW((void)planOf(mesh, stiffness), std::invalid_argument);
}

} // namespace
} // namespace palpate::test
