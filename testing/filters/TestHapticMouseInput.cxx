// SPDX-License-Identifier: GPL-3.0-or-later
// Commands to a view by the mouse and the keyboard.
#include "HapticMouseTest.h"

#include "vtkCommand.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;

TEST_F(HapticMouse, LeavingTheViewLiftsTheHandInFrontOfEverything)
{
  this->show(makeSphere(50.0, 40));
  this->look(Vec3(0, -300, 0), false);
  this->engage();
  this->press(200.0, 150.0);
  EXPECT_GT(this->force().norm(), 0.9 * force_N);
  this->say(vtkCommand::LeaveEvent, 200, 150);
  EXPECT_FALSE(this->mouse_->GetPressing());
  this->rest(framesToArrive);
  EXPECT_LE(this->force().norm(), rounding_N);
  EXPECT_LT(this->depthOf(this->hand()), 300.0 - 50.0);
}

TEST_F(HapticMouse, APointerDraggedOutOfTheViewLiftsTheHand)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  this->press(200.0, 150.0);
  this->say(vtkCommand::MouseMoveEvent, width_px + 20, 150);
  this->rest(framesToArrive);
  EXPECT_EQ(this->session_->GetContacts(), 0);
  EXPECT_LE(this->force().norm(), rounding_N);
}

TEST_F(HapticMouse, ShiftAndTheLeftButtonPressAndNobodyElseHearsOfIt)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  int heard = 0;
  this->count({ vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent, vtkCommand::MouseMoveEvent,
                vtkCommand::MouseWheelForwardEvent },
    heard);
  this->say(vtkCommand::LeftButtonPressEvent, 200, 150, true);
  this->say(vtkCommand::MouseMoveEvent, 210, 150, true);
  this->say(vtkCommand::MouseWheelForwardEvent, 210, 150, true);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->force().z(), 1.25 * force_N, 1e-9);
  this->say(vtkCommand::LeftButtonReleaseEvent, 210, 150, true);
  this->rest(framesToArrive);
  EXPECT_EQ(this->force().z(), 0.0);
  EXPECT_EQ(heard, 0);
  this->say(vtkCommand::LeftButtonPressEvent, 200, 150);
  this->say(vtkCommand::MouseMoveEvent, 210, 150);
  this->say(vtkCommand::MouseWheelForwardEvent, 210, 150);
  this->say(vtkCommand::LeftButtonReleaseEvent, 210, 150);
  this->rest(framesToArrive);
  EXPECT_EQ(heard, 4);
  EXPECT_FALSE(this->mouse_->GetPressing());
  EXPECT_NEAR(this->session_->GetSetting("PressDepth"), 1.25 * depth_m, 1e-15);
}

TEST_F(HapticMouse, WhileAKeyPressesEveryDragIsTheCameras)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  int heard = 0;
  this->count({ vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonReleaseEvent }, heard);
  this->say(vtkCommand::KeyPressEvent, 200, 150, false, "Next");
  for (unsigned long button : { vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent })
  {
    heard = 0;
    this->say(button, 200, 150);
    this->say(vtkCommand::MouseMoveEvent, 210, 150);
    this->say(vtkCommand::MouseMoveEvent, 200, 150);
    EXPECT_EQ(heard, 2);
    EXPECT_TRUE(this->mouse_->GetPressing());
  }
  heard = 0; // a key that presses in the middle of a drag leaves it to the camera as well
  this->say(vtkCommand::LeftButtonPressEvent, 200, 150);
  this->say(vtkCommand::KeyPressEvent, 200, 150, false, "Next");
  this->say(vtkCommand::MouseMoveEvent, 210, 150);
  this->say(vtkCommand::LeftButtonReleaseEvent, 210, 150);
  EXPECT_EQ(heard, 2);
  EXPECT_TRUE(this->mouse_->GetPressing());
}

TEST_F(HapticMouse, TheKeyboardAloneStrokes)
{
  this->show(makePlane(100.0));
  this->look(Vec3(0, -100, 300), false);
  this->engage();
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Right");
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Up");
  this->say(vtkCommand::KeyPressEvent, 0, 0, true, "Left");
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Next");
  this->rest(framesToArrive);
  const double x_px = 0.5 * width_px + 10 - 1, y_px = 0.5 * height_px + 10;
  EXPECT_LT((this->proxy() - this->ray(x_px, y_px).atHeight(0.0)).norm(), 1e-9);
  EXPECT_NEAR(this->force().z(), force_N, 1e-9);
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Next");
  this->rest(framesToArrive);
  EXPECT_NEAR(this->force().z(), 1.25 * force_N, 1e-9);
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Prior");
  this->rest(framesToArrive);
  EXPECT_NEAR(this->force().z(), force_N, 1e-9);
  this->say(vtkCommand::KeyPressEvent, 0, 0, false, "Home");
  this->rest(framesToArrive);
  EXPECT_EQ(this->force().z(), 0.0);
}
