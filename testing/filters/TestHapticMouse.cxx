// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticMouseTest.h"

#include <algorithm>

#include "vtkCubeSource.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{
struct Facet
{
  Vec3 middle;
  Vec3 normal;
};

Facet facetOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  Vec3 p[3];
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoint(ids->GetId(i), p[i].data());
  }
  return { (p[0] + p[1] + p[2]) / 3.0, (p[1] - p[0]).cross(p[2] - p[0]).normalized() };
}

/// With and without perspective, looking down on the scene at a slant.
class HapticMouseInBothViews
  : public HapticMouse
  , public ::testing::WithParamInterface<bool>
{
protected:
  void lookDown() { this->look(Vec3(60, -200, 250), this->GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Views, HapticMouseInBothViews, ::testing::Bool());
} // namespace

TEST_P(HapticMouseInBothViews, ItsRayIsTheCamerasByTheFormula)
{
  this->show(makePlane(100.0));
  this->lookDown();
  for (const auto& [x_px, y_px] : { std::pair{ 200.0, 150.0 }, { 0.0, 0.0 }, { 390.0, 20.0 }, { 57.0, 211.0 } })
  {
    Vec3 near_W, far_W;
    this->mouse_->SetPointer(x_px, y_px);
    ASSERT_TRUE(this->mouse_->GetRay(near_W.data(), far_W.data()));
    EXPECT_LT(this->ray(x_px, y_px).distanceTo(near_W), 1e-9);
    EXPECT_LT(this->ray(x_px, y_px).distanceTo(far_W), 1e-9);
    EXPECT_GT((far_W - near_W).dot(this->ray(x_px, y_px).along), 0.0);
  }
}

// The cube lies on the plane, its middle half a side above it: pressed by as much as the ball would be.
TEST_P(HapticMouseInBothViews, AToolThatIsHeldIsPressedAsDeepAsTheBallWouldBe)
{
  this->show(makePlane(100.0));
  this->lookDown();
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(10.0);
  cube->SetYLength(10.0);
  cube->SetZLength(10.0);
  cube->Update();
  this->session_->SetSetting("ToolSource", "Cube1");
  ASSERT_TRUE(this->session_->AddTool("Cube1", cube->GetOutput()));
  this->engage();
  this->press(170.0, 140.0);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->session_->GetForce()[2], force_N, 1e-3 * force_N);
  EXPECT_NEAR(this->session_->GetProxyPosition()[2], 5.0, 1e-3);
}

// F = K d n, and the proxy is the point of the plane z = 0 under the pointer.
TEST_P(HapticMouseInBothViews, PressingOnAPlanePushesWithStiffnessTimesDepth)
{
  this->show(makePlane(100.0));
  this->lookDown();
  this->engage();
  for (const auto& [x_px, y_px] : { std::pair{ 200.0, 150.0 }, { 230.0, 170.0 }, { 150.0, 120.0 } })
  {
    this->press(x_px, y_px);
    EXPECT_LT((this->proxy() - this->ray(x_px, y_px).atHeight(0.0)).norm(), 1e-9);
    EXPECT_LT((this->force() - force_N * Vec3::UnitZ()).norm(), 1e-9);
    EXPECT_EQ(this->session_->GetContacts(), 1);
  }
}

TEST_P(HapticMouseInBothViews, PressingWithABallPushesWithStiffnessTimesDepth)
{
  constexpr double radius = 3.0;
  this->show(makePlane(100.0));
  this->lookDown();
  this->session_->SetSetting("Radius", radius);
  this->engage();
  this->press(230.0, 170.0);
  EXPECT_LT((this->proxy() - this->ray(230.0, 170.0).atHeight(radius)).norm(), 1e-9);
  EXPECT_LT((this->force() - force_N * Vec3::UnitZ()).norm(), 1e-9);
}

