// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of wall thickness and curvature, on slabs and balls, whose thickness and curvature are known.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Meshes.h"
#include "testing/support/Says.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticSurfaceMap.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkTriangleFilter.h"

namespace palpate::testing::mapped
{
namespace
{

constexpr double side = 10.0;      // u
constexpr double thickness = 0.75; // u

vtkSmartPointer<vtkPolyData> slab()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(side);
  cube->SetYLength(side);
  cube->SetZLength(thickness);
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(triangles->GetOutputPort());
  finer->SetNumberOfSubdivisions(4);
  finer->Update();
  return finer->GetOutput();
}

vtkSmartPointer<vtkPolyData> turned(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

vtkPolyData* map(vtkHapticSurfaceMap* filter, vtkPolyData* surface, int quantity, const Vec3& centre, double radius)
{
  filter->SetInputData(surface);
  filter->SetQuantity(quantity);
  filter->SetCentre(centre.x(), centre.y(), centre.z());
  filter->SetRadius(radius);
  filter->Update();
  return filter->GetOutput();
}

TEST(SurfaceMap, OfASlabIsItsThicknessOnTheTouchedSideWithinTheRadiusAndNowhereElse)
{
  const auto whole = slab(), inwards = turned(whole);
  const Vec3 centre(0.5, -0.25, 0.5 * thickness);
  const double radius = 3.0, edge = std::sqrt(2.0) * side / 16.0; // the longest of a triangle
  for (vtkPolyData* surface : { whole.Get(), inwards.Get() })
  {
    vtkNew<vtkHapticSurfaceMap> filter;
    vtkPolyData* const mapped = map(filter, surface, vtkHapticSurfaceMap::Thickness, centre, radius);
    ASSERT_EQ(mapped->GetNumberOfPoints(), surface->GetNumberOfPoints());
    ASSERT_TRUE(mapped->GetPointData()->GetScalars());
    EXPECT_STREQ(mapped->GetPointData()->GetScalars()->GetName(), "Thickness");
    int known = 0;
    for (vtkIdType i = 0; i < mapped->GetNumberOfPoints(); ++i)
    {
      const Vec3 p(mapped->GetPoint(i));
      const double value = mapped->GetPointData()->GetScalars()->GetComponent(i, 0);
      const double distance = (p - centre).norm();
      if (p.z() < centre.z() || distance > radius + edge)
      {
        EXPECT_TRUE(std::isnan(value)) << p.transpose(); // the far wall is 0.75 u away
      }
      else if (distance < radius)
      {
        EXPECT_NEAR(value, thickness, 1e-12) << p.transpose();
        ++known;
      }
    }
    EXPECT_GT(known, 50);
    EXPECT_TRUE(test::says(filter->GetText(), { "Wall thickness", "within 3 u", "0.75 to 0.75 u" }));
  }
}

/// The largest error of the mean curvature, times the radius, and of the thickness in radii, over a whole ball.
std::pair<double, double> worstOnBall(int levels, double radius, bool inwards)
{
  auto ball = vtkHapticToPolyData(test::makeIcosphere(levels, radius));
  ball = inwards ? turned(ball) : ball;
  double curvature = 0.0, through = 0.0;
  for (const int quantity : { vtkHapticSurfaceMap::Curvature, vtkHapticSurfaceMap::Thickness })
  {
    vtkNew<vtkHapticSurfaceMap> filter;
    vtkPointData* const arrays = map(filter, ball, quantity, Vec3(0, 0, radius), 3.0 * radius)->GetPointData();
    for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
    {
      const double value = arrays->GetScalars()->GetComponent(i, 0);
      EXPECT_FALSE(std::isnan(value)) << i;
      double& worst = quantity == vtkHapticSurfaceMap::Curvature ? curvature : through;
      worst = std::max(worst,
        quantity == vtkHapticSurfaceMap::Curvature ? std::abs(value * radius - 1.0) : std::abs(value / radius - 2.0));
    }
  }
  return { curvature, through };
}

TEST(SurfaceMap, OfABallGoesToOneOverItsRadiusAndToItsDiameterWithTheSquareOfTheTriangles)
{
  for (const double radius : { 1e-6, 1.0, 1e6 })
  {
    const auto coarse = worstOnBall(3, radius, false), fine = worstOnBall(4, radius, false);
    EXPECT_LT(fine.first, 0.4 * coarse.first);
    EXPECT_LT(fine.second, 0.4 * coarse.second);
    EXPECT_LT(fine.first, 0.02); // edges of about 0.08 rad: the fit errs by their square
    EXPECT_LT(fine.second, 0.02);
  }
  EXPECT_LT(worstOnBall(4, 1.0, true).first, 0.02) << "a bulge seen from outside, though turned inwards";
}

TEST(SurfaceMap, OfAnOpenSurfaceSaysThatThereIsNoWall)
{
  vtkNew<vtkHapticSurfaceMap> filter;
  const auto plane = makePlane(5.0);
  map(filter, plane, vtkHapticSurfaceMap::Thickness, Vec3::Zero(), 1.0);
  EXPECT_TRUE(test::says(filter->GetText(), { "no wall" }));
  map(filter, plane, vtkHapticSurfaceMap::Curvature, Vec3::Zero(), 1.0);
  EXPECT_TRUE(test::says(filter->GetText(), { "Mean curvature", "0 to 0 1/u" }));
}

TEST(SurfaceMap, FarFromTheSurfaceIsRefusedWithTheRemedy)
{
  vtkNew<vtkHapticSurfaceMap> filter;
  filter->SetInputData(slab());
  filter->SetCentre(0.0, 0.0, 50.0);
  const auto errors = errorsOf(filter);
  ASSERT_FALSE(errors.empty());
  EXPECT_TRUE(test::says(errors.front(), { "no point", "(0, 0, 50)", "set Centre" }));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_STREQ(filter->GetText(), "");
}

} // namespace
} // namespace palpate::testing::mapped
