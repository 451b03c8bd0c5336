// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkHapticConversion.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
/// A volume is a sum of n products of three: each rounds, so does the sum.
double roundingOf(double volume, std::size_t triangles)
{
  return static_cast<double>(triangles) * 8.0 * std::numeric_limits<double>::epsilon() * std::abs(volume);
}

vtkSmartPointer<vtkUnstructuredGrid> makeHexahedron()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
  {
    const int x = (corner == 1 || corner == 2 || corner == 5 || corner == 6) ? 1 : 0;
    const int y = (corner == 2 || corner == 3 || corner == 6 || corner == 7) ? 1 : 0;
    points->InsertNextPoint(x, y, corner / 4);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  const vtkIdType ids[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  return grid;
}

vtkSmartPointer<vtkMatrix4x4> matrixOf(std::initializer_list<double> rows)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(rows.begin());
  return matrix;
}
} // namespace

TEST(Conversion, TrianglesKeepTheirCoordinatesAndOrder)
{
  const vtkHapticConversionResult result = vtkHapticToMesh(makePlane(2.0, 0.5));
  ASSERT_TRUE(result.Mesh) << result.Problem;
  ASSERT_EQ(result.Mesh->vertices_W.size(), 4u);
  EXPECT_EQ(result.Mesh->vertices_W[2], Vec3(2.0, 2.0, 1.0));
  const std::vector<std::array<std::uint32_t, 3>> expected = { { 0, 1, 2 }, { 0, 2, 3 } };
  EXPECT_EQ(result.Mesh->triangles, expected);
}

TEST(Conversion, ThereAndBackGivesTheSameMesh)
{
  const vtkHapticConversionResult there = vtkHapticToMesh(makeSphere(3.0, 12));
  ASSERT_TRUE(there.Mesh) << there.Problem;
  const vtkHapticConversionResult back = vtkHapticToMesh(vtkHapticToPolyData(*there.Mesh));
  ASSERT_TRUE(back.Mesh) << back.Problem;
  EXPECT_EQ(back.Mesh->vertices_W, there.Mesh->vertices_W);
  EXPECT_EQ(back.Mesh->triangles, there.Mesh->triangles);
}

TEST(Conversion, StripsEncloseTheSameVolumeAsTheirTriangles)
{
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(2.0, 24);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  const auto triangles = vtkHapticToMesh(sphere);
  const auto strips = vtkHapticToMesh(stripper->GetOutput());
  ASSERT_TRUE(strips.Mesh) << strips.Problem;
  EXPECT_EQ(strips.Mesh->triangles.size(), triangles.Mesh->triangles.size());
  const double expected = enclosedVolume(*triangles.Mesh);
  EXPECT_NEAR(enclosedVolume(*strips.Mesh), expected, roundingOf(expected, strips.Mesh->triangles.size()));
}