// A convex facet holds a hand that is d below its middle alone if its edges are further away than d tan(angle between
// facets): 2 u x tan 9 deg = 0.3 u, and the middle of a triangle of these is more than 1 u from its edges.
TEST_P(HapticMouseInBothViews, StrokingASpherePushesAlongTheNormalOfWhatIsUnderThePointer)
{
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(50.0, 40);
  this->show(sphere);
  this->lookDown();
  this->engage();
  int pressed = 0;
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); cell += 23)
  {
    const auto [middle, n_W] = facetOf(sphere, cell);
    if (n_W.dot(this->eye_W_.normalized()) < 0.6 || std::abs(middle.z()) > 45.0)
    {
      continue;
    }
    const auto [x_px, y_px] = pixelOf(this->eye_W_, this->parallel_, middle);
    this->press(x_px, y_px);
    ASSERT_LT((this->force() - force_N * n_W).norm(), 1e-9) << cell;
    ASSERT_LT((this->proxy() - middle).norm(), 1e-9) << cell;
    ++pressed;
  }
  EXPECT_GT(pressed, 10);
}

// At a constant depth F = K d in every tick, whatever the pointer's events do to the hand's place.
TEST_F(HapticMouse, StrokingAtTheRateOfAScreenIsNoStepOfForce)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  this->press(200.0, 150.0);
  double before_x = this->proxy().x();
  for (int event = 1; event <= 20; ++event)
  {
    this->mouse_->SetPointer(200.0 + 5 * event, 150.0);
    this->touch_->Update();
    for (int tick = 0; tick < frame; ++tick)
    {
      this->session_->Step(1);
      ASSERT_LT((this->force() - force_N * Vec3::UnitZ()).norm(), 1e-9);
      ASSERT_GE(this->proxy().x(), before_x);
      ASSERT_LE((this->proxy().x() - before_x) / scale, fastest_m * (1 + 1e-9));
      before_x = this->proxy().x();
    }
  }
}

TEST_F(HapticMouse, NoTickChangesTheForceByMoreThanAHandsSpeedDoes)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(framesToArrive);
  this->mouse_->SetPressing(true);
  this->touch_->Update();
  double before_N = 0.0;
  for (int tick = 0; tick < 100; ++tick)
  {
    this->session_->Step(1);
    ASSERT_LE(std::abs(this->force().z() - before_N), stiffness * fastest_m * (1 + 1e-9));
    before_N = this->force().z();
  }
  EXPECT_NEAR(before_N, force_N, 1e-9);
}

// Deepening from d to 1.25 d takes a frame: v = d / 4 over 16 ms, into the wall: F = K x + B v.
TEST_F(HapticMouse, DampingActsOnTheHandThatGlides)
{
  constexpr double damping = 2.0; // N s/m
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->session_->SetSetting("Damping", damping);
  this->engage();
  this->press(200.0, 150.0);
  EXPECT_NEAR(this->force().z(), force_N, 1e-9);
  this->mouse_->Deepen(1.25);
  this->touch_->Update();
  this->session_->Step(frame - 1);
  const double pressed_m = depth_m + 0.25 * depth_m * (frame - 1) / frame;
  const double speed_m_per_s = 0.25 * depth_m / (frame * 1e-3);
  EXPECT_NEAR(this->force().z(), stiffness * pressed_m + damping * speed_m_per_s, 1e-9);
}

TEST_F(HapticMouse, APressBeforeTheForceIsEngagedWaits)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->mouse_->SetPointer(200.0, 150.0);
  this->mouse_->SetPressing(true);
  ASSERT_TRUE(this->touch_->Start());
  while (this->session_->GetEngageState() != vtkHapticSession::Engaged && this->session_->GetTicks() < 2000)
  {
    ASSERT_EQ(this->force(), Vec3(Vec3::Zero()));
    this->rest(1);
  }
  this->rest(framesToEngage);
  EXPECT_NEAR(this->force().z(), force_N, 1e-9);
}

