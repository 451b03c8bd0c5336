// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud of points, felt as balls.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate::testing::clouds
{
namespace
{

using ::testing::HasSubstr;

constexpr double ballRadius = 10.0; // u
/// Where there are balls a point that touches is one too, of a thousandth of the thinnest.
constexpr double felt_N = stiffness * (depth + 1e-3 * ballRadius) / scale;

vtkSmartPointer<vtkPolyData> cloud(const std::vector<Vec3>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const Vec3& p : places)
  {
    const vtkIdType id = points->InsertNextPoint(p.data());
    vertices->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

void addArray(vtkDataSetAttributes* arrays, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  arrays->AddArray(array);
}

/// A fed hand in virtual time.
class HapticSessionPoints : public VirtualSession
{
};
} // namespace

TEST_F(HapticSessionPoints, EachIsABallOfTheRadiusThatWasSet)
{
  this->session_->SetSetting("PointRadius", ballRadius);
  this->show(cloud({ Vec3(0, 0, 0), Vec3(50, 0, 0) }));
  test::Random random(test::testSeed(81));
  for (std::size_t i = 0; i < test::testCount(10); ++i)
  {
    const Vec3 centre_W = i % 2 == 0 ? Vec3(0, 0, 0) : Vec3(50, 0, 0);
    const Vec3 out_W = random.direction();
    const Vec3 outside_W = centre_W + (ballRadius + 1.0) * out_W, inside_W = centre_W + (ballRadius - depth) * out_W;
    this->session_->SetHandPosition(outside_W.data());
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->session_->SetHandPosition(inside_W.data());
    this->session_->Step(100);
    const Vec3 expected_N = felt_N * out_W;
    EXPECT_NEAR((Vec3(this->session_->GetForce()) - expected_N).norm(), 0.0, 1e-5 * expected_N.norm()) << i;
    this->session_->TouchingOff();
  }
}

TEST_F(HapticSessionPoints, WithoutARadiusACloudIsRefusedAndWithOneItMovesWithItsMatrix)
{
  const auto points = cloud({ Vec3(0, 0, 0) });
  const auto errors = errorsOf(static_cast<vtkObject*>(this->session_),
    [&] { EXPECT_FALSE(this->session_->AddSurface("cloud", points, nullptr)); });
  EXPECT_EQ(errors.size(), 1u);
  this->session_->SetSetting("PointRadius", ballRadius);
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 100.0);
  this->session_->ClearSurfaces();
  ASSERT_TRUE(this->session_->AddSurface("cloud", points, up)) << this->session_->GetProblem();
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  double bounds[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(bounds));
  EXPECT_NEAR(bounds[4], 100.0 - ballRadius, 1e-4);
  EXPECT_NEAR(bounds[5], 100.0 + ballRadius, 1e-4);
}

TEST_F(HapticSessionPoints, BesidePolygonsBothAreTouched)
{
  this->session_->SetSetting("PointRadius", ballRadius);
  const auto plane = makePlane(100.0);
  const auto points = cloud({ Vec3(0, 0, 30) });
  this->session_->ClearSurfaces();
  ASSERT_TRUE(this->session_->AddSurface("plane", plane, nullptr));
  ASSERT_TRUE(this->session_->AddSurface("cloud", points, nullptr));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("cloud (points)"));
  this->session_->SetHandPosition(0.0, 0.0, 45.0);
  this->startTouching();
  this->session_->Step(ticksToEngage);
  this->session_->SetHandPosition(0.0, 0.0, 30.0 + ballRadius - depth);
  this->session_->Step(100);
  EXPECT_NEAR(this->session_->GetForce()[2], felt_N, 1e-5 * felt_N);
}

TEST_F(HapticSessionPoints, EachIsAsStiffAsItsPointOrItsCellSaysAndAChangedArrayIsFelt)
{
  const auto points = cloud({ Vec3(0, 0, 0), Vec3(50, 0, 0), Vec3(100, 0, 0) });
  addArray(points->GetPointData(), "ofPoints", { 1.0, 2.0, 3.0 });
  addArray(points->GetCellData(), "ofCells", { 3.0, 1.0, 2.0 });
  this->session_->SetSetting("PointRadius", ballRadius);
  this->session_->SetSetting("StiffnessDataRange", 1.0, 3.0);
  this->session_->SetSetting("StiffnessFeltRange", 100.0, 300.0); // N/m, so a value of 1 is 100 N/m
  const auto pressed = [&](double x)
  {
    this->session_->SetHandPosition(x, 0.0, ballRadius + 1.0);
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->session_->SetHandPosition(x, 0.0, ballRadius - depth);
    this->session_->Step(100);
    const double force_N = this->session_->GetForce()[2];
    this->session_->TouchingOff();
    return force_N;
  };
  const double softest_N = 100.0 / stiffness * felt_N;
  this->session_->SetSetting("StiffnessArray", "ofPoints");
  this->show(points);
  for (const double value : { 1.0, 2.0, 3.0 })
  {
    EXPECT_NEAR(pressed(50.0 * (value - 1.0)), value * softest_N, 1e-4 * softest_N) << value;
  }
  this->session_->SetSetting("StiffnessArray", "ofCells");
  this->show(points);
  for (const auto& [x, value] : { std::pair{ 0.0, 3.0 }, std::pair{ 50.0, 1.0 }, std::pair{ 100.0, 2.0 } })
  {
    EXPECT_NEAR(pressed(x), value * softest_N, 1e-4 * softest_N) << x;
  }
  points->GetCellData()->GetArray("ofCells")->SetComponent(0, 0, 2.0);
  points->GetCellData()->Modified();
  this->show(points);
  EXPECT_NEAR(pressed(0.0), 2.0 * softest_N, 1e-4 * softest_N);
}

} // namespace palpate::testing::clouds
