// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkHapticConversion.h"
#include "vtkHapticStroke.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
std::vector<Vec3> pointsOf(vtkPolyData* data)
{
  std::vector<Vec3> points_W(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points_W.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points_W[i].data());
  }
  return points_W;
}

/// A strip of the plane z = height over y in [from, to] and x in [-1, 1].
void addStrip(TriangleMesh& mesh, double from, double to, double height)
{
  const auto base = static_cast<std::uint32_t>(mesh.vertices_W.size());
  for (const auto& [x, y] : { std::pair(-1.0, from), std::pair(1.0, from), std::pair(1.0, to), std::pair(-1.0, to) })
  {
    mesh.vertices_W.emplace_back(x, y, height);
  }
  mesh.triangles.push_back({ base, base + 1, base + 2 });
  mesh.triangles.push_back({ base, base + 2, base + 3 });
}
} // namespace

TEST(Stroke, LiesExactlyDepthUnderATiltedPlane)
{
  constexpr double tilt = 0.5;
  constexpr double depth = 0.25;
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(makePlane(10.0, tilt));
  stroke->SetDepth(depth);
  stroke->SetStep(0.1);
  stroke->SetWindow(0.0);
  stroke->SetLift(0.0);
  ASSERT_THAT(errorsOf(stroke), ::testing::IsEmpty());
  const Vec3 normal = Vec3(0.0, -tilt, 1.0).normalized();
  const std::vector<Vec3> points_W = pointsOf(stroke->GetOutput());
  ASSERT_GT(points_W.size(), 100u);
  for (const Vec3& p_W : points_W)
  {
    EXPECT_NEAR(p_W.dot(normal), -depth, 1e-12);
    EXPECT_NEAR(p_W.x(), 0.0, 1e-12);
  }
}

TEST(Stroke, StartsOutsideTheSurfaceAndCoversItsReach)
{
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(makePlane(10.0));
  stroke->SetReach(0.5);
  stroke->SetLift(4.0);
  ASSERT_THAT(errorsOf(stroke), ::testing::IsEmpty());
  const std::vector<Vec3> points_W = pointsOf(stroke->GetOutput());
  EXPECT_NEAR(points_W[0].z(), 4.0, 1e-12);
  EXPECT_NEAR(points_W[1].z(), -1.0, 1e-12);
  EXPECT_NEAR((points_W.back() - points_W[1]).norm(), 0.5 * 20.0, 1.0); // half of 20 u, to a step of 1 u
  EXPECT_EQ(stroke->GetOutput()->GetNumberOfLines(), 1);
  EXPECT_EQ(stroke->GetOutput()->GetPointData()->GetArray("Depth")->GetComponent(0, 0), -4.0);
}

TEST(Stroke, IsNeverAboveASphereHoweverItIsSmoothed)
{
  constexpr double radius = 50.0;
  constexpr double depth = 1.0;
  for (const double window : { 0.0, 5.0, 20.0 })
  {
    vtkNew<vtkHapticStroke> stroke;
    stroke->SetInputData(makeSphere(radius, 100));
    stroke->SetDepth(depth);
    stroke->SetWindow(window);
    stroke->SetLift(0.0);
    ASSERT_THAT(errorsOf(stroke), ::testing::IsEmpty());
    // Pushed in along the normal of the smoothed profile, which is that of the sphere at most `reach` further out:
    // two halves of the window (erosion and mean), a step for the secant, the depth for the push itself.
    const double reach = window + stroke->GetStep() + depth;
    for (const Vec3& p_W : pointsOf(stroke->GetOutput()))
    {
      const double here = std::asin(std::max(0.0, std::abs(p_W.y()) - reach) / radius);
      const double there = std::asin(std::min(1.0, (std::abs(p_W.y()) + reach) / radius));
      EXPECT_LT(p_W.norm(), radius - depth * std::cos(there - here)) << "window " << window;
    }
    double least[2];
    stroke->GetOutput()->GetPointData()->GetArray("Depth")->GetRange(least);
    EXPECT_GE(least[0], depth) << "window " << window;
  }
}

TEST(Stroke, DoesNotDependOnTheOrderOfTriangles)
{
  const auto sphere = vtkHapticToMesh(makeSphere(50.0, 40));
  TriangleMesh shuffled = *sphere.Mesh;
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), std::mt19937(7));
  vtkNew<vtkHapticStroke> plain;
  plain->SetInputData(vtkHapticToPolyData(*sphere.Mesh));
  plain->Update();
  vtkNew<vtkHapticStroke> other;
  other->SetInputData(vtkHapticToPolyData(shuffled));
  other->Update();
  EXPECT_EQ(pointsOf(plain->GetOutput()), pointsOf(other->GetOutput()));
}

TEST(Stroke, StaysOnTheLongestPartWithoutAGapOrACliff)
{
  TriangleMesh mesh;
  addStrip(mesh, -30.0, -20.0, 0.0);
  addStrip(mesh, -15.0, 10.0, 0.0);  // the longest
  addStrip(mesh, 10.5, 30.0, -20.0); // beyond a cliff
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(vtkHapticToPolyData(mesh));
  stroke->SetReach(1.0);
  stroke->SetLift(0.0);
  ASSERT_THAT(errorsOf(stroke), ::testing::IsEmpty());
  double bounds[6];
  stroke->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[2], -15.0, 1.0); // to a step of 1 u
  EXPECT_NEAR(bounds[3], 10.0, 1.0);
  EXPECT_DOUBLE_EQ(bounds[4], -1.0);
  EXPECT_DOUBLE_EQ(bounds[5], -1.0);
}

TEST(Stroke, FollowsTheOuterOfTwoLayers)
{
  TriangleMesh mesh;
  addStrip(mesh, -10.0, 10.0, 5.0);
  addStrip(mesh, -10.0, 10.0, 3.0);
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(vtkHapticToPolyData(mesh));
  stroke->SetLift(0.0);
  ASSERT_THAT(errorsOf(stroke), ::testing::IsEmpty());
  double bounds[6];
  stroke->GetOutput()->GetBounds(bounds);
  EXPECT_DOUBLE_EQ(bounds[4], 4.0);
  EXPECT_DOUBLE_EQ(bounds[5], 4.0);
}

TEST(Stroke, RefusesWhatItCannotStrokeWithAReason)
{
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(makePlane(10.0));
  const auto expectRefused = [&stroke](const char* reason)
  {
    stroke->Modified();
    const std::vector<std::string> errors = errorsOf(stroke);
    ASSERT_FALSE(errors.empty()) << reason;
    EXPECT_THAT(errors.front(), HasSubstr(reason));
    EXPECT_EQ(stroke->GetOutput()->GetNumberOfPoints(), 0);
  };
  stroke->SetStep(0.0);
  expectRefused("Step must be more than 0");
  stroke->SetStep(std::nan(""));
  expectRefused("Step must be more than 0");
  stroke->SetStep(1.0);
  stroke->SetDepth(-1.0);
  expectRefused("must be 0 or more");
  stroke->SetDepth(1.0);
  stroke->SetReach(2.0);
  expectRefused("Reach must be in (0, 1]");
  stroke->SetReach(0.5);
  stroke->SetAlong(0.0, 0.0, 3.0);
  expectRefused("not parallel");
  stroke->SetAlong(0.0, 1.0, 0.0);
  stroke->UseCentreOff();
  stroke->SetOrigin(100.0, 0.0, 0.0);
  expectRefused("cuts no part");
  stroke->UseCentreOn();
  stroke->SetInputData(makePath({ Vec3::Zero(), Vec3::Ones() }));
  expectRefused("no polygons");
}