// From the plane left of a ball that stands on it to the plane right of it: the straight line goes through the ball.
TEST_F(HapticMouse, GoesOverWhatBarsTheStraightWay)
{
  this->show(makePlane(100.0));
  this->show(makeSphere(20.0, 40));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  this->mouse_->SetPointer(130.0, 150.0);
  this->rest(framesToArrive);
  const double from_x = this->hand().x();
  this->mouse_->SetPointer(270.0, 150.0);
  double highest = 0.0;
  for (int i = 0; i < 3 * framesToArrive; ++i)
  {
    this->rest(1);
    ASSERT_EQ(this->session_->GetContacts(), 0);
    highest = std::max(highest, this->hand().z());
  }
  EXPECT_LT(from_x, -20.0);
  EXPECT_GT(this->hand().x(), 20.0);
  EXPECT_GT(highest, 20.0);
  EXPECT_LT(this->hand().z(), 20.0);
}

TEST_F(HapticMouse, OffEverythingTheHandMovesInThePlaneThroughTheProxy)
{
  this->show(makeSphere(50.0, 40));
  this->look(Vec3(0, -300, 0), false);
  this->engage();
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(framesToArrive);
  const double depth = this->depthOf(this->proxy());
  this->mouse_->SetPointer(20.0, 280.0);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->depthOf(this->hand()), depth, 1e-9);
  EXPECT_LT(this->ray(20.0, 280.0).distanceTo(this->hand()), 1e-9);
}

TEST_F(HapticMouse, NeverPressesDeeperThanATwentiethOfTheScene)
{
  constexpr double half = 0.5;
  const double most = 0.05 * std::hypot(2 * half, 2 * half);
  this->show(makePlane(half));
  this->look(Vec3(0, -1, 3), false);
  this->engage();
  EXPECT_NEAR(this->mouse_->GetUsedDepth(), most, 1e-15);
  this->press(200.0, 150.0);
  EXPECT_NEAR(this->force().norm(), stiffness * most / scale, 1e-9);
}

// The map moves the whole workspace in the scene: a hand that stayed where it was in it would be thrown into the
// sphere.
TEST_F(HapticMouse, FittedWhileItPressesItBeginsAnewOutside)
{
  constexpr double radius = 50.0;
  this->show(makeSphere(radius, 40));
  this->look(Vec3(0, -300, 0), false);
  this->engage();
  this->press(203.0, 152.0);
  this->session_->FitWorkspace();
  for (int i = 0; i < 2 * framesToArrive; ++i)
  {
    this->rest(1);
    ASSERT_GT(this->proxy().norm(), 0.99 * radius);
    ASSERT_GE(this->force().dot(this->proxy()), 0.0);
  }
  EXPECT_LT(this->ray(203.0, 152.0).distanceTo(this->proxy()), 0.1 * radius);
  EXPECT_GT(this->force().norm(), 0.5 * force_N);
}

// A closed surface that appears around the hand is felt from outside, where the camera sees the hand.
TEST_P(HapticMouseInBothViews, WhatAppearsAroundThePressingHandIsPressedFromOutside)
{
  constexpr double small = 45.0, large = 60.0;
  this->show(makeSphere(small, 40));
  this->lookDown();
  this->engage();
  this->press(203.0, 152.0);
  ASSERT_NEAR(this->proxy().norm(), small, 0.01 * small);
  this->show(makeSphere(large, 40));
  this->touch_->Update();
  ASSERT_TRUE(this->session_->FinishScene());
  this->rest(1);
  EXPECT_NE(std::string(this->session_->GetWarning()).find(" now covers the hand"), std::string::npos)
    << this->session_->GetWarning();
  for (int i = 0; i < 3 * framesToArrive; ++i)
  {
    this->rest(1);
    ASSERT_GT(this->proxy().norm(), 0.99 * large) << i;
  }
  EXPECT_NEAR(this->force().norm(), force_N, 0.05 * force_N);
  EXPECT_GT(this->force().dot(this->proxy()), 0.0);
  this->session_->Step(6000); // 5 s are enough to read the message
  this->session_->Update();
  EXPECT_STREQ(this->session_->GetWarning(), "");
  this->mouse_->SetPressing(false);
  this->rest(framesToArrive);
  EXPECT_LT(this->force().norm(), 1e-6); // free air is free
}