TEST(Conversion, TheSkinOfAVolumeCellIsClosedAndFacesOut)
{
  const auto cube = vtkHapticToMesh(makeHexahedron());
  ASSERT_TRUE(cube.Mesh) << cube.Problem;
  EXPECT_EQ(cube.Mesh->triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(enclosedVolume(*cube.Mesh), 1.0);
}

TEST(Conversion, ScaleShearAndShiftAreBakedIntoTheVertices)
{
  const auto matrix = matrixOf({ 2, 0.5, 0, 10, 0, 3, 0.25, -20, 0, 0, 4, 30, 0, 0, 0, 1 });
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(1.0, 16);
  const auto plain = vtkHapticToMesh(sphere);
  const auto placed = vtkHapticToMesh(sphere, matrix);
  ASSERT_TRUE(placed.Mesh) << placed.Problem;
  const Vec3 p = plain.Mesh->vertices_W[7];
  const Vec3 expected(
    2 * p.x() + 0.5 * p.y() + 10, 3 * p.y() + 0.25 * p.z() - 20, 4 * p.z() + 30); // rows of the matrix
  EXPECT_LT((placed.Mesh->vertices_W[7] - expected).norm(), 1e-14 * expected.norm());
  EXPECT_EQ(placed.Mesh->triangles, plain.Mesh->triangles);
}

TEST(Conversion, AMirroredActorStaysTheRightWayOut)
{
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(1.0, 16);
  const double volume = enclosedVolume(*vtkHapticToMesh(sphere).Mesh);
  ASSERT_GT(volume, 0.0);
  const auto mirrored = vtkHapticToMesh(sphere, matrixOf({ -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }));
  ASSERT_TRUE(mirrored.Mesh) << mirrored.Problem;
  EXPECT_NEAR(enclosedVolume(*mirrored.Mesh), volume, roundingOf(volume, mirrored.Mesh->triangles.size()));
}

TEST(Conversion, BlocksOfACompositeAreAllTaken)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makeHexahedron());
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, makePlane(1.0));
  outer->SetBlock(1, nullptr);
  outer->SetBlock(2, inner);
  const auto result = vtkHapticToMesh(outer);
  ASSERT_TRUE(result.Mesh) << result.Problem;
  EXPECT_EQ(result.Mesh->triangles.size(), 2u + 12u);
  EXPECT_DOUBLE_EQ(enclosedVolume(*result.Mesh), 1.0); // the plane goes through the origin
}

TEST(Conversion, TheInputIsNotChanged)
{
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(1.0, 8);
  const vtkMTimeType before = sphere->GetMTime();
  ASSERT_TRUE(vtkHapticToMesh(sphere).Mesh);
  EXPECT_EQ(sphere->GetMTime(), before);
}

TEST(Conversion, NaNPointsAreLeftToCleaningWhichReportsThem)
{
  const vtkSmartPointer<vtkPolyData> plane = makePlane(1.0);
  plane->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
  const auto result = vtkHapticToMesh(plane);
  ASSERT_TRUE(result.Mesh) << result.Problem;
  const CleanResult clean = cleanMesh(*result.Mesh);
  EXPECT_EQ(clean.report.nonFinite, 1u);
  EXPECT_EQ(clean.report.trianglesOut, 1u);
}

TEST(Conversion, WhatHasNoSurfaceIsRefusedWithAReason)
{
  EXPECT_THAT(vtkHapticToMesh(nullptr).Problem, HasSubstr("no data"));
  EXPECT_THAT(vtkHapticToMesh(vtkSmartPointer<vtkTable>::New()).Problem, HasSubstr("vtkTable"));
  EXPECT_THAT(vtkHapticToMesh(vtkSmartPointer<vtkPolyData>::New()).Problem, HasSubstr("no polygons"));
  EXPECT_THAT(vtkHapticToMesh(makePath({ Vec3::Zero(), Vec3::Ones() })).Problem, HasSubstr("no polygons"));
}

TEST(Conversion, LinesBecomeSegmentsInTheirPlace)
{
  const vtkSmartPointer<vtkPolyData> path = makePath({ Vec3::Zero(), Vec3::UnitX(), Vec3(1, 2, 0) });
  const auto lines = vtkHapticToLines(path, matrixOf({ 1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }));
  ASSERT_TRUE(lines.Mesh) << lines.Problem;
  EXPECT_EQ(vtkHapticCountLines(path), 1u);
  const std::vector<std::array<std::uint32_t, 3>> segments{ { 0, 1, 1 }, { 1, 2, 2 } };
  EXPECT_EQ(lines.Mesh->triangles, segments);
  EXPECT_EQ(lines.Mesh->vertices_W.at(2), Vec3(6, 2, 0));
  EXPECT_THAT(vtkHapticToLines(makePlane(1.0)).Problem, HasSubstr("no lines"));
  EXPECT_TRUE(test::says(vtkHapticToMesh(path).Problem, { "polygons", "radius", "0" }));
}

