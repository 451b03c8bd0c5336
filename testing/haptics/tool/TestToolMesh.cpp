// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptics/tool/mesh/ToolMesh.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

ToolMesh toolOf(const TriangleMesh& mesh)
{
  const Outcome<ToolMesh> result = makeTool(mesh);
  EXPECT_EQ(result.problem, "");
  return result.value;
}

TriangleMesh noisyBlob(Random& random)
{
  TriangleMesh mesh = makeIcosphere(3, 1.0);
  for (Vec3& v : mesh.vertices_W)
  {
    v *= random.uniform(0.9, 1.1);
  }
  return mesh;
}

/// How far a point lies outside of a box along its axes, which are unit to a float's rounding.
double outside(const OrientedBox& box, const Vec3& p)
{
  const Vec3 h = box.axes.inverse() * (p - box.centre);
  return (h.cwiseAbs() - box.half).maxCoeff();
}

} // namespace

TEST(ToolMesh, OfAClosedBoxHasTheCentreAndGyrationOfASolid)
{
  const Vec3 low(1.0, -2.0, 0.5), high(1.4, -1.0, 2.5), size = high - low;
  const ToolMesh tool = toolOf(makeBox(low, high));
  EXPECT_TRUE(tool.solid);
  EXPECT_LE((tool.centre_W - 0.5 * (low + high)).norm(), 1e-15 * 4);
  // Inertia about the axes of a box is m (b^2 + c^2) / 12 and so on; the mean of the three is m |size|^2 / 18.
  EXPECT_NEAR(tool.gyration_u, size.norm() / std::sqrt(18.0), 1e-14);
  EXPECT_NEAR(tool.reach_u, 0.5 * size.norm(), 1e-14);
}

TEST(ToolMesh, OfAFlatSquareOfAnOpenBoxAndOfOneTurnedInPartsIsASheet)
{
  Random random(testSeed(1701));
  const double side = 2.0;
  const ToolMesh flat = toolOf(makeSheet({ side, side, 4, 4, 0.3 }, random));
  EXPECT_FALSE(flat.solid);
  // A square plate: m s^2 / 12 twice, m s^2 / 6 once: mean m s^2 / 9.
  EXPECT_NEAR(flat.gyration_u, side / 3.0, 1e-14);
  TriangleMesh open = makeBox(Vec3::Constant(-1.0), Vec3::Constant(1.0));
  const ToolMesh closed = toolOf(open);
  std::swap(open.triangles[0][0], open.triangles[0][1]);
  EXPECT_FALSE(toolOf(open).solid);
  EXPECT_GT(toolOf(open).gyration_u, closed.gyration_u); // all of it is at the outside
  open.triangles.pop_back();
  EXPECT_FALSE(toolOf(open).solid);
}

TEST(ToolMesh, IsTheSameFarFromTheOrigin)
{
  const TriangleMesh box = makeBox(Vec3::Constant(-1.0), Vec3(1.0, 2.0, 3.0));
  const ToolMesh far = toolOf(shifted(box, Vec3::Constant(4096.0)));
  EXPECT_NEAR(far.gyration_u, toolOf(box).gyration_u, 1e-12);
}

TEST(ToolMesh, IsRefusedInWords)
{
  Random random(testSeed(1702));
  const auto refusal = [](const TriangleMesh& mesh) { return makeTool(mesh).problem; };
  TriangleMesh one;
  one.vertices_W = { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY() };
  one.triangles = { { 0, 1, 2 } };
  EXPECT_NE(refusal(one).find("one triangle"), std::string::npos);
  one.vertices_W[2] = 2.0 * Vec3::UnitX();
  EXPECT_NE(refusal(one), "");
  TriangleMesh box = makeBox(Vec3::Constant(-1.0), Vec3::Constant(1.0));
  TriangleMesh apart = box;
  append(apart, shifted(box, Vec3(1000.0, 0.0, 0.0)));
  EXPECT_NE(refusal(apart).find("far apart"), std::string::npos);
  TriangleMesh near = box;
  append(near, shifted(box, Vec3(10.0, 0.0, 0.0)));
  EXPECT_EQ(refusal(near), "");
  TriangleMesh huge = makeSheet({ 1.0, 1.0, 400, 400, 0.0 }, random);
  EXPECT_NE(refusal(huge).find("simplify"), std::string::npos);
  box.vertices_W[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(box).find("finite"), std::string::npos);
}

