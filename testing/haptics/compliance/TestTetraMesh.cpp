// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/mesh/FilledTwice.h"
#include "haptics/compliance/mesh/ThinPlaces.h"
#include "testing/support/Says.h"

namespace palpate::test
{
namespace
{

using testing::HasSubstr;

CheckedTetras checkOnFloor(const TetraMesh& mesh)
{
  return checkTetras(mesh, fixedWhere(mesh, [](const Vec3& p) { return p.z() == 0.0; }));
}

TEST(TetraMesh, AGoodBlockStaysAsItIs)
{
  const TetraMesh mesh = blockOf({ 2, 2, 2 }, { 1, 1, 1 });
  const CheckedTetras checked = checkOnFloor(mesh);
  EXPECT_EQ(checked.refusal, "");
  EXPECT_EQ(checked.report.summary(), "");
  EXPECT_EQ(checked.mesh.tetras, mesh.tetras);
  EXPECT_EQ(borderOf(checked.mesh).size(), 6u * 4u * 2u);
}

TEST(TetraMesh, FlatDoubledAndLooseOnesAreLeftOutAndTheOtherOrderIsTurnedRound)
{
  TetraMesh mesh = blockOf({ 2, 2, 2 }, { 1, 1, 1 });
  const std::size_t good = mesh.tetras.size();
  std::swap(mesh.tetras[3][0], mesh.tetras[3][1]);
  mesh.tetras.push_back(mesh.tetras[5]);
  mesh.tetras.push_back({ 0, 1, 2, 3 }); // of one plane
  const auto next = static_cast<std::uint32_t>(mesh.vertices_W.size());
  for (const Vec3& p : { Vec3(5, 5, 5), Vec3(6, 5, 5), Vec3(5, 6, 5), Vec3(5, 5, 6), Vec3(9, 9, 9) })
  {
    mesh.vertices_W.push_back(p);
  }
  mesh.tetras.push_back({ next, next + 1, next + 2, next + 3 });
  const CheckedTetras checked = checkOnFloor(mesh);
  EXPECT_EQ(checked.refusal, "");
  EXPECT_EQ(checked.report.turned, 1u);
  EXPECT_EQ(checked.report.flat, 1u);
  EXPECT_EQ(checked.report.doubled, 1u);
  EXPECT_EQ(checked.report.loose, 1u);
  EXPECT_EQ(checked.mesh.tetras.size(), good);
  EXPECT_EQ(checked.mesh.vertices_W.size(), next);
  EXPECT_TRUE(test::says(checked.report.summary(), { "1", "connection", "removed" }));
}

TEST(TetraMesh, WhatCannotBeABodyIsRefusedInWords)
{
  const TetraMesh mesh = blockOf({ 2, 2, 2 }, { 1, 1, 1 });
  EXPECT_THAT(checkTetras({}, {}).refusal, HasSubstr("no tetrahedra"));
  EXPECT_TRUE(test::says(checkTetras(mesh, std::vector<bool>(27, false)).refusal, { "no fixed vertices" }));
  EXPECT_TRUE(
    test::says(checkTetras(mesh, fixedWhere(mesh, [](const Vec3& p) { return p.z() == 0.0 && p.y() == 0.0; })).refusal,
      { "three", "vertices", "collinear" }));
  TetraMesh inverted = mesh;
  inverted.vertices_W[13] = Vec3(0.5, 0.5, 1.7); // the middle one, out through the lid
  EXPECT_THAT(checkOnFloor(inverted).refusal, HasSubstr("inverted"));
  TetraMesh noPoint = mesh;
  noPoint.vertices_W[4].x() = std::nan("");
  EXPECT_THAT(checkOnFloor(noPoint).refusal, HasSubstr("not finite"));
  noPoint.tetras[0][2] = 99;
  EXPECT_THAT(checkOnFloor(noPoint).refusal, HasSubstr("not finite"));
  SoftBodyInput tooLarge = pad(8);
  tooLarge.mostBytes = 1 << 20;
  EXPECT_THAT(makeSoftBody(tooLarge).refusal, HasSubstr("mesh it coarser"));
  SoftBodyInput held = pad(2);
  held.fixed.assign(held.fixed.size(), true);
  EXPECT_TRUE(test::says(makeSoftBody(held).refusal, { "all vertices", "fixed" }));
  SoftBodyInput rigid = pad(2);
  rigid.young_Pa = { std::nan("") };
  EXPECT_THAT(makeSoftBody(rigid).refusal, HasSubstr("Young's modulus"));
}

TEST(ThinPlaces, AreThoseOneElementAwayFromTheOtherSideAndNotThoseAroundAnEdge)
{
  const auto placesOf = [](int through) { return thinPlacesOf(blockOf({ 6, 6, through }, Vec3(0.06, 0.06, 0.005))); };
  EXPECT_EQ(placesOf(1).all, 98u);  // 7 x 7 above and below
  EXPECT_GE(placesOf(1).thin, 50u); // but those of the rim, of which some have an element to the other side
  EXPECT_TRUE(test::says(placesOf(1).sentence(), { "98", "places", "element" }));
  EXPECT_EQ(placesOf(2).thin, 0u);
  EXPECT_EQ(placesOf(2).sentence(), "");
  EXPECT_EQ(thinPlacesOf(blockOf({ 4, 4, 4 }, Vec3(1, 1, 1))).thin, 0u);
}

TEST(FilledTwice, IsNothingOnALineThroughVerticesOrAlongEdgesOfABodyThatDoesNotMeetItself)
{
  TetraMesh mesh = blockOf({ 4, 4, 4 }, { 4, 4, 4 });
  for (const Vec3& through : { Vec3(2, 2, 2), Vec3(2, 2.5, 2.5), Vec3(2, 2, 2.5), Vec3(2.5, 2.5, 2), Vec3(1, 3, 4) })
  {
    for (const Vec3& along : { Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(0, 1, -1),
           Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(2, 1, 0), Vec3(1, 2, 3) })
    {
      const Vec3 unit = along.normalized();
      const LinePiece line{ through - 8.0 * unit, unit, 16.0 };
      EXPECT_LT(filledTwice(mesh, mesh.vertices_W, line), 1e-12)
        << through.transpose() << " along " << along.transpose();
    }
  }
  // A line up an edge of the lattice through the vertex (2, 2, 3), which is pushed below (2, 2, 2) by .5: cells between
  // the two are turned inside out.
  for (Vec3& p : mesh.vertices_W)
  {
    p = p == Vec3(2, 2, 3) ? Vec3(2, 2, 1.5) : p;
  }
  const LinePiece up{ Vec3(2, 2, -1), Vec3::UnitZ(), 8.0 };
  EXPECT_NEAR(filledTwice(mesh, mesh.vertices_W, up), 1.5, 0.01) << "from 1.5 to 2: once turned, and in three of them";
}

TEST(FilledTwice, IsTheWayThroughWhatTwoBlocksShareAndThroughWhatIsTurnedInsideOut)
{
  // Two blocks of one mesh, 2 long each, of which the second is moved into the first by a known length.
  TetraMesh mesh = blockOf({ 2, 2, 2 }, { 2, 2, 2 });
  const std::size_t first = mesh.vertices_W.size(), tetras = mesh.tetras.size();
  for (std::size_t v = 0; v < first; ++v)
  {
    mesh.vertices_W.push_back(mesh.vertices_W[v] + Vec3(0, 0, 10));
  }
  for (std::size_t t = 0; t < tetras; ++t)
  {
    Tetra other = mesh.tetras[t];
    std::ranges::for_each(other, [first](std::uint32_t& v) { v += static_cast<std::uint32_t>(first); });
    mesh.tetras.push_back(other);
  }
  const LinePiece up{ Vec3(0.73, 1.21, -1.0), Vec3::UnitZ(), 20.0 };
  EXPECT_NEAR(filledTwice(mesh, mesh.vertices_W, up), 0.0, 1e-14);
  std::vector<Vec3> places = mesh.vertices_W;
  for (std::size_t v = first; v < places.size(); ++v)
  {
    places[v].z() -= 8.6; // from 1.4 on: .6 are in both
  }
  EXPECT_NEAR(filledTwice(mesh, places, up), 0.6, 1e-14);
  const LinePiece slanted{ Vec3(0.73, 1.21, -1.0), Vec3(0.1, -0.05, 1.0).normalized(), 20.0 };
  EXPECT_NEAR(filledTwice(mesh, places, slanted), 0.6 / slanted.along_W.z(), 1e-14);
  EXPECT_NEAR(filledTwice(mesh, places, { up.from_W, up.along_W, 2.7 }), 0.3, 1e-14) << "it ends at 1.7";
  EXPECT_EQ(filledTwice(mesh, places, { Vec3(5, 5, -1), Vec3::UnitZ(), 20.0 }), 0.0) << "beside";
  for (Vec3& p : places)
  {
    p = Vec3(p.x(), p.y(), -p.z()); // a mirror turns all inside out: 2 + 2 of the line, and .6 in both
  }
  EXPECT_NEAR(filledTwice(mesh, places, { up.from_W + Vec3(0, 0, 5), -Vec3::UnitZ(), 20.0 }), 4.0 + 0.6, 1e-14);
}

} // namespace
} // namespace palpate::test
