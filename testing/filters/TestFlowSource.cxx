// SPDX-License-Identifier: GPL-3.0-or-later
// The generated flows against their known properties: formulas written here anew, no divergence, their time.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "haptics/core/Types.h"
#include "testing/support/Random.h"
#include "vtkCell.h"
#include "vtkDataSet.h"
#include "vtkHapticFlowSource.h"
#include "vtkHapticFlows.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMeshQuality.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

using palpate::Vec3;

namespace
{
constexpr double pi = std::numbers::pi;

vtkSmartPointer<vtkDataSet> flowOn(int flow, int cells, int resolution, double time = 0.0)
{
  vtkNew<vtkHapticFlowSource> source;
  source->SetFlow(flow);
  source->SetCells(cells);
  source->SetResolution(resolution);
  source->UpdateTimeStep(time);
  return vtkDataSet::SafeDownCast(source->GetOutputDataObject(0));
}

Vec3 velocityAt(vtkDataSet& data, vtkIdType point)
{
  Vec3 v;
  data.GetPointData()->GetArray("Velocity")->GetTuple(point, v.data());
  return v;
}

class KnownFlow : public ::testing::TestWithParam<int>
{
};

TEST_P(KnownFlow, IsOnTheSameEvenlySpacedPointsOnAnImageAndOnTetrahedraThatFillTheSameBox)
{
  const auto image = flowOn(GetParam(), vtkHapticFlowSource::Image, 9);
  const auto grid = flowOn(GetParam(), vtkHapticFlowSource::Tetrahedra, 9);
  ASSERT_EQ(image->GetNumberOfPoints(), grid->GetNumberOfPoints());
  ASSERT_EQ(grid->GetNumberOfCells(), 6 * image->GetNumberOfCells());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vec3(image->GetPoint(i)), Vec3(grid->GetPoint(i)));
    EXPECT_EQ(velocityAt(*image, i), velocityAt(*grid, i));
    EXPECT_DOUBLE_EQ(grid->GetPointData()->GetArray("Speed")->GetTuple1(i), velocityAt(*grid, i).norm());
  }
  double volume = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const double one = vtkMeshQuality::TetVolume(grid->GetCell(i)); // negative where it is inside out
    EXPECT_GT(one, 0.0);
    volume += one;
  }
  const double* const b = image->GetBounds();
  EXPECT_NEAR(volume, (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]), 1e-9);
}

TEST_P(KnownFlow, HasNoSourcesOrSinks)
{
  const vtkHapticFlow& flow = vtkHapticFlows::All()[static_cast<std::size_t>(GetParam())];
  palpate::test::Random random(palpate::test::testSeed(1801));
  constexpr double d = 1e-5;
  for (int n = 0; n < 200; ++n)
  {
    const double time = random.uniform(0.0, 10.0);
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = random.uniform(flow.Low[k], flow.High[k]);
    }
    double divergence = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 step = d * Vec3::Unit(k);
      divergence += (flow.Velocity(p + step, time)[k] - flow.Velocity(p - step, time)[k]) / (2.0 * d);
    }
    EXPECT_NEAR(divergence, 0.0, 1e-8) << flow.Name << ' ' << p.transpose();
  }
}
INSTANTIATE_TEST_SUITE_P(Flows, KnownFlow, ::testing::Range(0, 4));

TEST(FlowSource, EachFlowHasTheVelocitiesOfItsFormula)
{
  // At places where the formulas of the literature give plain numbers.
  const auto& [abc, green, oseen, gyre] = vtkHapticFlows::All();
  EXPECT_LT((abc.Velocity(Vec3(0, 0, 0), 0) - Vec3(1, std::sqrt(3.0), std::sqrt(2.0))).norm(), 1e-15);
  EXPECT_LT((abc.Velocity(Vec3(pi / 2, pi / 2, pi / 2), 0) - Vec3(std::sqrt(3.0), std::sqrt(2.0), 1)).norm(), 1e-15);
  EXPECT_LT((green.Velocity(Vec3(pi / 2, 0, 0), 0) - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((green.Velocity(Vec3(0, pi / 2, pi), 0) - Vec3(0, 1, 0)).norm(), 1e-15);
  for (const double r : { 0.01, 0.5, 1.0, 3.0 }) // G / (2 pi r) (1 - exp(-r^2)), G = 2 pi
  {
    EXPECT_NEAR(oseen.Velocity(Vec3(0, r, 1), 0).x(), -(1.0 - std::exp(-r * r)) / r, 1e-7 * r) << r;
  }
  EXPECT_EQ(oseen.Velocity(Vec3(0, 1e-9, 1), 0).x(), -1e-9); // a solid body at its axis, without a loss of digits
  EXPECT_LT((gyre.Velocity(Vec3(0.5, 0, 0), 0) - Vec3(-0.1 * pi, 0, 0)).norm(), 1e-15);
  // At a quarter of the time a = 1/4 and b = 1/2: f(1) = 3/4, f'(1) = 1.
  EXPECT_LT((gyre.Velocity(Vec3(1, 0.5, 0), 2.5) - Vec3(0, -0.1 * pi * std::sqrt(0.5), 0)).norm(), 1e-15);
}

TEST(FlowSource, OfTheDoubleGyreAnyTimeIsExactAndOthersHaveNone)
{
  const auto data = flowOn(vtkHapticFlowSource::DoubleGyre, vtkHapticFlowSource::Image, 17, 3.14159);
  EXPECT_EQ(data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 3.14159);
  const vtkHapticFlow& gyre = vtkHapticFlows::All()[vtkHapticFlowSource::DoubleGyre];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(velocityAt(*data, i), gyre.Velocity(Vec3(data->GetPoint(i)), 3.14159));
  }
  vtkNew<vtkHapticFlowSource> source;
  source->SetFlow(vtkHapticFlowSource::DoubleGyre);
  source->UpdateInformation();
  vtkInformation* const info = source->GetOutputInformation(0);
  EXPECT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 201);
  source->SetFlow(vtkHapticFlowSource::ABC);
  source->UpdateInformation();
  EXPECT_FALSE(info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

TEST(FlowSource, ChangesFromImageToTetrahedraAndBack)
{
  vtkNew<vtkHapticFlowSource> source;
  for (const int cells : { 0, 1, 0 })
  {
    source->SetCells(cells);
    source->Update();
    EXPECT_EQ(source->GetOutputDataObject(0)->IsA("vtkImageData"), cells == 0);
  }
}
} // namespace

TEST(FlowSource, MoreTetrahedraThanAComputerHoldsAreRefusedInWords)
{
  vtkNew<vtkHapticFlowSource> source;
  source->SetCells(vtkHapticFlowSource::Tetrahedra);
  source->SetResolution(1024);
  const auto errors = palpate::testing::errorsOf(source);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front(), ::testing::HasSubstr("use a lower resolution"));
}
