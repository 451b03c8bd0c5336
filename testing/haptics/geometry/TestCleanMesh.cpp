// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/TriangleMesh.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;

/// Two triangles over the unit square: 5 edges, 4 of them at the border.
TriangleMesh square()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } } };
}

void expectSameMesh(const TriangleMesh& a, const TriangleMesh& b)
{
  EXPECT_EQ(a.vertices_W, b.vertices_W);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(CleanMesh, KeepsAGoodMeshAndCountsItsBorder)
{
  const CleanResult clean = cleanMesh(square());
  ASSERT_TRUE(clean.ok()) << clean.refusal;
  EXPECT_EQ(clean.report.trianglesIn, 2u);
  EXPECT_EQ(clean.report.trianglesOut, 2u);
  EXPECT_EQ(clean.report.verticesOut, 4u);
  EXPECT_EQ(clean.report.boundaryEdges, 4u);
  EXPECT_EQ(clean.report.nonManifoldEdges, 0u);
  EXPECT_EQ(clean.report.nonFinite + clean.report.collinear + clean.report.duplicate, 0u);
}

TEST(CleanMesh, AClosedMeshHasNoBorder)
{
  const CleanResult clean = cleanMesh(makeIcosphere(2, 50.0));
  ASSERT_TRUE(clean.ok());
  EXPECT_EQ(clean.report.trianglesOut, 320u);
  EXPECT_EQ(clean.report.verticesOut, 162u); // Euler: V = 2 + T / 2
  EXPECT_EQ(clean.report.boundaryEdges, 0u);
}

TEST(CleanMesh, DropsAndCountsTrianglesWithANonFiniteCorner)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  mesh.vertices_W.emplace_back(0, std::numeric_limits<double>::infinity(), 0);
  mesh.triangles.push_back({ 0, 1, 4 });
  mesh.triangles.push_back({ 5, 1, 2 });
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.nonFinite, 2u);
  expectSameMesh(clean.mesh, cleanMesh(square()).mesh);
}

TEST(CleanMesh, DropsExactlyCollinearTrianglesAndKeepsTheThinnestOther)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(0.5, 0.5, 0.0);    // on the diagonal
  mesh.vertices_W.emplace_back(0.5, 0.5, 1e-200); // not on it
  mesh.triangles.push_back({ 0, 4, 2 });
  mesh.triangles.push_back({ 0, 5, 2 });
  mesh.triangles.push_back({ 1, 1, 2 }); // a repeated corner has no area either
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.collinear, 2u);
  EXPECT_EQ(clean.report.trianglesOut, 3u);
}

TEST(CleanMesh, KeepsAThinTriangleThatNoAreaThresholdWouldKeep)
{
  // One unit in the last place off the line; its area is 1e-16 of the square's.
  const TriangleMesh mesh{ { { 0, 0, 0 }, { 1, 1, 1 }, { 0.5, 0.5, std::nextafter(0.5, 1.0) } }, { { 0, 1, 2 } } };
  EXPECT_TRUE(cleanMesh(mesh).ok());
}

TEST(CleanMesh, DropsRepeatedTrianglesInAnyOrderOfCorners)
{
  TriangleMesh mesh = square();
  mesh.triangles.push_back({ 2, 0, 1 });
  mesh.triangles.push_back({ 2, 1, 0 });
  mesh.triangles.push_back({ 0, 1, 2 });
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.duplicate, 3u);
  expectSameMesh(clean.mesh, cleanMesh(square()).mesh);
}

TEST(CleanMesh, WeldsExactlyEqualVerticesAndTheTwoZeros)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(-0.0, 0, -0.0); // vertex 0 again
  mesh.triangles[1] = { 4, 2, 3 };
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.verticesOut, 4u);
  EXPECT_EQ(clean.report.boundaryEdges, 4u);
  expectSameMesh(clean.mesh, cleanMesh(square()).mesh);
  for (const Vec3& v : clean.mesh.vertices_W)
  {
    EXPECT_FALSE(std::signbit(v.x()) || std::signbit(v.z()));
  }
}

