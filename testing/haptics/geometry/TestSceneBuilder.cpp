// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/SceneBuilder.h"

#include <limits>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

SurfaceInput input(const std::string& name, const TriangleMesh& mesh)
{
  return { name, std::make_shared<TriangleMesh>(mesh), {} };
}

std::vector<SurfaceInput> severalSurfaces()
{
  std::vector<SurfaceInput> inputs;
  for (int i = 0; i < 9; ++i)
  {
    const TriangleMesh ball = makeIcosphere(1 + i % 3, 1.0 + i);
    inputs.push_back(input("ball " + std::to_string(i), shifted(ball, { 10.0 * i, 0, 0 })));
  }
  return inputs;
}

TEST(SceneBuilder, KeepsTheOrderAndTheNamesOfItsInputs)
{
  const std::vector<SurfaceInput> inputs = severalSurfaces();
  const SceneBuildResult built = SceneBuilder(3).build(inputs);
  ASSERT_TRUE(built.scene);
  ASSERT_EQ(built.scene->surfaces().size(), inputs.size());
  ASSERT_EQ(built.reports.size(), inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    EXPECT_EQ(built.scene->surfaces()[i].name, inputs[i].name);
    EXPECT_EQ(built.reports[i].name, inputs[i].name);
    EXPECT_EQ(built.reports[i].clean.trianglesOut, inputs[i].mesh->triangles.size());
  }
}

TEST(SceneBuilder, BuildsTheSameSceneWithAnyNumberOfWorkers) // row 55
{
  const auto one = SceneBuilder(1).build(severalSurfaces()).scene;
  for (const unsigned workers : { 2u, 4u })
  {
    const auto other = SceneBuilder(workers).build(severalSurfaces()).scene;
    EXPECT_EQ(other->contentHash(), one->contentHash()) << workers << " workers";
    for (std::size_t i = 0; i < one->surfaces().size(); ++i)
    {
      EXPECT_EQ(other->surfaces()[i].tree->mesh().triangles, one->surfaces()[i].tree->mesh().triangles);
    }
  }
}

TEST(SceneBuilder, LeavesARefusedSurfaceOutAndSaysWhy)
{
  const SceneBuildResult built =
    SceneBuilder().build({ input("empty", {}), input("box", makeBox(Vec3::Zero(), Vec3::Ones())) });
  ASSERT_TRUE(built.scene);
  EXPECT_EQ(built.scene->surfaces().size(), 1u);
  EXPECT_EQ(built.scene->surfaces()[0].name, "box");
  EXPECT_NE(built.reports[0].refusal, "");
  EXPECT_EQ(built.reports[1].refusal, "");
}

TEST(SceneBuilder, RefusesAPoseThatIsNotRigidUntilItIsOne)
{
  const SurfaceInput good = input("ball", makeIcosphere(1, 1.0));
  SceneBuilder builder;
  const Pose bad_WS[] = { { Vec3(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0), Quat::Identity() },
    { Vec3(std::numeric_limits<double>::infinity(), 0.0, 0.0), Quat::Identity() },
    { Vec3::Zero(), Quat(2.0, 0.0, 0.0, 0.0) }, { Vec3::Zero(), Quat(0.0, 0.0, 0.0, 0.0) },
    { Vec3::Zero(), Quat(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0) } };
  for (const Pose& pose_WS : bad_WS)
  {
    SurfaceInput moved = good;
    moved.name = "moved";
    moved.pose_WS = pose_WS;
    const SceneBuildResult built = builder.build({ good, moved });
    ASSERT_TRUE(built.scene);
    EXPECT_EQ(built.scene->surfaces().size(), 1u);
    EXPECT_EQ(built.reports[0].refusal, "");
    EXPECT_NE(built.reports[1].refusal.find("its pose is not rigid"), std::string::npos);
    moved.pose_WS = { Vec3(3.0, 0.0, 0.0), Quat::Identity() };
    EXPECT_EQ(builder.build({ good, moved }).scene->surfaces().size(), 2u);
  }
}

TEST(SceneBuilder, GivesNoSceneWhenNothingCanBeTouched)
{
  EXPECT_FALSE(SceneBuilder().build({ input("empty", {}) }).scene);
  EXPECT_FALSE(SceneBuilder().build({}).scene);
}

TEST(SceneBuilder, TheRevisionGrowsAndAnUnchangedMeshIsNotBuiltAgain)
{
  SceneBuilder builder;
  std::vector<SurfaceInput> inputs = severalSurfaces();
  const auto first = builder.build(inputs).scene;
  inputs[2] = input("changed", makeIcosphere(2, 7.0));
  const auto second = builder.build(inputs).scene;
  EXPECT_GT(second->revision(), first->revision());
  EXPECT_EQ(second->surfaces()[1].tree, first->surfaces()[1].tree);
  EXPECT_NE(second->surfaces()[2].tree, first->surfaces()[2].tree);
  EXPECT_NE(second->contentHash(), first->contentHash());
}

TEST(SceneBuilder, TheHashNamesTheContentAndNotTheRevision)
{
  SceneBuilder builder;
  const std::vector<SurfaceInput> inputs = severalSurfaces();
  const auto first = builder.build(inputs).scene;
  EXPECT_EQ(builder.build(inputs).scene->contentHash(), first->contentHash());
  std::vector<SurfaceInput> softer = inputs;
  softer[0].material.stiffness_N_per_m = 500.0;
  EXPECT_NE(builder.build(softer).scene->contentHash(), first->contentHash());
}

} // namespace
} // namespace palpate::test