TEST(Conversion, AnIndexOutOfRangeIsRefusedBeforeAFilterMeetsIt)
{
  const vtkSmartPointer<vtkPolyData> plane = makePlane(1.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 1000000 });
  plane->SetPolys(triangles);
  const auto result = vtkHapticToMesh(plane);
  EXPECT_FALSE(result.Mesh);
  EXPECT_FALSE(result.Problem.empty());
}

TEST(Conversion, ATransformThatPutsPointsNowhereIsRefused)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const vtkSmartPointer<vtkPolyData> plane = makePlane(1.0);
  const auto endless = matrixOf({ infinity, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  EXPECT_THAT(vtkHapticToMesh(plane, endless).Problem, HasSubstr("not finite"));
  const auto perspective = matrixOf({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0.5, 1 });
  EXPECT_THAT(vtkHapticToMesh(plane, perspective).Problem, HasSubstr("perspective"));
}

namespace
{
/// Two squares side by side and a pentagon on top, whose shortest diagonals change with the shear.
vtkSmartPointer<vtkPolyData> makePolygons(double shear)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  std::vector<std::array<double, 3>> corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { 2, 1, 0 }, { 1, 2, 0 } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& [x, y, z] : corners)
  {
    points->InsertNextPoint(x + shear * y, y, z);
  }
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 4, 3 });
  polygons->InsertNextCell({ 1, 2, 5, 4 });
  polygons->InsertNextCell({ 3, 4, 5, 6 });
  surface->SetPolys(polygons);
  return surface;
}
} // namespace

TEST(Conversion, PolygonsThatHaveOnlyMovedAreCutAsTheyWere)
{
  const auto first = vtkHapticToMesh(makePolygons(0.4));
  ASSERT_EQ(first.Mesh->triangles.size(), 6u);
  const auto sheared = makePolygons(-0.4);
  ASSERT_NE(vtkHapticToMesh(sheared).Mesh->triangles, first.Mesh->triangles) << "the shorter diagonals are others";
  const auto second = vtkHapticToMesh(sheared, nullptr, &first.Cuts);
  EXPECT_EQ(second.Mesh->triangles, first.Mesh->triangles);
  EXPECT_EQ(second.Mesh->vertices_W, vtkHapticToMesh(sheared).Mesh->vertices_W);
  EXPECT_EQ(vtkHapticToMesh(makePolygons(-0.5), nullptr, &second.Cuts).Mesh->triangles, first.Mesh->triangles);
}

TEST(Conversion, CutsOfBlocksAreTakenBlockByBlockAndOnlyForTheSamePolygons)
{
  const auto blocks = [](double shear, int points)
  {
    auto both = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    both->SetBlock(0, makeSphere(1.0, points));
    both->SetBlock(1, makePolygons(shear));
    return both;
  };
  const auto first = vtkHapticToMesh(blocks(0.4, 8));
  const auto moved = vtkHapticToMesh(blocks(-0.4, 8), nullptr, &first.Cuts);
  EXPECT_EQ(moved.Mesh->triangles, first.Mesh->triangles);
  const auto other = vtkHapticToMesh(blocks(-0.4, 9), nullptr, &first.Cuts); // the squares begin at another vertex now
  const std::size_t before = first.Mesh->triangles.size() - 6, now = other.Mesh->triangles.size() - 6;
  const auto shift = static_cast<std::uint32_t>(other.PartPoints[0] - first.PartPoints[0]);
  ASSERT_NE(shift, 0u);
  for (std::size_t i = 0; i < 6; ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(other.Mesh->triangles[now + i][k], first.Mesh->triangles[before + i][k] + shift);
    }
  }
  EXPECT_EQ(vtkHapticToMesh(blocks(-0.4, 9)).Mesh->triangles.size(), other.Mesh->triangles.size());
}

