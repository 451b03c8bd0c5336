// SPDX-License-Identifier: GPL-3.0-or-later
// Row 9: random shots up to 10 m/s at faces, edges and vertices of a sheet; the path is judged in exact arithmetic.
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Shots.h"

namespace palpate::test
{
namespace
{

class Shots : public ::testing::TestWithParam<std::tuple<bool, double>>
{
};

TEST_P(Shots, NoneCrossesTheSheet)
{
  const auto [bumpy, r] = GetParam();
  Random random(testSeed(61));
  const TriangleMesh mesh = makeTarget(bumpy, random);
  const auto scene = sceneOf(mesh);
  PathChecker checker(mesh, r, 1e-12); // row 11: positions are exact to 1e-12 m
  std::size_t held = 0;
  const std::size_t count = testCount(20000) / 4; // the four cases together make the count
  for (std::size_t i = 0; i < count; ++i)
  {
    const Shot way = makeShot(mesh, r + 1.1e-3, random); // the bumps are 1 mm high
    Probe probe(scene, r, way.from_W, &checker);
    held += probe.to(way.to_W).contacts > 0;
    probe.to(way.to_W + random.inCube(5e-3)); // and a second tick from where it was stopped
    ASSERT_EQ(probe.finding(), "") << "shot " << i;
  }
  EXPECT_GT(checker.judged(), count);
  EXPECT_GT(held, count / 2); // the shots do meet the sheet
}

INSTANTIATE_TEST_SUITE_P(Row9, Shots, ::testing::Combine(::testing::Bool(), ::testing::Values(0.0, 1e-3)));

TEST(Shots, AWayExactlyThroughAVertexOrAlongAnEdgeIsHeld)
{
  // A grid of whole numbers: the segments below meet vertices and run in the planes of edges without any rounding.
  Random random(testSeed(62));
  const TriangleMesh mesh = makeSheet({ 16, 16, 16, 16, 0.0 }, random);
  const auto scene = sceneOf(mesh);
  PathChecker checker(mesh, 0.0);
  for (int i = -6; i <= 6; ++i)
  {
    for (int j = -6; j <= 6; ++j)
    {
      for (const Vec3& to : { Vec3(i, j, -2), Vec3(i + 1, j, -2), Vec3(i + 1, j + 1, -2), Vec3(i, j + 0.5, -1) })
      {
        Probe probe(scene, 0.0, { double(i), double(j), 2.0 }, &checker);
        EXPECT_EQ(probe.to(to).contacts, 1);
        ASSERT_EQ(probe.finding(), "");
        EXPECT_LE((probe.x_W() - Vec3(to.x(), to.y(), 0)).norm(), 1e-13);
      }
    }
  }
}

TEST(Shots, APointInThePlaneOfASheetIsStoppedByItsRim)
{
  const TriangleMesh mesh = makeBox({ -1, -1, -0.1 }, { 1, 1, 0 });
  PathChecker checker(mesh, 0.0);
  Probe probe(sceneOf(mesh), 0.0, { 3, 0.25, 0 }, &checker); // exactly in the plane of the top
  probe.to({ -3, 0.25, -0.05 });
  EXPECT_EQ(probe.finding(), "");
  EXPECT_GT(probe.x_W().x(), 0.999);
}

} // namespace
} // namespace palpate::test