// A fifth of the pointer's displacement is the hand's, from where it became precise; then all of it again.
TEST_P(HapticMouseInBothViews, PreciseAWayOfThePointerIsThatMuchShorterUntilTheHandIsLifted)
{
  this->show(makePlane(100.0));
  this->lookDown();
  this->engage();
  this->press(200.0, 150.0);
  this->session_->SetSetting("PrecisionFactor", 5.0);
  this->session_->SetSetting("Precision", true);
  this->press(230.0, 165.0);
  EXPECT_LT((this->proxy() - this->ray(206.0, 153.0).atHeight(0.0)).norm(), 1e-9);
  EXPECT_LT((this->force() - force_N * Vec3::UnitZ()).norm(), 1e-9);
  this->session_->SetSetting("Precision", false);
  this->press(240.0, 165.0);
  EXPECT_LT((this->proxy() - this->ray(216.0, 153.0).atHeight(0.0)).norm(), 1e-9);
  this->mouse_->SetPressing(false);
  this->rest(framesToArrive);
  EXPECT_LT(this->ray(240.0, 165.0).distanceTo(this->hand()), 1e-9);
  this->session_->SetSetting("Precision", true);
  this->mouse_->SetPointer(180.0, 140.0);
  this->rest(framesToArrive);
  EXPECT_LT(this->ray(180.0, 140.0).distanceTo(this->hand()), 1e-9) << "it hovers";
}

TEST_P(HapticMouseInBothViews, WhileTheClutchIsHeldThePointerMovesAndTheHandDoesNotAndGoesOnFromThere)
{
  this->show(makePlane(100.0));
  this->lookDown();
  this->engage();
  this->press(200.0, 150.0);
  const Vec3 held_W = this->hand();
  this->session_->SetSetting("Clutch", true);
  for (int i = 1; i <= 30; ++i)
  {
    this->mouse_->SetPointer(200.0 + 2 * i, 150.0);
    this->rest(1);
    ASSERT_EQ(this->hand(), held_W);
  }
  EXPECT_EQ(this->force().norm(), 0.0);
  this->session_->SetSetting("Clutch", false);
  this->rest(framesToEngage);
  EXPECT_LT((this->proxy() - this->ray(200.0, 150.0).atHeight(0.0)).norm(), 1e-9);
  EXPECT_LT((this->force() - force_N * Vec3::UnitZ()).norm(), 1e-9);
  this->press(270.0, 150.0);
  EXPECT_LT((this->proxy() - this->ray(210.0, 150.0).atHeight(0.0)).norm(), 1e-9);
  const Vec3 offset_W(this->session_->GetSettingNumbers("Offset"));
  this->session_->SetSetting("Clutch", true);
  this->rest(1);
  this->session_->TouchingOff();
  EXPECT_EQ(Vec3(this->session_->GetSettingNumbers("Offset")), offset_W)
    << "of what a pointer did the map knows nothing";
}

TEST_F(HapticMouse, AnotherDeviceIsNotLed)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->session_->SetSetting("DeviceName", "fed");
  this->session_->SetHandPosition(1, 2, 30);
  ASSERT_TRUE(this->touch_->Start());
  this->press(200.0, 150.0);
  EXPECT_FALSE(this->mouse_->GetLeads());
  EXPECT_EQ(this->hand(), Vec3(1, 2, 30));
}

TEST_F(HapticMouse, ADepthThatIsNoneIsRefused)
{
  for (const double depth :
    { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(errorsOf(this->session_, [&] { this->session_->SetSetting("PressDepth", depth); }).size(), 1U);
    EXPECT_EQ(this->session_->GetSetting("PressDepth"), depth_m);
  }
}