TEST(CleanMesh, DoesNotWeldVerticesThatDifferInTheLastPlace)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(std::nextafter(1.0, 2.0), 1, 0);
  mesh.triangles[1] = { 0, 4, 3 };
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.verticesOut, 5u);
  EXPECT_EQ(clean.report.boundaryEdges, 6u);
}

TEST(CleanMesh, CountsAndKeepsAFinOnAnEdge)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(0.5, 0.5, 1.0);
  mesh.triangles.push_back({ 0, 2, 4 }); // a third triangle on the diagonal
  const CleanResult clean = cleanMesh(mesh);
  EXPECT_EQ(clean.report.nonManifoldEdges, 1u);
  EXPECT_EQ(clean.report.boundaryEdges, 6u);
  EXPECT_EQ(clean.report.trianglesOut, 3u);
}

TEST(CleanMesh, DropsVerticesThatNoTriangleUses)
{
  TriangleMesh mesh = square();
  mesh.vertices_W.emplace_back(1e9, 0, 0);
  EXPECT_EQ(cleanMesh(mesh).report.verticesOut, 4u);
}

TEST(CleanMesh, DoesNotDependOnTheOrderOfTheInput)
{
  Random random(testSeed(11));
  const TriangleMesh mesh = makeIcosphere(2, 0.05);
  const CleanResult first = cleanMesh(mesh);
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    SCOPED_TRACE("shuffle " + std::to_string(i));
    expectSameMesh(cleanMesh(shuffled(mesh, random)).mesh, first.mesh);
  }
}

TEST(CleanMesh, BringsADamagedMeshToTheSameFormAsTheGoodOne) // row 15
{
  Random random(testSeed(12));
  const TriangleMesh mesh = makeIcosphere(2, 0.05);
  for (std::size_t i = 0; i < testCount(20); ++i)
  {
    const CleanResult clean = cleanMesh(withDefects(mesh, random));
    expectSameMesh(clean.mesh, cleanMesh(mesh).mesh);
    // Of 320 added defects each of four kinds comes 80 times; a duplicate comes five times over.
    EXPECT_EQ(clean.report.duplicate, 80u * 5 + 80u);
    EXPECT_EQ(clean.report.collinear, 80u);
    EXPECT_EQ(clean.report.nonFinite, 80u);
  }
}

TEST(CleanMesh, CleaningACleanMeshChangesNothing)
{
  const CleanResult once = cleanMesh(makeIcosphere(2, 50.0));
  expectSameMesh(cleanMesh(once.mesh).mesh, once.mesh);
}

TEST(CleanMesh, RefusesAnIndexOutOfRangeAndNamesIt)
{
  TriangleMesh mesh = square();
  mesh.triangles.push_back({ 0, 1, 77 });
  const CleanResult clean = cleanMesh(mesh);
  ASSERT_FALSE(clean.ok());
  EXPECT_THAT(clean.refusal, HasSubstr("77"));
  EXPECT_THAT(clean.refusal, HasSubstr("triangle 2"));
}

TEST(CleanMesh, RefusesAMeshWithoutTriangles)
{
  EXPECT_FALSE(cleanMesh({}).ok());
  EXPECT_FALSE(cleanMesh({ square().vertices_W, {} }).ok());
}

TEST(CleanMesh, RefusesAMeshOfWhichNothingIsLeft)
{
  TriangleMesh mesh = square();
  mesh.triangles = { { 0, 0, 1 }, { 2, 2, 2 } };
  const CleanResult clean = cleanMesh(mesh);
  ASSERT_FALSE(clean.ok());
  EXPECT_EQ(clean.refusal.find('\n'), std::string::npos);
  EXPECT_EQ(clean.report.collinear, 2u);
}

TEST(CleanMesh, SaysInOneLineWhatItDropped)
{
  Random random(testSeed(13));
  const std::string line = cleanMesh(withDefects(makeIcosphere(0, 1.0), random)).report.summary();
  EXPECT_THAT(line, HasSubstr("20 of"));
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

} // namespace
} // namespace palpate::test
