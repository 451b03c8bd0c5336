// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace
{
Vec3 vectorAt(vtkPolyData* output, const char* array, vtkIdType i)
{
  Vec3 value;
  output->GetPointData()->GetArray(array)->GetTuple(i, value.data());
  return value;
}

double numberAt(vtkPolyData* output, const char* array, vtkIdType i)
{
  return output->GetPointData()->GetArray(array)->GetComponent(i, 0);
}

/// Straight from one point to another in n ticks.
std::vector<Vec3> straight(const Vec3& from_W, const Vec3& to_W, int n)
{
  std::vector<Vec3> points_W;
  for (int i = 0; i <= n; ++i)
  {
    points_W.push_back(from_W + (static_cast<double>(i) / n) * (to_W - from_W));
  }
  return points_W;
}

/// A plane and a path into it, ready to run.
vtkSmartPointer<vtkTouchAlongPath> touchPlane(const std::vector<Vec3>& points_W)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputData(makePlane(10.0));
  touch->SetPathData(makePath(points_W));
  return touch;
}
} // namespace

TEST(TouchAlongPath, ForceOnAPlaneIsStiffnessTimesDepth)
{
  constexpr double stiffness = 750.0;
  const std::vector<Vec3> path_W = straight(Vec3(1.0, 2.0, 0.5), Vec3(1.5, -2.0, -0.5), 200);
  const auto touch = touchPlane(path_W);
  touch->SetSetting("Stiffness", stiffness);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  vtkPolyData* output = touch->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), static_cast<vtkIdType>(path_W.size()));
  for (std::size_t i = 0; i < path_W.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    const double depth = std::max(0.0, -path_W[i].z());
    EXPECT_LT((vectorAt(output, "Force", row) - Vec3(0.0, 0.0, stiffness * depth)).norm(), 1e-12 * stiffness) << i;
    EXPECT_NEAR(numberAt(output, "Depth", row), depth, 1e-12) << i;
    EXPECT_EQ(numberAt(output, "Contacts", row), depth > 1e-12 ? 1.0 : 0.0) << i;
    EXPECT_EQ(vectorAt(output, "Device", row), path_W[i]) << i;
    EXPECT_DOUBLE_EQ(numberAt(output, "Time", row), static_cast<double>(i) / 1000.0) << i;
  }
}

TEST(TouchAlongPath, MoreSegmentsThanCanBeFeltAreRefusedAsInASession)
{
  const auto touch = touchPlane({ Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0) });
  touch->SetInputData(makePath(straight(Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), 4000001)));
  touch->SetSetting("LineRadius", 0.01);
  EXPECT_THAT(errorsOf(touch), ::testing::Contains(HasSubstr("its lines have 4000001 segments; at most 4000000")));
}

TEST(TouchAlongPath, ForceShadingTurnsTheForceOnAFacetedSphereToItsRadius)
{
  constexpr double radius = 50.0;
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(radius, 24); // its corners lie on the sphere
  const auto mostOff = [&](bool shading)
  {
    std::vector<Vec3> path_W{ Vec3(1.2 * radius, 0.0, 0.0) };
    for (int i = 0; i <= 2000; ++i)
    {
      const double a = 1e-3 * i;
      path_W.push_back((radius - 1.0) * Vec3(std::cos(a), std::sin(a), 0.1).normalized());
    }
    vtkNew<vtkTouchAlongPath> touch;
    touch->SetInputData(sphere);
    touch->SetPathData(makePath(path_W));
    touch->SetSetting("ForceShading", shading);
    touch->Update();
    double off = 0.0;
    for (std::size_t i = 5; i < path_W.size(); ++i) // it lands unshaded
    {
      const Vec3 force_W = vectorAt(touch->GetOutput(), "Force", static_cast<vtkIdType>(i));
      off = std::max(off, force_W.cross(path_W[i]).norm() / (force_W.norm() * path_W[i].norm()));
    }
    return off;
  };
  EXPECT_LT(mostOff(true), 1e-4);
  EXPECT_GT(mostOff(false), 0.05); // half of the 7.5 degrees between faces, and more
}

TEST(TouchAlongPath, ForceOnASphereIsThatOfTheFaceTheHandIsBehind)
{
  constexpr double radius = 50.0;
  constexpr double depth = 1.0;
  const Vec3 direction = Vec3(0.31, -0.52, 0.44).normalized();
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(radius, 60);
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(sphere);
  touch->SetPathData(makePath(straight((radius + 1.0) * direction, (radius - depth) * direction, 50)));
  touch->SetSetting("Stiffness", 1.0);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  const vtkIdType last = touch->GetOutput()->GetNumberOfPoints() - 1;
  const Vec3 force = vectorAt(touch->GetOutput(), "Force", last);
  const Vec3 hand_W = vectorAt(touch->GetOutput(), "Device", last);
  // From inside a convex solid every nearest point of the outside is the foot on a face: find the face, by its plane.
  double nearest = std::numeric_limits<double>::infinity();
  double leastDistance = radius; // of a face from the centre: the tessellation lies between this and the radius
  const auto mesh = vtkHapticToMesh(sphere);
  for (const auto& [a, b, c] : mesh.Mesh->triangles)
  {
    const Vec3& p = mesh.Mesh->vertices_W[a];
    const Vec3 n = (mesh.Mesh->vertices_W[b] - p).cross(mesh.Mesh->vertices_W[c] - p).normalized();
    nearest = std::min(nearest, (force - n.dot(p - hand_W) * n).norm());
    leastDistance = std::min(leastDistance, n.dot(p));
  }
  EXPECT_LT(nearest, 1e-12 * radius);
  EXPECT_LE(force.norm(), depth + 1e-12);
  EXPECT_GE(force.norm(), depth - (radius - leastDistance));
}

