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

TEST(SurfaceTree, KeepsAtMost200BytesATriangleBesideTheMesh) // row 54
{
  const SurfaceTree tree = treeOf(NoisySphere(100000, 1.0).mesh());
  EXPECT_LE(static_cast<double>(tree.bytes()) / static_cast<double>(tree.mesh().triangles.size()), 200.0);
}

} // namespace
} // namespace palpate::test