TEST(ToolMesh, StandsOnlyAtPosesThatAreOnes)
{
  const ToolMesh tool = toolOf(makeBox(Vec3::Constant(-1.0), Vec3::Constant(1.0)));
  EXPECT_EQ(refusePose(tool, {}), "");
  EXPECT_NE(refusePose(tool, { Vec3::Zero(), Quat(0.0, 0.0, 0.0, 0.0) }), "");
  EXPECT_NE(refusePose(tool, { Vec3::Zero(), Quat(1.0, 0.1, 0.0, 0.0) }), "");
  EXPECT_NE(refusePose(tool, { Vec3(0.0, std::nan(""), 0.0), Quat::Identity() }), "");
  EXPECT_NE(refusePose(tool, { Vec3(1e8, 0.0, 0.0), Quat::Identity() }), "");
  const auto scene = makeToolScene(cleanMesh(makeBox(Vec3::Constant(-1e8), Vec3::Constant(1e8))).mesh, tool);
  EXPECT_NE(refuseScene(tool, *scene), "");
}

TEST(BoxedMesh, EveryBoxHoldsAllTrianglesBelowIt)
{
  Random random(testSeed(1703));
  // The last one is so large that nodes are cut in halves before they are cut where they are thin.
  for (const TriangleMesh& mesh :
    { noisyBlob(random), shifted(noisyBlob(random), Vec3::Constant(1e4)), NoisySphere(9000, 1.0).mesh() })
  {
    const BoxedMesh boxed(cleanMesh(mesh).mesh, 1e-9);
    std::size_t held = 0;
    const auto walk = [&](auto self, std::uint32_t at) -> std::pair<std::uint32_t, std::uint32_t>
    {
      const BoxedMesh::Node& node = boxed.nodes()[at];
      std::pair<std::uint32_t, std::uint32_t> range(node.second, node.second + node.count);
      if (!node.leaf())
      {
        range = { self(self, at + 1).first, self(self, node.second).second };
      }
      held += node.leaf() ? node.count : 0;
      for (std::uint32_t t = range.first; t < range.second; ++t)
      {
        for (const Vec3& p : boxed.corners(t))
        {
          EXPECT_LE(outside(node.box.box(), p), 0.0);
        }
      }
      return range;
    };
    walk(walk, 0);
    EXPECT_EQ(held, boxed.mesh().triangles.size());
  }
}

TEST(BoxedMesh, OfATessellatedCubeHasEightCornersAndTwelveEdgesThatAreFelt)
{
  TriangleMesh cube;
  Random random(testSeed(1704));
  for (const Vec3& n : { Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1) })
  {
    TriangleMesh side = makeSheet({ 2.0, 2.0, 5, 5, 0.0 }, random);
    Mat3 turn;
    turn.col(2) = n;
    turn.col(0) = n.cwiseAbs().x() > 0.5 ? Vec3::UnitY() : Vec3::UnitX();
    turn.col(1) = n.cross(Vec3(turn.col(0)));
    for (Vec3& v : side.vertices_W)
    {
      v = (turn * v + n).unaryExpr([](double c) { return std::round(c * 5.0) / 5.0; });
    }
    append(cube, side);
  }
  const BoxedMesh boxed(cleanMesh(cube).mesh, 1e-9);
  ASSERT_EQ(boxed.mesh().triangles.size(), 6u * 50u);
  int edges = 0;
  for (std::uint32_t t = 0; t < boxed.mesh().triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges += boxed.flat(t).edge(k) ? 0 : 1;
      const bool isCorner = (boxed.corner(t, k).cwiseAbs() - Vec3::Ones()).norm() < 1e-12;
      EXPECT_EQ(boxed.flat(t).corner(k), !isCorner);
    }
  }
  EXPECT_EQ(edges, 2 * 12 * 5); // each from both of its faces
}

} // namespace palpate::test
