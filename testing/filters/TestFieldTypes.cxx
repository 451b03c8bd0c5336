// SPDX-License-Identifier: GPL-3.0-or-later
// Data sets of every kind as fields. The judges are functions that the cells of a kind hold exactly, and VTK's probe.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "testing/support/Random.h"
#include "vtkAMRBox.h"
#include "vtkAppendFilter.h"
#include "vtkCellTypes.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticFlowSource.h"
#include "vtkHapticFlows.h"
#include "vtkHapticVtkVersions.h"
#include "vtkImageData.h"
#include "vtkLinearToQuadraticCellsFilter.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;

namespace
{
using FieldFunction = std::function<double(const Vec3&)>;
constexpr double everywhere = std::numeric_limits<double>::infinity();
constexpr double asFloats = 3e-6; ///< numbers of a block are floats, and functions here are below 20

double tilted(const Vec3& p)
{
  return 1.0 + 0.5 * p.x() - 0.75 * p.y() + 0.25 * p.z();
}

void addArray(vtkDataSet& data, const FieldFunction& function)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(function(Vec3(data.GetPoint(i))));
  }
  data.GetPointData()->AddArray(values);
}

vtkSmartPointer<vtkImageData> cubeOfPoints(int points, const Vec3& origin = Vec3::Zero(), double spacing = 1.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(origin.data());
  image->SetSpacing(spacing, spacing, spacing);
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> voxels(int points)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(cubeOfPoints(points));
  append->Update();
  return append->GetOutput();
}

MadeFieldBlock fieldOf(vtkDataObject* data, const char* array = "f")
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = array;
  const vtkHapticFieldResult field = vtkHapticToField(data, arrays);
  EXPECT_EQ(field.Problem, "");
  return field.Source ? field.Source->brickAround({ Vec3::Zero(), everywhere, 1 }) : MadeFieldBlock{};
}

/// Calls visit(p_W, value) for every point of the block; NaN where it has no value.
template<class Visit>
void forEachPoint(const FieldBlock& brick, const Visit& visit)
{
  const GridIndex& size = brick.grid().size;
  const FieldBlockComponent values = brick.component(FieldBlockRole::Scalar);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        visit(brick.grid().toWorld(Vec3(i, j, k)), values.at({ i, j, k }));
      }
    }
  }
}

/// Every value of the block is the function's, and those without one are no more than a share of its points.
void expectValues(
  const MadeFieldBlock& made, const FieldFunction& function, double withoutAtMost, double within = asFloats)
{
  ASSERT_TRUE(made.brick) << made.problem;
  std::size_t without = 0;
  forEachPoint(*made.brick,
    [&](const Vec3& p_W, double value)
    {
      without += std::isnan(value);
      if (!std::isnan(value))
      {
        ASSERT_NEAR(value, function(p_W), within) << p_W.transpose();
      }
    });
  EXPECT_LE(static_cast<double>(without), withoutAtMost * static_cast<double>(made.brick->grid().points()));
}

/// Values and where there are any are those of VTK's probe.
void expectAsProbed(const MadeFieldBlock& made, vtkDataSet* data)
{
  ASSERT_TRUE(made.brick) << made.problem;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> values;
  forEachPoint(*made.brick,
    [&](const Vec3& p_W, double value)
    {
      points->InsertNextPoint(p_W.data());
      values.push_back(value);
    });
  vtkNew<vtkPolyData> at;
  at->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(at);
  probe->SetSourceData(data);
  probe->Update();
  vtkDataArray* const found = probe->GetOutput()->GetPointData()->GetArray("f");
  vtkDataArray* const valid = probe->GetOutput()->GetPointData()->GetArray(probe->GetValidPointMaskArrayName());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    differ += std::isnan(values[i]) == (valid->GetTuple1(row) != 0.0);
    if (!std::isnan(values[i]) && valid->GetTuple1(row) != 0.0)
    {
      ASSERT_NEAR(values[i], found->GetTuple1(row), asFloats);
    }
  }
  EXPECT_EQ(differ, 0u);
}

TEST(FieldTypes, ARectilinearGridWithUnevenCellsHasItsValuesEverywhere)
{
  vtkNew<vtkRectilinearGrid> grid;
  vtkNew<vtkDoubleArray> x;
  for (int i = 0; i < 7; ++i)
  {
    x->InsertNextValue(0.1 * i * i);
  }
  grid->SetDimensions(7, 7, 7);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(x);
  grid->SetZCoordinates(x);
  addArray(*grid, tilted);
  expectValues(fieldOf(grid), tilted, 0.0);
  addArray(*grid, [](const Vec3& p) { return std::sin(2.0 * p.x()) * p.y() + p.z(); });
  expectAsProbed(fieldOf(grid), grid);
}

