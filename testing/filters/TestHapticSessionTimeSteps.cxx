// SPDX-License-Identifier: GPL-3.0-or-later
// Time steps of a surface that is touched: the hand goes with its triangles, between the steps too. Virtual time.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "MovingPlate.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkCellArray.h"
#include "vtkHapticSession.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

TEST_F(HapticSessionMotion, TheHandGoesWithATimeSeriesOfTheSameTriangles)
{
  constexpr double stiffness = 100.0;
  const Vec3 hand_W(3.0, 20.0, -2.0);
  this->start(stiffness, makePlane(half, 0.1), nullptr, 5.0);
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 5.0);
  this->session_->Step(100);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(100);
  for (const double tilt : { 0.2, 0.4, 0.1, 0.4 }) // of z = tilt y, one time step after another and back
  {
    this->show(makePlane(half, tilt));
    ASSERT_TRUE(this->session_->FinishScene());
    EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("refitted"));
    this->session_->Step(ticksToSettle);
    const Vec3 normal = Vec3(0.0, -tilt, 1.0).normalized();
    const double depth_m = -normal.dot(hand_W) / scale;
    ASSERT_GT(depth_m, 0.0);
    EXPECT_LT((this->force() - stiffness * depth_m * normal).norm(), 1e-9) << "tilt " << tilt;
  }
}

TEST_F(HapticSessionMotion, BetweenTwoTimeStepsTheSurfaceIsFeltOnItsStraightWayInEveryTick)
{
  constexpr double stiffness = 100.0;
  constexpr int ticks = 50; // a time step at 20 Hz
  const Vec3 hand_W(3.0, 20.0, -2.0);
  this->start(stiffness, makePlane(half, 0.1), nullptr, 5.0);
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 5.0);
  this->session_->Step(100);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(ticksToSettle);
  this->show(makePlane(half, 0.1)); // the last one at rest: how long the first motion takes
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticks);
  double begin = 0.1;
  for (const double end : { 0.12, 0.2, 0.15, 0.15, 0.05 })
  {
    this->show(makePlane(half, end));
    ASSERT_TRUE(this->session_->FinishScene());
    for (int i = 1; i <= ticks; ++i)
    {
      this->session_->Step(1);
      const double tilt = begin + (end - begin) * i / ticks;
      const Vec3 normal = Vec3(0.0, -tilt, 1.0).normalized();
      const double depth_m = -normal.dot(hand_W) / scale;
      ASSERT_LT((this->force() - stiffness * depth_m * normal).norm(), 1e-9) << "to tilt " << end << ", tick " << i;
    }
    begin = end;
  }
  this->session_->Step(1200); // at rest for more than a second: the tree has no memory for motions any more
  this->session_->FinishScene();
  this->session_->Step(10);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  const Vec3 normal = Vec3(0.0, -begin, 1.0).normalized();
  EXPECT_LT((this->force() - stiffness * (-normal.dot(hand_W) / scale) * normal).norm(), 1e-9);
}

namespace
{
/// One frame of an actor that moves while its mesh deforms.
struct Frame
{
  double tilt = 0.0;      ///< its mesh is the plane z = tilt y
  double angle_rad = 0.0; ///< its actor is turned by about z
  Vec3 shift_W = Vec3::Zero();
};

vtkSmartPointer<vtkMatrix4x4> matrixOf(const Frame& frame)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const double c = std::cos(frame.angle_rad), s = std::sin(frame.angle_rad);
  const double turn[2][2] = { { c, -s }, { s, c } };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; row < 2 && column < 2; ++column)
    {
      matrix->SetElement(row, column, turn[row][column]);
    }
    matrix->SetElement(row, 3, frame.shift_W[row]);
  }
  return matrix;
}

/// Between two frames: everything evenly but the turn, which is that of the mean of two unit quaternions about z.
Frame between(const Frame& begin, const Frame& end, double share)
{
  const auto even = [share](const auto& a, const auto& b) { return (1.0 - share) * a + share * b; };
  const double half_rad = std::atan2(even(std::sin(begin.angle_rad / 2), std::sin(end.angle_rad / 2)),
    even(std::cos(begin.angle_rad / 2), std::cos(end.angle_rad / 2)));
  return { even(begin.tilt, end.tilt), 2 * half_rad, even(begin.shift_W, end.shift_W) };
}

