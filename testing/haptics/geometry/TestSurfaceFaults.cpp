// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/geometry/measure/SurfaceFaults.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate::test::faults
{
namespace
{

void flip(TriangleMesh& mesh, std::uint32_t triangle)
{
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

TEST(SurfaceFaults, AGoodSurfaceHasNone)
{
  for (const TriangleMesh& mesh : { makeIcosphere(3, 1.0), unwelded(makeIcosphere(3, 1.0)) })
  {
    const SurfaceFaults faults = findFaults(mesh, 0.1);
    EXPECT_TRUE(faults.holes.empty() && faults.flipped.empty() && faults.thin.empty());
  }
}

TEST(SurfaceFaults, AHoleIsItsRim)
{
  TriangleMesh box = makeBox(Vec3(0, 0, 0), Vec3(2, 2, 2));
  const auto isTop = [&box](const auto& t)
  { return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return box.vertices_W[v].z() == 2.0; }); };
  std::erase_if(box.triangles, isTop);
  const SurfaceFaults faults = findFaults(box, 1.0);
  ASSERT_EQ(faults.holes.size(), 1u);
  EXPECT_DOUBLE_EQ(faults.holes[0].length_u, 8.0);
  EXPECT_NEAR((faults.holes[0].centre_W - Vec3(1, 1, 2)).norm(), 0.0, 1e-12);
  ASSERT_EQ(faults.holes[0].vertices.size(), 4u);
  for (const std::uint32_t v : faults.holes[0].vertices)
  {
    EXPECT_EQ(box.vertices_W[v].z(), 2.0);
  }
  EXPECT_TRUE(faults.thin.empty()) << "with a hole nothing is inside";
}

TEST(SurfaceFaults, FlippedTrianglesAreFoundByTheirNumbersWhateverTheOrder)
{
  Random random(testSeed(71));
  for (std::size_t round = 0; round < testCount(20); ++round)
  {
    TriangleMesh mesh = unwelded(makeIcosphere(2, 1.0));
    random.shuffle(mesh.triangles);
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
      if (random.below(10) < 3)
      {
        flip(mesh, t);
        chosen.push_back(t);
      }
    }
    std::vector<std::uint32_t> found;
    for (const FlippedPart& part : findFaults(mesh, 0.0).flipped)
    {
      found.insert(found.end(), part.triangles.begin(), part.triangles.end());
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, chosen);
  }
}

TEST(SurfaceFaults, AHollowIsTurnedInwardsAndABallBesideIsNot)
{
  TriangleMesh inner = makeIcosphere(2, 0.5);
  for (std::uint32_t t = 0; t < inner.triangles.size(); ++t)
  {
    flip(inner, t);
  }
  TriangleMesh shell = makeIcosphere(2, 1.0);
  append(shell, inner);
  EXPECT_TRUE(findFaults(shell, 0.0).flipped.empty());

  TriangleMesh beside = makeIcosphere(2, 1.0);
  append(beside, shifted(inner, Vec3(5, 0, 0)));
  const auto flipped = findFaults(beside, 0.0).flipped;
  ASSERT_EQ(flipped.size(), 1u);
  EXPECT_EQ(flipped[0].triangles.size(), inner.triangles.size());
  EXPECT_EQ(flipped[0].triangles.front(), makeIcosphere(2, 1.0).triangles.size());
}

TEST(SurfaceFaults, ThinWallsAreThoseOfThePlateAmongThem)
{
  TriangleMesh mesh = makeBox(Vec3(0, 0, 0), Vec3(3, 3, 3));
  const std::size_t first = mesh.triangles.size();
  append(mesh, makeBox(Vec3(10, 0, 0), Vec3(13, 3, 0.25)));
  const SurfaceFaults faults = findFaults(mesh, 0.3);
  ASSERT_EQ(faults.thin.size(), 4u); // two triangles above and two below
  for (const ThinPlace& place : faults.thin)
  {
    EXPECT_GE(place.triangle, first);
    EXPECT_DOUBLE_EQ(place.thickness_u, 0.25);
  }
}

TEST(SurfaceFaults, OfABrokenMeshAreThoseOfWhatCanBeUsed)
{
  TriangleMesh mesh = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  mesh.vertices_W.emplace_back(NAN, 0, 0);
  mesh.triangles.push_back({ 0, 1, 8 });
  mesh.triangles.push_back({ 0, 0, 1 });
  mesh.triangles.push_back({ 0, 1, 99 });
  const SurfaceFaults faults = findFaults(mesh, 0.1);
  EXPECT_TRUE(faults.holes.empty() && faults.flipped.empty() && faults.thin.empty());
  EXPECT_TRUE(findFaults(TriangleMesh(), 1.0).holes.empty());
}

} // namespace
} // namespace palpate::test::faults