vtkSmartPointer<vtkStructuredGrid> bentGrid()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const int size = 9;
  for (int n = 0; n < size * size * size; ++n)
  {
    const double turn = 0.15 * (n % size), r = 3.0 + 0.5 * (n / size % size);
    points->InsertNextPoint(r * std::cos(turn), r * std::sin(turn), 0.6 * (n / size / size));
  }
  grid->SetDimensions(size, size, size);
  grid->SetPoints(points);
  return grid;
}

TEST(FieldTypes, ACurvilinearGridHasItsValuesAndNoneWhereItIsNot)
{
  const auto grid = bentGrid();
  addArray(*grid, tilted);
  const MadeFieldBlock made = fieldOf(grid);
  expectValues(made, tilted, 0.6); // a bent grid fills half of its box
  expectAsProbed(made, grid);
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Scalar, Vec3(1.5, 1.5, 2.0))); // inside of the bend
}

TEST(FieldTypes, BlankedCellsOfACurvilinearGridHaveNoValue)
{
  const auto grid = bentGrid();
  addArray(*grid, tilted);
  const Vec3 inside = 4.0 * Vec3(std::cos(0.6), std::sin(0.6), 0.0) + Vec3(0, 0, 2.1);
  ASSERT_TRUE(fieldOf(grid).brick->sample(FieldBlockRole::Scalar, inside));
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCell(i)->GetBounds()[4] > 1.0)
    {
      grid->BlankCell(i);
    }
  }
  const MadeFieldBlock made = fieldOf(grid);
  EXPECT_FALSE(made.brick && made.brick->sample(FieldBlockRole::Scalar, inside));
  EXPECT_TRUE(made.brick->sample(FieldBlockRole::Scalar, inside - Vec3(0, 0, 1.7)));
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->BlankCell(i);
  }
  const MadeFieldBlock nothing = fieldOf(grid);
  EXPECT_FALSE(nothing.brick && nothing.brick->sample(FieldBlockRole::Scalar, inside));
}

TEST(FieldTypes, VoxelsAndHexahedraOfAnUnstructuredGridHaveTheirValues)
{
  const auto grid = voxels(6);
  addArray(*grid, tilted);
  ASSERT_EQ(grid->GetCellType(0), VTK_VOXEL);
  expectValues(fieldOf(grid), tilted, 0.0);
}

TEST(FieldTypes, QuadraticCellsAreQuadraticBetweenTheirPoints)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(cubeOfPoints(4));
  vtkNew<vtkLinearToQuadraticCellsFilter> raise;
  raise->SetInputConnection(cut->GetOutputPort());
  raise->Update();
  vtkUnstructuredGrid* const grid = raise->GetOutput();
  ASSERT_EQ(grid->GetCellType(0), VTK_QUADRATIC_TETRA);
  // A tetrahedron of ten points holds every function of second degree; one of four is off by up to an eighth here.
  const FieldFunction square = [](const Vec3& p) { return p.x() * p.x() + p.y() * p.z(); };
  addArray(*grid, square);
  constexpr double inverted = 2e-4; // VTK seeks the place in a quadratic cell to 1e-5 of it, and the slope is up to 8
  expectValues(fieldOf(grid), square, 0.0, inverted);
}

