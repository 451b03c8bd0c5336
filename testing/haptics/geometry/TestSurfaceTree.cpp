// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/SurfaceTree.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/TreeOf.h"

namespace palpate::test
{
namespace
{

TEST(SurfaceTree, RefusesAnEmptyMesh)
{
  EXPECT_THROW(SurfaceTree(TriangleMesh{}), std::invalid_argument);
}

TEST(SurfaceTree, HoldsEveryTriangleOfItsMeshOnce)
{
  const TriangleMesh clean = cleanMesh(makeIcosphere(3, 50.0)).mesh;
  const SurfaceTree tree{ TriangleMesh(clean) };
  EXPECT_EQ(cleanMesh(tree.mesh()).mesh.triangles, clean.triangles);
  EXPECT_EQ(cleanMesh(tree.mesh()).mesh.vertices_W, clean.vertices_W);
}

TEST(SurfaceTree, IsTheSameForAnyOrderOfTheInput)
{
  Random random(testSeed(31));
  const TriangleMesh mesh = makeIcosphere(3, 50.0);
  const SurfaceTree first = treeOf(mesh);
  for (std::size_t i = 0; i < testCount(10); ++i)
  {
    const SurfaceTree other = treeOf(shuffled(mesh, random));
    EXPECT_EQ(other.contentHash(), first.contentHash());
    EXPECT_EQ(other.mesh().triangles, first.mesh().triangles);
  }
}

TEST(SurfaceTree, ItsHashSeesOneUnitInTheLastPlaceAndOneTriangle)
{
  const TriangleMesh mesh = makeIcosphere(1, 50.0);
  TriangleMesh moved = mesh, smaller = mesh;
  moved.vertices_W[7].y() = std::nextafter(moved.vertices_W[7].y(), 1e9);
  smaller.triangles.pop_back();
  EXPECT_NE(treeOf(moved).contentHash(), treeOf(mesh).contentHash());
  EXPECT_NE(treeOf(smaller).contentHash(), treeOf(mesh).contentHash());
}

/// The one other triangle that has both vertices, or none where there is none or more than one.
std::uint32_t onlyOther(const SurfaceData& data, std::uint32_t triangle, std::uint32_t i, std::uint32_t j)
{
  std::uint32_t found = SurfaceData::none;
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    if (t != triangle && data.hasCorner(t, i) && data.hasCorner(t, j))
    {
      if (found != SurfaceData::none)
      {
        return SurfaceData::none;
      }
      found = t;
    }
  }
  return found;
}

TEST(SurfaceTree, KnowsTheOneOtherTriangleOverEachEdgeAndNoneWhereMoreMeet)
{
  Random random(testSeed(32));
  for (std::size_t i = 0; i < testCount(10); ++i)
  {
    // Sheets that share a border: up to five triangles meet at its edges.
    TriangleMesh mesh = makeIcosphere(2, 10.0);
    const auto hub = static_cast<std::uint32_t>(mesh.vertices_W.size());
    for (std::uint32_t k = 0; k < 30; ++k)
    {
      const auto& t = mesh.triangles[random.below(320)];
      mesh.vertices_W.push_back(20.0 * random.direction());
      mesh.triangles.push_back({ t[0], t[1], hub + k });
    }
    const SurfaceTree tree = treeOf(mesh);
    const SurfaceData& data = tree.data();
    int borders = 0;
    for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const std::uint32_t a = data.mesh.triangles[t][k], b = data.mesh.triangles[t][(k + 1) % 3];
        ASSERT_EQ(data.neighbour(t, a, b), onlyOther(data, t, a, b)) << "triangle " << t << ", edge " << k;
        ASSERT_EQ(data.neighbour(t, b, a), data.neighbour(t, a, b));
        borders += data.neighbour(t, a, b) == SurfaceData::none ? 1 : 0;
      }
    }
    EXPECT_GT(borders, 60);
  }
}

TEST(SurfaceTree, KeepsAtMost200BytesATriangleBesideTheMesh) // row 54
{
  const SurfaceTree tree = treeOf(NoisySphere(100000, 1.0).mesh());
  EXPECT_LE(static_cast<double>(tree.bytes()) / static_cast<double>(tree.mesh().triangles.size()), 200.0);
}

} // namespace
} // namespace palpate::test
