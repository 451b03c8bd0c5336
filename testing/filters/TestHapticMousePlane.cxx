// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse in a plane world: the hand is where the camera's ray meets the plane, and the walls do the rest.
#include <gtest/gtest.h>

#include "HapticMouseTest.h"
#include "vtkCommand.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{
const Vec3 above_W(20, -150, 200);
const Vec3 edgeOn_W(0, -200, 0);

/// A wall along x in the plane z = 0, and the pointer over its side of larger y.
class HapticMousePlane : public HapticMouse
{
protected:
  void begin(const Vec3& eye_W, bool parallel)
  {
    this->session_->SetSetting("LinesAsWalls", vtkHapticSession::On);
    this->show(makePath({ { -40, 0, 0 }, { 40, 0, 0 } }));
    this->look(eye_W, parallel); // the shown data set the clipping range, whose width costs a ray its digits
    this->pointAt({ 0, 10, 0 });
    this->engage();
  }

  void pointAt(const Vec3& p_W)
  {
    const auto [x_px, y_px] = pixelOf(this->eye_W_, this->parallel_, p_W);
    this->mouse_->SetPointer(x_px, y_px);
    this->rest(framesToArrive);
  }
};

class HapticMouseInPlane
  : public HapticMousePlane
  , public ::testing::WithParamInterface<bool>
{
};

TEST_P(HapticMouseInPlane, IsWhereThePointerMeetsThePlaneAndTheWallPushesByHowFarItIsBehind)
{
  this->begin(above_W, this->GetParam());
  ASSERT_EQ(this->session_->GetEngageState(), vtkHapticSession::Engaged);
  ASSERT_TRUE(this->session_->GetPlaneWorld());
  for (const Vec3& p_W : { Vec3(5, 3, 0), Vec3(5, -2, 0), Vec3(-12, -1, 0), Vec3(-12, 4, 0) })
  {
    this->pointAt(p_W);
    const double behind = std::max(0.0, -p_W.y());
    EXPECT_LE((this->hand() - p_W).norm(), 1e-9) << p_W.transpose();
    EXPECT_LE((this->proxy() - Vec3(p_W.x(), std::max(0.0, p_W.y()), 0.0)).norm(), 1e-9) << p_W.transpose();
    EXPECT_LE((this->force() - Vec3(0, stiffness * behind / scale, 0)).norm(), 1e-9) << p_W.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(PerspectiveAndParallel, HapticMouseInPlane, ::testing::Bool());

TEST_F(HapticMousePlane, APointerThatLeavesTheViewLetsTheHandRestAtTheProxy)
{
  this->begin(above_W, false);
  this->pointAt({ 5, -2, 0 });
  EXPECT_NEAR(this->force().norm(), stiffness * 2.0 / scale, 1e-9);
  this->mouse_->Leave();
  this->rest(framesToArrive);
  EXPECT_LE((this->hand() - Vec3(5, 0, 0)).norm(), 1e-9);
  EXPECT_LE(this->force().norm(), 1e-9);
}

TEST_F(HapticMousePlane, PreciseTheHandGoesAFourthOfTheWayInThePlane)
{
  this->begin(above_W, true); // without perspective equal displacements on the screen are equal displacements in the
                              // plane
  this->pointAt({ 5, 3, 0 });
  this->session_->SetSetting("PrecisionFactor", 4.0);
  this->session_->SetSetting("Precision", true);
  this->pointAt({ 9, 7, 0 });
  EXPECT_LE((this->hand() - Vec3(6, 4, 0)).norm(), 1e-9);
}

TEST_F(HapticMousePlane, APlaneThatIsSeenAsALineMovesNoHand)
{
  this->begin(above_W, false);
  this->pointAt({ 5, 3, 0 });
  this->look(edgeOn_W, false);
  this->mouse_->SetPointer(0.25 * width_px, 0.5 * height_px);
  this->rest(framesToArrive);
  EXPECT_LE((this->hand() - Vec3(5, 3, 0)).norm(), 1e-9);
}

TEST_F(HapticMousePlane, ThereIsNothingToPressSoButtonsWheelAndPageKeysAreTheCameras)
{
  this->begin(above_W, false);
  const double depth_m = this->session_->GetSetting("PressDepth");
  this->say(vtkCommand::LeftButtonPressEvent, width_px / 2, height_px / 2, true);
  EXPECT_FALSE(this->mouse_->GetPressing());
  this->say(vtkCommand::LeftButtonReleaseEvent, width_px / 2, height_px / 2, true);
  this->say(vtkCommand::MouseWheelForwardEvent, width_px / 2, height_px / 2, true);
  for (const char* key : { "Next", "Next", "Prior", "Home" })
  {
    this->say(vtkCommand::KeyPressEvent, width_px / 2, height_px / 2, false, key);
    EXPECT_FALSE(this->mouse_->GetPressing()) << key;
  }
  EXPECT_EQ(this->session_->GetSetting("PressDepth"), depth_m);
}

TEST_F(HapticMousePlane, TheArrowKeysAloneLeadTheHandAlongTheWallAndBehindIt)
{
  this->begin(above_W, false);
  const auto [x_px, y_px] = pixelOf(above_W, false, { 0, 10, 0 });
  const auto type = [this](const char* key, bool shift) { this->say(vtkCommand::KeyPressEvent, 0, 0, shift, key); };
  type("Right", false);
  type("Left", true);
  this->rest(framesToArrive);
  const Vec3 beside_W = this->ray(x_px + 9, y_px).atHeight(0.0); // an arrow key is 10 pixels, with shift 1
  EXPECT_LE((this->hand() - beside_W).norm(), 1e-9);
  EXPECT_LE(this->force().norm(), 1e-9);
  type("Down", false);
  type("Down", false);
  this->rest(framesToArrive);
  const Vec3 behind_W = this->ray(x_px + 9, y_px - 20).atHeight(0.0);
  ASSERT_LT(behind_W.y(), 0.0);
  EXPECT_LE((this->hand() - behind_W).norm(), 1e-9);
  EXPECT_LE((this->proxy() - Vec3(behind_W.x(), 0, 0)).norm(), 1e-9);
  EXPECT_NEAR(this->force().y(), -stiffness * behind_W.y() / scale, 1e-9);
  type("Up", false);
  type("Up", false);
  this->rest(framesToArrive);
  EXPECT_LE((this->hand() - beside_W).norm(), 1e-9);
  EXPECT_LE(this->force().norm(), 1e-9);
}

TEST_F(HapticMousePlane, WithoutAPlaneWorldThereIsNoPlane)
{
  Vec3 point_W, normal_W;
  EXPECT_FALSE(this->session_->GetPlane(point_W.data(), normal_W.data()));
  this->begin(above_W, false);
  ASSERT_TRUE(this->session_->GetPlane(point_W.data(), normal_W.data()));
  EXPECT_EQ(point_W.z(), 0.0);
  EXPECT_LE(normal_W.cross(Vec3::UnitZ()).norm(), 1e-15);
}

} // namespace
