// SPDX-License-Identifier: GPL-3.0-or-later
// Holes, flipped parts and thin walls as blocks, against VTK and the faults made in the surface.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkHapticSurfaceCheck.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace palpate::testing::checked
{
namespace
{

constexpr double radius = 10.0; // u

vtkPolyData* blockOf(vtkHapticSurfaceCheck* check, const char* name)
{
  vtkMultiBlockDataSet* const blocks = check->GetOutput();
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    if (std::string(blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())) == name)
    {
      return vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    }
  }
  return nullptr;
}

void run(vtkHapticSurfaceCheck* check, vtkPolyData* surface)
{
  check->SetInputData(surface);
  check->Update();
  for (const char* name : { "Surface", "Holes", "Flipped", "Thin" })
  {
    ASSERT_TRUE(blockOf(check, name)) << name;
  }
}

double valueOf(vtkPolyData* data, const char* array, vtkIdType cell)
{
  return data->GetCellData()->GetArray(array)->GetComponent(cell, 0);
}

std::set<vtkIdType> someCells(vtkPolyData* surface, std::size_t count, test::Random& random)
{
  std::set<vtkIdType> cells;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto cell = static_cast<vtkIdType>(random.uniform(0.0, static_cast<double>(surface->GetNumberOfPolys())));
    cells.insert(std::min(cell, surface->GetNumberOfPolys() - 1));
  }
  return cells;
}

double lengthOf(vtkPolyData* lines)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ends;
    lines->GetCellPoints(cell, ends);
    sum += (Vec3(lines->GetPoint(ends->GetId(1))) - Vec3(lines->GetPoint(ends->GetId(0)))).norm();
  }
  return sum;
}
} // namespace

TEST(SurfaceCheck, HolesAreTheEdgesThatVtkHasAtTheBorder)
{
  test::Random random(test::testSeed(161));
  for (std::size_t i = 0; i < test::testCount(10); ++i)
  {
    const auto whole = makeSphere(radius, 12);
    const std::set<vtkIdType> gone = someCells(whole, 1 + i, random);
    vtkNew<vtkCellArray> left;
    for (vtkIdType cell = 0; cell < whole->GetNumberOfPolys(); ++cell)
    {
      vtkNew<vtkIdList> corners;
      whole->GetCellPoints(cell, corners);
      if (gone.count(cell) == 0)
      {
        left->InsertNextCell(corners);
      }
    }
    whole->SetPolys(left);
    vtkNew<vtkFeatureEdges> theirs;
    theirs->SetInputData(whole);
    theirs->FeatureEdgesOff();
    theirs->NonManifoldEdgesOff();
    theirs->ManifoldEdgesOff();
    theirs->Update();
    vtkNew<vtkHapticSurfaceCheck> check;
    run(check, whole);
    vtkPolyData* const holes = blockOf(check, "Holes");
    EXPECT_EQ(holes->GetNumberOfLines(), theirs->GetOutput()->GetNumberOfLines());
    EXPECT_NEAR(lengthOf(holes), lengthOf(theirs->GetOutput()), 1e-5 * radius); // theirs has single precision
    std::map<double, double> lengths;
    for (vtkIdType cell = 0; cell < holes->GetNumberOfCells(); ++cell)
    {
      lengths[valueOf(holes, "Hole", cell)] = valueOf(holes, "Length", cell);
    }
    const double sum = std::accumulate(
      lengths.begin(), lengths.end(), 0.0, [](double so, const auto& each) { return so + each.second; });
    EXPECT_NEAR(sum, lengthOf(holes), 1e-9 * radius) << "each hole once";
    EXPECT_EQ(lengths.rbegin()->first, static_cast<double>(lengths.size())) << "numbered from 1 on";
  }
}

TEST(SurfaceCheck, WhatWasTurnedAroundAndNothingElseIsFlipped)
{
  test::Random random(test::testSeed(162));
  for (std::size_t i = 0; i < test::testCount(10); ++i)
  {
    const auto ball = makeSphere(radius, 12);
    const std::set<vtkIdType> turned = someCells(ball, 3 * i, random);
    for (const vtkIdType cell : turned)
    {
      ball->GetPolys()->ReverseCellAtId(cell);
    }
    vtkNew<vtkHapticSurfaceCheck> check;
    run(check, ball);
    std::set<vtkIdType> found, listed;
    for (vtkIdType cell = 0; cell < ball->GetNumberOfPolys(); ++cell)
    {
      if (valueOf(blockOf(check, "Surface"), "Flipped", cell) > 0)
      {
        found.insert(cell);
      }
    }
    vtkPolyData* const flipped = blockOf(check, "Flipped");
    for (vtkIdType cell = 0; cell < flipped->GetNumberOfCells(); ++cell)
    {
      listed.insert(static_cast<vtkIdType>(valueOf(flipped, "Triangle", cell)));
    }
    EXPECT_EQ(found, turned);
    EXPECT_EQ(listed, turned);
    EXPECT_EQ(blockOf(check, "Holes")->GetNumberOfCells(), 0);
  }
}

TEST(SurfaceCheck, ASlabIsThinOnBothItsFacesAndSaysHowThin)
{
  constexpr double height = 0.1;
  vtkNew<vtkCubeSource> slab;
  slab->SetXLength(4.0);
  slab->SetYLength(4.0);
  slab->SetZLength(height);
  slab->Update();
  vtkNew<vtkHapticSurfaceCheck> check;
  run(check, slab->GetOutput());
  EXPECT_EQ(blockOf(check, "Thin")->GetNumberOfCells(), 0) << "nobody said what is thin";
  check->SetThinBelow(0.5);
  run(check, slab->GetOutput());
  vtkPolyData* const thin = blockOf(check, "Thin");
  ASSERT_EQ(thin->GetNumberOfCells(), 4) << "two triangles above, two below";
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    EXPECT_NEAR(valueOf(thin, "Thickness", cell), height, 1e-6);
    EXPECT_NEAR(std::abs(thin->GetCell(cell)->GetPoints()->GetPoint(0)[2]), 0.5 * height, 1e-6);
  }
  vtkPolyData* const surface = blockOf(check, "Surface");
  int others = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    others += std::isnan(valueOf(surface, "Thickness", cell)) ? 1 : 0;
  }
  EXPECT_EQ(others, 8) << "two triangles on each of four sides";
}

TEST(SurfaceCheck, WithoutPolygonsOrOfAPartOfTheDataItRefusesInALine)
{
  vtkNew<vtkHapticSurfaceCheck> check;
  check->SetInputData(makePath({ Vec3(0, 0, 0), Vec3(1, 0, 0) }));
  const auto errors = errorsOf(static_cast<vtkObject*>(check), [&] { check->Update(); });
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(errors.front().find("Nothing is checked: "), std::string::npos) << errors.front();
  check->SetInputData(makeSphere(radius, 12));
  const auto ofPart = errorsOf(static_cast<vtkObject*>(check), [&] { check->UpdatePiece(1, 2, 0); });
  ASSERT_FALSE(ofPart.empty());
  EXPECT_NE(ofPart.front().find("requested in 2 pieces"), std::string::npos) << ofPart.front();
}

} // namespace palpate::testing::checked
