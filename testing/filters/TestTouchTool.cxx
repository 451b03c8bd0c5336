// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid tool along a path of the hand. Judges: F = K (tool - hand) / scale, and that a torque is a lever times a
// force.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SoftBlockPush.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTouchAlongPath.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double stiffness_N_per_m = 400.0, scale_u_per_m = 50.0;
constexpr double side = 2.0; // of the cube

/// A cube whose middle is so far from where it is held.
vtkSmartPointer<vtkPolyData> cubeHeldAt(const Vec3& middle)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(side);
  cube->SetYLength(side);
  cube->SetZLength(side);
  cube->SetCenter(middle.x(), middle.y(), middle.z());
  cube->Update();
  return cube->GetOutput();
}

/// Its diagonal sets the gap at which it rests.
const double gap = 2e-7 * side * std::sqrt(3.0);

vtkSmartPointer<vtkPolyData> floorAtZero()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, 0.0);
  plane->SetPoint1(20.0, -20.0, 0.0);
  plane->SetPoint2(-20.0, 20.0, 0.0);
  plane->SetResolution(7, 9);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkTouchAlongPath> touchWith(vtkPolyData* tool, const std::vector<Vec3>& points_W)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputData(floorAtZero());
  touch->SetPathData(makePath(points_W));
  touch->SetToolData(tool);
  touch->SetSetting("Stiffness", stiffness_N_per_m);
  touch->SetSetting("Scale", scale_u_per_m);
  return touch;
}

Vec3 vectorAt(vtkTouchAlongPath& touch, const char* array, vtkIdType row)
{
  Vec3 value;
  touch.GetOutput()->GetPointData()->GetArray(array)->GetTuple(row, value.data());
  return value;
}

Quat turnAt(vtkTouchAlongPath& touch, vtkIdType row)
{
  double q[4];
  touch.GetOutput()->GetPointData()->GetArray("Turn")->GetTuple(row, q);
  return { q[0], q[1], q[2], q[3] };
}

void addTurns(vtkPolyData* path, const std::vector<Quat>& turns)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("turn");
  array->SetNumberOfComponents(4);
  for (const Quat& q : turns)
  {
    array->InsertNextTuple4(q.w(), q.x(), q.y(), q.z());
  }
  path->GetPointData()->AddArray(array);
}

/// The filter's error in place of a touch.
std::string problemOf(vtkTouchAlongPath& touch)
{
  const std::vector<std::string> problems = errorsOf(&touch);
  EXPECT_EQ(touch.GetOutput()->GetNumberOfPoints(), 0);
  return problems.empty() ? "" : problems.front();
}
} // namespace

TEST(TouchTool, ACubeThatIsLedIntoAFloorLiesOnItAndPushesByTheDepthOfTheHand)
{
  const double half = side / 2.0;
  std::vector<Vec3> hand{ Vec3(0.3, 0.2, half + 0.5) };
  for (int i = 0; i <= 20; ++i)
  {
    hand.push_back(Vec3(0.3 + 0.05 * i, 0.2, half - 0.1 - 0.02 * i)); // it slides and goes deeper
  }
  const auto touch = touchWith(cubeHeldAt(Vec3::Zero()), hand);
  touch->Update();
  ASSERT_EQ(touch->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(hand.size()));
  EXPECT_EQ(vectorAt(*touch, "Force", 0), Vec3(Vec3::Zero()));
  for (std::size_t i = 1; i < hand.size(); ++i)
  {
    const Vec3 place(hand[i].x(), hand[i].y(), half + gap);
    const Vec3 found(touch->GetOutput()->GetPoint(static_cast<vtkIdType>(i)));
    EXPECT_LT((found - place).norm(), gap) << i;
    const Vec3 force_N = stiffness_N_per_m * (place - hand[i]) / scale_u_per_m;
    EXPECT_LT(
      (vectorAt(*touch, "Force", static_cast<vtkIdType>(i)) - force_N).norm(), stiffness_N_per_m * gap / scale_u_per_m);
    EXPECT_LT(vectorAt(*touch, "Torque", static_cast<vtkIdType>(i)).norm(), 1e-9) << "pushed at its middle";
    EXPECT_GE(
      touch->GetOutput()->GetPointData()->GetArray("Contacts")->GetComponent(static_cast<vtkIdType>(i), 0), 1.0);
  }
}

TEST(TouchTool, HeldBesideItTipsAndTheTorqueIsTheLeverOfTheEdgeThatTouchesTimesItsForce)
{
  const double away = 5.0, half = side / 2.0;
  const auto touch = touchWith(cubeHeldAt(Vec3(away, 0.0, 0.0)), { Vec3(0, 0, half + 0.5), Vec3(0, 0, half - 0.4) });
  touch->Update();
  const Vec3 force_N = vectorAt(*touch, "Force", 1), torque = vectorAt(*touch, "Torque", 1);
  ASSERT_GT(force_N.z(), 0.0);
  EXPECT_LT(force_N.head<2>().norm(), 1e-9 * force_N.z()) << "a floor pushes up";
  // It is lifted by the hand's side of its lower face: the corner of the tipped cube that is lowest.
  const Quat turn = turnAt(*touch, 1);
  const Vec3 handle(touch->GetOutput()->GetPoint(1));
  Vec3 lowest(0, 0, 1e9);
  for (const double x : { away - half, away + half })
  {
    const Vec3 corner = handle + turn * Vec3(x, half, -half);
    lowest = corner.z() < lowest.z() ? corner : lowest;
  }
  EXPECT_NEAR(lowest.z(), gap, 0.1 * gap);
  EXPECT_GT(touch->GetOutput()->GetPointData()->GetArray("Angle")->GetComponent(1, 0), 0.1) << "it does tip";
  const double lever_m = (lowest.x() - handle.x()) / scale_u_per_m;
  EXPECT_NEAR(torque.y(), -lever_m * force_N.z(), 1e-6 * std::abs(torque.y()));
  EXPECT_NEAR(torque.x(), 0.0, 1e-9);
}