TEST(TouchAlongPath, PointsWithoutLinesAreTakenInTheirOrder)
{
  const vtkSmartPointer<vtkPolyData> path = makePath(straight(Vec3(0, 0, 1), Vec3(0, 0, -1), 10));
  path->SetLines(nullptr);
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlane(10.0));
  touch->SetPathData(path);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_NEAR(vectorAt(touch->GetOutput(), "Force", 10).z(), 1000.0, 1e-9);
}

/// A plane, touched at these times.
vtkSmartPointer<vtkTouchAlongPath> touchAt(const std::vector<double>& times_s)
{
  const int steps = static_cast<int>(times_s.size()) - 1;
  const vtkSmartPointer<vtkPolyData> path = makePath(straight(Vec3(0, 0, 1), Vec3(0, 0, -1), steps));
  vtkNew<vtkDoubleArray> times;
  times->SetName("t");
  for (const double t_s : times_s)
  {
    times->InsertNextValue(t_s);
  }
  path->GetPointData()->AddArray(times);
  const auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputData(makePlane(10.0));
  touch->SetPathData(path);
  touch->SetTimeArray("t");
  return touch;
}

TEST(TouchAlongPath, TimesComeFromTheNamedArray)
{
  const auto touch = touchAt({ 0.5, 0.75, 2.0, 2.125 });
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_EQ(numberAt(touch->GetOutput(), "Time", 2), 2.0);
}

TEST(TouchAlongPath, AnAbortLeavesAnEmptyOutput)
{
  const auto touch = touchPlane(straight(Vec3(0, 0, 1), Vec3(0, 0, -1), 5000));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*) { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  touch->AddObserver(vtkCommand::ProgressEvent, stop);
  touch->Update();
  EXPECT_EQ(touch->GetOutput()->GetNumberOfPoints(), 0);
}

namespace
{
void expectRefused(vtkTouchAlongPath* touch, const char* reason)
{
  touch->Modified();
  const std::vector<std::string> errors = errorsOf(touch);
  ASSERT_FALSE(errors.empty()) << reason;
  EXPECT_THAT(errors.front(), HasSubstr(reason));
  EXPECT_EQ(touch->GetOutput()->GetNumberOfPoints(), 0) << reason;
}
} // namespace

TEST(TouchAlongPath, NumbersThatCannotBeAreRefused)
{
  const auto touch = touchPlane({ Vec3(0, 0, 1), Vec3(0, 0, -1) });
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    touch->SetSetting("LineRadius", bad);
    expectRefused(touch, "LineRadius: ");
    touch->SetSetting("LineRadius", 0.0);
    touch->SetRate(bad);
    expectRefused(touch, "Rate: ");
    touch->SetRate(1000.0);
  }
  EXPECT_THAT(errorsOf(touch), IsEmpty());
}

TEST(TouchAlongPath, TwoConnectionsAreTwoSurfaces)
{
  const auto touch = touchPlane({ Vec3(1, 2, 1), Vec3(1, 2, -0.5) });
  touch->AddNamed(0, "other", makePlane(0.0)); // all corners in one point
  expectRefused(touch, "cannot be touched");
  touch->RemoveInputConnection(0, 1);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  touch->AddInputData(0, makePlane(5.0));
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((vectorAt(touch->GetOutput(), "Force", 1) - Vec3(0.0, 0.0, 500.0)).norm(), 1e-9);
}

TEST(TouchAlongPath, PathsThatCannotBeFollowedAreRefused)
{
  const auto touch = touchPlane({ Vec3(0, 0, 1), Vec3(0, std::nan(""), -1) });
  expectRefused(touch, "not finite at point 1");
  touch->SetPathData(vtkSmartPointer<vtkPolyData>::New());
  expectRefused(touch, "no points");

  const vtkSmartPointer<vtkPolyData> two = makePath({ Vec3(0, 0, 1), Vec3(0, 0, -1) });
  two->GetLines()->InsertNextCell({ 1, 0 });
  touch->SetPathData(two);
  expectRefused(touch, "2 lines");

  touch->SetPathData(makePath({ Vec3(0, 0, 1), Vec3(0, 0, -1) }));
  touch->SetTimeArray("nowhere");
  expectRefused(touch, "no point array 'nowhere'");
}

TEST(TouchAlongPath, TimeThatStandsStillIsRefused)
{
  expectRefused(touchAt({ 0.0, 1.0, 1.0 }), "does not increase at point 2");
}

TEST(TouchAlongPath, SurfacesThatCannotBeTouchedAreRefused)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetPathData(makePath({ Vec3(0, 0, 1), Vec3(0, 0, -1) }));
  touch->SetInputData(makePath({ Vec3(0, 0, 1), Vec3(0, 0, -1) }));
  expectRefused(touch, "no polygons");
  touch->SetInputData(makePlane(0.0)); // all corners in one point
  expectRefused(touch, "the surface: cannot be touched");
  const vtkSmartPointer<vtkPolyData> broken = makePlane(1.0);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    broken->GetPoints()->SetPoint(i, std::nan(""), 0.0, 0.0);
  }
  touch->SetInputData(broken);
  expectRefused(touch, "the surface: cannot be touched");
}
