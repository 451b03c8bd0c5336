// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of many surfaces: one query structure above them, felt as if they were one mesh.
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// Spheres of mixed sizes, many of which overlap or hold others.
std::vector<TriangleMesh> crowd(std::size_t count, test::Random& random)
{
  std::vector<TriangleMesh> meshes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double radius = 0.004 * std::pow(10.0, random.uniform());
    meshes.push_back(test::shifted(test::makeIcosphere(2, radius), random.inCube(0.05)));
  }
  return meshes;
}

std::vector<SurfaceInput> inputsOf(const std::vector<TriangleMesh>& meshes)
{
  std::vector<SurfaceInput> inputs;
  for (const TriangleMesh& mesh : meshes)
  {
    inputs.push_back({ "part " + std::to_string(inputs.size()), std::make_shared<TriangleMesh>(mesh), {} });
  }
  return inputs;
}

TEST(ManySurfaces, AreFeltLikeOneMeshOfTheSameTriangles)
{
  test::Random random(test::testSeed(91));
  const std::vector<TriangleMesh> meshes = crowd(100, random);
  TriangleMesh whole;
  for (const TriangleMesh& mesh : meshes)
  {
    append(whole, mesh);
  }
  const auto many = SceneBuilder().build(inputsOf(meshes)).scene;
  ASSERT_EQ(many->surfaces().size(), 100u);
  for (const double radius : { 0.0, 5e-4 })
  {
    test::PathChecker checker(whole, radius, 1e-12);
    test::Probe apart(many, radius, { 0, 0, 0.2 }, &checker), together(test::sceneOf(whole), radius, { 0, 0, 0.2 });
    Vec3 p(0, 0, 0.2);
    for (std::size_t i = 0; i < test::testCount(3000); ++i)
    {
      p = 0.98 * p + random.direction() * 2e-3;
      const ContactResult a = apart.to(p), b = together.to(p);
      ASSERT_EQ(apart.finding(), "") << "tick " << i;
      ASSERT_LE((a.proxy_W - b.proxy_W).norm(), 1e-9) << "tick " << i << ", radius " << radius;
    }
  }
}

TEST(ManySurfaces, AddingOneKeepsTheTreesOfTheOthers)
{
  test::Random random(test::testSeed(92));
  std::vector<SurfaceInput> inputs = inputsOf(crowd(20, random));
  SceneBuilder builder;
  const auto before = builder.build(inputs).scene;
  inputs.push_back({ "new", std::make_shared<TriangleMesh>(test::makeIcosphere(1, 0.01)), {} });
  const auto after = builder.build(inputs).scene;
  ASSERT_EQ(after->surfaces().size(), 21u);
  for (std::size_t i = 0; i < 20; ++i)
  {
    EXPECT_EQ(before->surfaces()[i].tree, after->surfaces()[i].tree) << i;
  }
}

TEST(BoxTree, EveryBoxLiesInTheBoxesAboveIt)
{
  test::Random random(test::testSeed(93));
  for (const std::size_t count : { 1u, 2u, 3u, 100u, 1000u })
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vec3 low = random.inCube(1.0);
      boxes.push_back({ low, low + 0.1 * (random.inCube(1.0) + Vec3::Ones()) });
    }
    const BoxTree tree = makeBoxTree(boxes);
    ASSERT_EQ(tree.nodes.size(), count - 1);
    std::vector<int> seen(count, 0);
    struct Place
    {
      std::uint32_t child;
      Box around;
    };
    std::vector<Place> places{ { tree.root(), tree.bounds } };
    while (!places.empty())
    {
      const Place place = places.back();
      places.pop_back();
      if (place.child & TreeNode::leafBit)
      {
        const Box& box = boxes[place.child & ~TreeNode::leafBit];
        EXPECT_TRUE((box.low_W.array() >= place.around.low_W.array()).all());
        EXPECT_TRUE((box.high_W.array() <= place.around.high_W.array()).all());
        ++seen[place.child & ~TreeNode::leafBit];
        continue;
      }
      const TreeNode& node = tree.nodes[place.child];
      for (std::size_t k = 0; k < 2; ++k)
      {
        places.push_back({ node.child[k], { { node.low_W[0][k], node.low_W[1][k], node.low_W[2][k] },
                                            { node.high_W[0][k], node.high_W[1][k], node.high_W[2][k] } } });
      }
    }
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

} // namespace
} // namespace palpate
