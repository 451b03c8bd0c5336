// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/build/TetraMesher.h"
#include "haptics/compliance/element/TetraShape.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using testing::HasSubstr;

double volumeOf(const TetraMeshResult& result, std::uint32_t label)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < result.mesh.tetras.size(); ++i)
  {
    sum += result.labels[i] == label ? tetraShape(result.mesh, result.mesh.tetras[i]).volume_u3 : 0.0;
  }
  return sum;
}

/// A ball of label 1 and radius 4 with a core of label 2 and radius 2 around (8, 8, 8), in unit boxes.
LabelImage twoBalls()
{
  LabelImage image;
  image.counts = { 17, 17, 17 };
  for (int i = 0; i < 17 * 17 * 17; ++i)
  {
    const double r = (Vec3(i % 17, i / 17 % 17, i / 289) - Vec3::Constant(8.0)).norm();
    image.labels.push_back(r < 2.0 ? 2 : r < 4.0 ? 1 : 0);
  }
  return image;
}

TEST(TetraMesher, ABallIsFilledWithSoundTetrahedraWithinItsBound)
{
  const SurfaceTree ball(cleanMesh(makeIcosphere(3, 1.0)).mesh);
  const TetraSizes sizes{ 0.35, 0.02 };
  double told = 0.0;
  const TetraMeshResult result = meshInside(ball, sizes,
    [&told](double share)
    {
      EXPECT_GE(share, told);
      EXPECT_LE(share, 1.0);
      told = share;
      return true;
    });
  ASSERT_EQ(result.refusal, "");
  EXPECT_GT(told, 0.0);
  EXPECT_LE(result.bound_u, 4.0 * sizes.distance_u);
  // Within the bound the volume is that of the ball.
  EXPECT_NEAR(volumeOf(result, 1), 4.0 / 3.0 * std::numbers::pi, 4.0 * std::numbers::pi * result.bound_u);
  const CheckedTetras checked =
    checkTetras(result.mesh, fixedWhere(result.mesh, [](const Vec3& p) { return p.z() < -0.3; }));
  EXPECT_EQ(checked.refusal, "");
  EXPECT_EQ(checked.report.turned + checked.report.doubled + checked.report.loose, 0u);
}

TEST(TetraMesher, LabelsAreFilledEachAndTheSameEachTime)
{
  const LabelImage image = twoBalls();
  const TetraMeshResult result = meshLabels(image, { 1.5, 0.3 });
  ASSERT_EQ(result.refusal, "");
  const auto boxes = [&image](std::uint32_t label)
  { return static_cast<double>(std::count(image.labels.begin(), image.labels.end(), label)); };
  // The border is within about .3 of that of the boxes, whose area is 1.5 of the ball's.
  EXPECT_NEAR(volumeOf(result, 2), boxes(2), 0.3 * 1.5 * 4.0 * std::numbers::pi * 4.0);
  EXPECT_NEAR(
    volumeOf(result, 1) + volumeOf(result, 2), boxes(1) + boxes(2), 0.3 * 1.5 * 4.0 * std::numbers::pi * 16.0);
  EXPECT_EQ(meshLabels(image, { 1.5, 0.3 }).mesh.tetras, result.mesh.tetras);
}

TEST(TetraMesher, WhatCannotBeFilledIsRefusedInWordsAndWorkEndsWhenTold)
{
  TriangleMesh open = makeIcosphere(2, 1.0);
  open.triangles.pop_back();
  EXPECT_THAT(meshInside(SurfaceTree(cleanMesh(open).mesh), { 0.3, 0.02 }).refusal, HasSubstr("has holes"));
  const SurfaceTree ball(cleanMesh(makeIcosphere(2, 1.0)).mesh);
  EXPECT_THAT(meshInside(ball, { 0.001, 0.02 }).refusal, HasSubstr("use a longer edge"));
  EXPECT_THAT(meshInside(ball, { 0.0, 0.02 }).refusal, HasSubstr("above 0"));
  EXPECT_THAT(meshInside(ball, { 0.3, 1e-12 }).refusal, HasSubstr("too short"));
  EXPECT_THAT(meshInside(ball, { 0.3, 1e-5, 3000 }).refusal, HasSubstr("use a larger distance"));
  EXPECT_EQ(meshInside(ball, { 0.3, 0.02 }, [](double) { return false; }).refusal, "cancelled");
  LabelImage nothing = twoBalls();
  nothing.labels.assign(nothing.labels.size(), 0);
  EXPECT_THAT(meshLabels(nothing, { 1.5, 0.3 }).refusal, HasSubstr("has no labels"));
  nothing.labels.pop_back();
  EXPECT_THAT(meshLabels(nothing, { 1.5, 0.3 }).refusal, HasSubstr("not one value per voxel"));
}

} // namespace
} // namespace palpate::test