TEST(FieldTypes, WhatIsRefinedOfAnAmrHasTheValuesOfItsFinestLevel)
{
  vtkNew<vtkOverlappingAMR> amr;
  vtkHapticSizeLevels(*amr, { 1, 1 });
  const double origin[3] = { 0.0, 0.0, 0.0 };
  amr->SetOrigin(origin);
  amr->SetRefinementRatio(0, 2);
  const Vec3 low = Vec3::Constant(2.0);
  for (unsigned level = 0; level < 2; ++level)
  {
    const double spacing[3] = { 1.0 / (1 + level), 1.0 / (1 + level), 1.0 / (1 + level) };
    amr->SetSpacing(level, spacing);
    vtkNew<vtkUniformGrid> grid;
    grid->SetDimensions(9, 9, 9);
    grid->SetOrigin(level == 0 ? origin : low.data());
    grid->SetSpacing(spacing);
    addArray(*grid, [level](const Vec3& p) { return tilted(p) + 8.0 * level; });
    int dimensions[3] = { 9, 9, 9 };
    amr->SetAMRBox(level, 0, vtkAMRBox(grid->GetOrigin(), dimensions, spacing, origin, vtkHapticThreeAxes));
    amr->SetDataSet(level, 0, grid);
  }
  amr->GenerateParentChildInformation();
  const MadeFieldBlock made = fieldOf(amr);
  ASSERT_TRUE(made.brick);
  for (const Vec3& p_W : { Vec3(1.0, 1.25, 1.5), Vec3(7.0, 7.5, 6.5), Vec3(1.0, 4.0, 4.0) })
  {
    EXPECT_NEAR(made.brick->sample(FieldBlockRole::Scalar, p_W)->value, tilted(p_W), asFloats);
  }
  for (const Vec3& p_W : { Vec3(4.0, 4.25, 4.5), Vec3(3.0, 3.5, 5.0) })
  {
    EXPECT_NEAR(made.brick->sample(FieldBlockRole::Scalar, p_W)->value, tilted(p_W) + 8.0, asFloats);
  }
}

/// Tetrahedra whose cells beyond x = 3 are marked.
vtkSmartPointer<vtkUnstructuredGrid> markedTetrahedra(unsigned char mark)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(cubeOfPoints(7));
  cut->Update();
  vtkSmartPointer<vtkUnstructuredGrid> grid = cut->GetOutput();
  addArray(*grid, tilted);
  grid->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellGhostArray()->SetValue(i, grid->GetCell(i)->GetBounds()[0] >= 3.0 ? mark : 0);
  }
  return grid;
}

TEST(FieldTypes, HiddenCellsOfTetrahedraHaveNoValueAndTheOthersHaveTheirs)
{
  const MadeFieldBlock made = fieldOf(markedTetrahedra(vtkDataSetAttributes::HIDDENCELL));
  expectValues(made, tilted, 0.6);
  EXPECT_TRUE(made.brick->sample(FieldBlockRole::Scalar, Vec3(1.5, 3.1, 3.2)));
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Scalar, Vec3(4.5, 3.1, 3.2)));
}

TEST(FieldTypes, CellsThatAnotherRankHasTooHaveTheirValues)
{
  const MadeFieldBlock made = fieldOf(markedTetrahedra(vtkDataSetAttributes::DUPLICATECELL));
  expectValues(made, tilted, 0.0);
  auto image = cubeOfPoints(6);
  addArray(*image, tilted);
  image->AllocateCellGhostArray();
  image->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); i += 3)
  {
    image->GetCellGhostArray()->SetValue(i, vtkDataSetAttributes::DUPLICATECELL);
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); i += 4)
  {
    image->GetPointGhostArray()->SetValue(i, vtkDataSetAttributes::DUPLICATEPOINT);
  }
  expectValues(fieldOf(image), tilted, 0.0);
}

TEST(FieldTypes, ATimeSeriesHasTheValuesOfItsTime)
{
  vtkNew<vtkHapticFlowSource> source;
  source->SetFlow(vtkHapticFlowSource::DoubleGyre);
  source->SetResolution(41);
  const vtkHapticFlow& gyre = vtkHapticFlows::All()[vtkHapticFlowSource::DoubleGyre];
  for (const double time : { 0.0, 2.5, 7.77 })
  {
    for (const int cells : { 0, 1 })
    {
      source->SetCells(cells);
      source->UpdateTimeStep(time);
      vtkHapticFieldArrays arrays;
      arrays.Vector = "Velocity";
      const vtkHapticFieldResult field = vtkHapticToField(source->GetOutputDataObject(0), arrays);
      ASSERT_TRUE(field.Source) << field.Problem;
      const MadeFieldBlock made = field.Source->brickAround({ Vec3::Zero(), everywhere, 1 });
      const Vec3 p_W(0.8, 0.35, 0.25); // a point of the image and of the mesh
      // Tetrahedra are seen on a lattice between their points: h^2 / 8 times second derivatives of at most 0.1 pi^3
      // each.
      const double within = cells == 0 ? 1e-6 : 3 * 0.05 * 0.05 / 8.0 * 0.1 * 31.1;
      EXPECT_LT((*made.brick->vector(p_W) - gyre.Velocity(p_W, time)).norm(), within) << time << ' ' << cells;
    }
  }
}
} // namespace