/// On a resting hand [N].
Vec3 forceOf(const Frame& frame, double stiffness_N_per_m, const Vec3& hand_W)
{
  const Vec3 n = Vec3(0.0, -frame.tilt, 1.0).normalized();
  const double c = std::cos(frame.angle_rad), s = std::sin(frame.angle_rad);
  const Vec3 normal_W(c * n.x() - s * n.y(), s * n.x() + c * n.y(), n.z());
  return stiffness_N_per_m * normal_W.dot(frame.shift_W - hand_W) / scale * normal_W;
}
} // namespace

/// Whether a script has moved the actor before its mesh begins to deform.
class MovingActor
  : public HapticSessionMotion
  , public ::testing::WithParamInterface<bool>
{
};

TEST_P(MovingActor, WhoseMeshDeformsInTheSameFramesIsFeltUnderBothInEveryTick)
{
  constexpr double stiffness = 100.0;
  constexpr int ticks = 50; // a time step at 20 Hz
  const Vec3 hand_W(3.0, 20.0, -2.0);
  Frame begin{ 0.1, 0.2 }; // at the origin: the motion is that of W as baked, and turns about that
  this->start(stiffness, makePlane(half, begin.tilt), GetParam() ? nullptr : matrixOf(begin).Get(), 15.0);
  if (GetParam())
  {
    this->place(matrixOf(begin));
  }
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 15.0);
  this->session_->Step(300);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(300);
  this->show(makePlane(half, begin.tilt), matrixOf(begin)); // the last one at rest: how long the first motion takes
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticks);
  const Frame frames[] = { { 0.12, 0.3, { 2.5, 1.0, 0.8 } }, { 0.2, 0.7, { 1.0, 0.0, 1.5 } },
    { 0.15, 0.7, { 1.0, 0.0, 1.5 } }, { 0.15, 0.4, { 0.0, -2.0, 1.0 } }, { 0.05, -0.1, { 3.0, 0.0, 0.2 } } };
  for (const Frame& end : frames)
  {
    this->show(makePlane(half, end.tilt), matrixOf(end));
    ASSERT_TRUE(this->session_->FinishScene());
    for (int i = 1; i <= ticks; ++i)
    {
      this->session_->Step(1);
      const Vec3 expected = forceOf(between(begin, end, static_cast<double>(i) / ticks), stiffness, hand_W);
      ASSERT_LT((this->force() - expected).norm(), 1e-9) << "to angle " << end.angle_rad << ", tick " << i;
    }
    begin = end;
  }
  this->session_->Step(1200); // at rest for more than a second: poses are baked, and felt where they were
  this->session_->FinishScene();
  this->session_->Step(10);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  EXPECT_LT((this->force() - forceOf(begin, stiffness, hand_W)).norm(), 1e-9);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

INSTANTIATE_TEST_SUITE_P(ByAScript, MovingActor, ::testing::Bool());

TEST_F(HapticSessionMotion, ATimeSeriesOfPolygonsKeepsItsTriangles)
{
  const auto squares = [](double shear)
  {
    const vtkSmartPointer<vtkPolyData> surface = makePlane(half);
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell({ 0, 1, 2, 3 });
    surface->SetPolys(polygons);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      Vec3 p(surface->GetPoint(i));
      p.x() += shear * p.y();
      surface->GetPoints()->SetPoint(i, p.data());
    }
    return surface;
  };
  this->start(100.0, squares(0.4), nullptr, 5.0);
  this->show(squares(-0.4)); // its shorter diagonal is the other one
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("refitted"));
}

TEST_F(HapticSessionMotion, AnEmptyTimeStepLetsGoWithASentenceAndTheSurfaceComesBack)
{
  constexpr double stiffness = 100.0;
  this->start(stiffness, makePlane(half), nullptr, 1.0);
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  ASSERT_GT(this->force().z(), 0.1);
  this->session_->ClearSurfaces();
  vtkNew<vtkPolyData> empty;
  const auto errors =
    errorsOf(this->session_, [&] { EXPECT_FALSE(this->session_->AddSurface("plate", empty, nullptr)); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("plate: it has no polygons"));
  this->session_->CommitScene();
  EXPECT_FALSE(this->session_->FinishScene());
  EXPECT_TRUE(test::says(this->session_->GetSceneReport(), { "not touched: plate", "no polygons" }));
  this->session_->Step(60); // the ramp takes 50 ms
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  EXPECT_STRNE(this->session_->GetFaultText(), "");
  this->session_->SetHandPosition(0.0, 0.0, 1.0);
  this->session_->Step(10);
  this->show(makePlane(half));
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticksToEngage);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  EXPECT_NEAR(this->force().z(), stiffness * 2.0 / scale, 1e-9);
}
