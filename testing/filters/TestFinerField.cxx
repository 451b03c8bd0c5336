// SPDX-License-Identifier: GPL-3.0-or-later
// Data whose cells are smaller in a part of it. The judge is VTK's probe in the middle of the block's cells.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/support/Random.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;

namespace
{
constexpr double large = 2.0, small = 0.25; ///< lengths of cells [u]
constexpr double side = 48.0;               ///< of the box; the small cells are in the middle eighth

/// Bends everywhere as much as a cell of it tells.
double bends(const Vec3& p)
{
  return std::sin(2.0 * p.x()) + std::cos(1.7 * p.y()) + std::sin(1.9 * p.z());
}

vtkSmartPointer<vtkDoubleArray> gradedAxis()
{
  auto axis = vtkSmartPointer<vtkDoubleArray>::New();
  const double from = 0.5 * (side - side / 8.0), to = 0.5 * (side + side / 8.0);
  for (double at = 0.0; at <= side + 1e-9; at += at >= from - 1e-9 && at < to - 1e-9 ? small : large)
  {
    axis->InsertNextValue(at);
  }
  return axis;
}

vtkSmartPointer<vtkRectilinearGrid> gradedBox()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const auto axis = gradedAxis();
  const int points = static_cast<int>(axis->GetNumberOfTuples());
  grid->SetDimensions(points, points, points);
  grid->SetXCoordinates(axis);
  grid->SetYCoordinates(axis);
  grid->SetZCoordinates(axis);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(bends(Vec3(grid->GetPoint(i))));
  }
  grid->GetPointData()->AddArray(values);
  return grid;
}

vtkHapticFieldResult fieldFrom(vtkDataObject* data)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = "f";
  return vtkHapticToField(data, arrays);
}

/// The largest difference to VTK's probe at places around one, of a block.
double errorOf(const FieldBlock& brick, vtkDataSet* data, const Vec3& centre_W, double around_u)
{
  test::Random random(test::testSeed(1660));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 500; ++i)
  {
    points->InsertNextPoint(Vec3(centre_W + random.inCube(around_u)).data());
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(places);
  probe->SetSourceData(data);
  probe->Update();
  vtkDataArray* const truth = probe->GetOutput()->GetPointData()->GetArray("f");
  double largest = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const auto sample = brick.sample(FieldBlockRole::Scalar, Vec3(points->GetPoint(i)));
    largest = std::max(largest, sample ? std::abs(sample->value - truth->GetTuple1(i)) : INFINITY);
  }
  return largest;
}

TEST(FinerField, WhereCellsAreSmallerAFinerBrickHoldsThemAndElsewhereThereIsNone)
{
  const auto box = gradedBox();
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(box);
  cut->Update();
  const Vec3 middle = Vec3::Constant(0.5 * side), corner = Vec3::Constant(0.1 * side);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(box), static_cast<vtkDataSet*>(cut->GetOutput()) })
  {
    const vtkHapticFieldResult field = fieldFrom(data);
    ASSERT_TRUE(field.Source) << field.Problem;
    const MadeFieldBlock here = field.Source->brickAround({ middle, 20.0, 1 }),
                         there = field.Source->brickAround({ corner, 20.0, 2 });
    ASSERT_TRUE(here.brick && there.brick) << here.problem << there.problem;
    EXPECT_FALSE(there.brick->finer());
    EXPECT_TRUE(std::isfinite(there.finerReach_u)) << "a hand that comes to the small cells is noticed";
    ASSERT_TRUE(here.brick->finer());
    const FieldBlockGrid& finer = here.brick->finer()->grid();
    EXPECT_LE(finer.spacing_u.maxCoeff(), 0.75 * small) << "about half of a cell";
    EXPECT_LE(here.brick->bytes(), FieldBlock::mostBytes);
    const double around = 0.4 * std::min(finer.roomAt_u(middle), side / 8.0);
    EXPECT_LT(errorOf(*here.brick->finer(), data, middle, around), 0.2 * errorOf(*here.brick, data, middle, around))
      << data->GetClassName();
  }
}

TEST(FinerField, OfCellsThatAreAllAlikeIsNoneAndNoBrickIsMadeForOne)
{
  auto box = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> axis;
  for (int i = 0; i < 25; ++i)
  {
    axis->InsertNextValue(i + 0.3 * (i % 2));
  }
  box->SetDimensions(25, 25, 25);
  box->SetXCoordinates(axis);
  box->SetYCoordinates(axis);
  box->SetZCoordinates(axis);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(bends(Vec3(box->GetPoint(i))));
  }
  box->GetPointData()->AddArray(values);
  const vtkHapticFieldResult field = fieldFrom(box);
  ASSERT_TRUE(field.Source) << field.Problem;
  const MadeFieldBlock made = field.Source->brickAround({ Vec3(12, 12, 12), 5.0, 1 });
  ASSERT_TRUE(made.brick);
  EXPECT_FALSE(made.brick->finer());
  EXPECT_TRUE(std::isinf(made.finerReach_u));
}
} // namespace