TEST(TouchTool, TheLeverIsTheRootOfTwoThirdsOfTheMeanSquareUnlessItIsGiven)
{
  // Of the faces of a cube about its middle: each has z^2 = 1 and x^2 + y^2 with the mean 2 (1/3), so |p|^2 has 5/3.
  const double own_u = std::sqrt(2.0 / 3.0 * 5.0 / 3.0);
  const double angle = 0.05;
  for (const double characteristic_u : { 0.0, own_u, 3.0 })
  {
    const auto touch = touchWith(cubeHeldAt(Vec3::Zero()), { Vec3(0, 0, 3), Vec3(0, 0, 0.5) });
    addTurns(vtkPolyData::SafeDownCast(touch->GetInputDataObject(1, 0)),
      { Quat::Identity(), Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())) });
    touch->SetTurnArray("turn");
    touch->SetSetting("ToolLever", characteristic_u);
    touch->Update();
    const double left =
      2.0 * std::acos(std::min(1.0, std::abs(turnAt(*touch, 1).w()))); // flat: all of the turn is spring
    const double used_u = characteristic_u > 0.0 ? characteristic_u : own_u;
    const double torque_Nm = stiffness_N_per_m * used_u * used_u * (angle - left) / (scale_u_per_m * scale_u_per_m);
    EXPECT_NEAR(vectorAt(*touch, "Torque", 1).norm(), torque_Nm, 1e-6 * torque_Nm) << characteristic_u;
  }
}

TEST(TouchTool, WhatCannotBeDoneIsSaidInWords)
{
  const std::vector<Vec3> free{ Vec3(0, 0, 3), Vec3(0, 0, 2) };
  const auto inside = touchWith(cubeHeldAt(Vec3::Zero()), { Vec3(0, 0, 0.5), Vec3(0, 0, 3) });
  EXPECT_THAT(problemOf(*inside), HasSubstr("start at a free position"));
  const auto far = touchWith(cubeHeldAt(Vec3(100.0, 0.0, 0.0)), free);
  EXPECT_THAT(problemOf(*far), HasSubstr("the handle lies far outside"));
  const auto unturned = touchWith(cubeHeldAt(Vec3::Zero()), free);
  unturned->SetTurnArray("turn");
  EXPECT_TRUE(test::says(problemOf(*unturned), { "point", "'turn'", "numbers" }));
  const auto tooLong = touchWith(cubeHeldAt(Vec3::Zero()), free);
  addTurns(vtkPolyData::SafeDownCast(tooLong->GetInputDataObject(1, 0)), { Quat(1, 0, 0, 0), Quat(2, 0, 0, 0) });
  tooLong->SetTurnArray("turn");
  EXPECT_THAT(problemOf(*tooLong), HasSubstr("unit quaternion at point 1"));
  const auto ball = touchWith(cubeHeldAt(Vec3::Zero()), free);
  ball->SetSetting("Radius", 1.0);
  EXPECT_THAT(problemOf(*ball), HasSubstr("Radius has no effect on a tool"));
  const auto lever = touchWith(cubeHeldAt(Vec3::Zero()), free);
  lever->SetSetting("ToolLever", -1.0);
  EXPECT_THAT(problemOf(*lever), HasSubstr("Lever: "));
}

TEST(TouchTool, OnABodyThatGivesWayAMeshBallIsPushedAsABallIsAndAnOpenMeshIsRefused)
{
  constexpr double bodySide = 5.0, ball = 1.5, deep = 0.05; // 100 mm, 30 mm, 1 mm
  std::vector<Vec3> hand{ Vec3(0.1, 0.05, ball + 0.05) };
  for (int i = 0; i < 400; ++i) // at rest from a quarter of them on
  {
    hand.push_back(Vec3(0.1, 0.05, ball + 0.05 - (0.05 + deep) * std::min(1.0, i / 100.0)));
  }
  const auto touch = touchWith(cubeHeldAt(Vec3::Zero()), hand);
  touch->SetInputData(makeSoftBlock(bodySide, 1.0 / scale_u_per_m));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(ball);
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(80);
  sphere->Update();
  touch->SetToolData(sphere->GetOutput());
  touch->Update();
  const auto last = static_cast<vtkIdType>(hand.size()) - 1;
  ASSERT_EQ(touch->GetOutput()->GetNumberOfPoints(), last + 1);
  EXPECT_NE(touch->GetOutput()->GetPointData()->GetArray("Angle"), nullptr);
  const double byMesh_N = vectorAt(*touch, "Force", last).z();
  vtkNew<vtkPlaneSource> open;
  touch->SetToolConnection(open->GetOutputPort());
  EXPECT_TRUE(test::says(problemOf(*touch), { "the tool", "cannot be held", "open" }));

  touch->SetToolConnection(nullptr);
  touch->SetSetting("Radius", ball);
  touch->SetSetting("SoftRate", 0.0);
  touch->SetPathData(makePath({ hand.front(), hand.back() }));
  touch->Update();
  ASSERT_EQ(touch->GetOutput()->GetNumberOfPoints(), 2);
  const double byBall_N = vectorAt(*touch, "Force", 1).z();
  const double push_N = pushOfSoftBlock_N(ball / scale_u_per_m, deep / scale_u_per_m, stiffness_N_per_m);
  EXPECT_NEAR(byBall_N, push_N, offLayer * push_N);
  EXPECT_NEAR(byMesh_N, byBall_N, 0.02 * byBall_N);
}