TEST(Conversion, AMirrorOrAPolygonThatHadNoAreaIsCutAnew)
{
  const auto first = vtkHapticToMesh(makePolygons(0.4));
  const auto mirror = matrixOf({ -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  const auto mirrored = vtkHapticToMesh(makePolygons(0.4), mirror, &first.Cuts);
  EXPECT_EQ(mirrored.Mesh->triangles, vtkHapticToMesh(makePolygons(0.4), mirror).Mesh->triangles);
  const auto flat = makePolygons(0.4); // every corner on one line
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    flat->GetPoints()->SetPoint(i, static_cast<double>(i), 0.0, 0.0);
  }
  const auto none = vtkHapticToMesh(flat);
  EXPECT_EQ(vtkHapticToMesh(makePolygons(0.4), nullptr, &none.Cuts).Mesh->triangles, first.Mesh->triangles);
}

namespace
{
/// One polygon with corners at these points.
vtkSmartPointer<vtkPolyData> makePolygon(const std::vector<Vec3>& corners_W)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<int>(corners_W.size()));
  for (const Vec3& p : corners_W)
  {
    polygons->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}

/// A square with a square hole, reached from a corner and left the same way, in a plane that no axis is normal to.
std::vector<Vec3> keyhole()
{
  std::vector<Vec3> corners;
  for (const auto& [x, y] : std::vector<std::array<double, 2>>{
         { 0, 0 }, { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 }, { 1, 1 }, { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } })
  {
    corners.emplace_back(x - y, x + y, 2 * x + y);
  }
  return corners;
}
} // namespace

TEST(Conversion, AKeyholePolygonHasItsOwnBorderAndArea)
{
  const auto result = vtkHapticToMesh(makePolygon(keyhole()));
  ASSERT_TRUE(result.Mesh) << result.Problem;
  const CleanReport report = cleanMesh(*result.Mesh).report;
  EXPECT_EQ(report.boundaryEdges, 4u + 4u) << "round the square and round its hole; the way to the hole is closed";
  EXPECT_EQ(report.collinear, 0u);
  const Vec3 normal = Vec3(1, 1, 2).cross(Vec3(-1, 1, 1)); // of one cell
  Vec3 area = Vec3::Zero();
  for (const auto& [a, b, c] : result.Mesh->triangles)
  {
    const std::vector<Vec3>& v = result.Mesh->vertices_W;
    area += (v[b] - v[a]).cross(v[c] - v[a]) / 2.0;
  }
  EXPECT_EQ(area, (3.0 * 3.0 - 1.0) * normal);
  EXPECT_TRUE(result.HoleEdges.empty());
}

TEST(Conversion, APolygonWithACornerThatIsNotFiniteIsAHoleWithItsEdges)
{
  const auto polygons = makePolygons(0.0);
  polygons->GetPoints()->SetPoint(6, 1.0, std::nan(""), 0.0); // the tip of the pentagon's four corners
  const auto result = vtkHapticToMesh(polygons);
  ASSERT_TRUE(result.Mesh) << result.Problem;
  EXPECT_EQ(result.Mesh->triangles.size(), 4u) << "two squares";
  EXPECT_EQ(result.HoleEdges, std::vector<std::size_t>{ 4 });
  std::vector<Vec3> corners = keyhole();
  corners[3].z() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(vtkHapticToMesh(makePolygon(corners)).Problem, HasSubstr("1 hole of 10 edges"));
}

TEST(Conversion, StripsAndPolygonsOfAMirroredActorStayTheRightWayOut)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(makeSphere(1.0, 16));
  stripper->Update();
  const double volume = enclosedVolume(*vtkHapticToMesh(stripper->GetOutput()).Mesh);
  ASSERT_GT(volume, 0.0);
  const auto mirror = matrixOf({ -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  const auto strips = vtkHapticToMesh(stripper->GetOutput(), mirror);
  EXPECT_NEAR(enclosedVolume(*strips.Mesh), volume, roundingOf(volume, strips.Mesh->triangles.size()));
  EXPECT_DOUBLE_EQ(enclosedVolume(*vtkHapticToMesh(makeHexahedron(), mirror).Mesh), 1.0);
}
