// SPDX-License-Identifier: GPL-3.0-or-later
// A pointer leads a hand where no surface stands under it: in a field, and with a mechanism or a tool that is advanced
// along its axis. Judges: the camera's formula, the strengths that the scene file gives, the spring.
#include "HapticMouseTest.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "FieldSession.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkHapticMechanism.h"
#include "vtkHapticSight.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double strength_N = 1.5, drag_N = 0.4; // of the skin in needle.json
constexpr double lower = -8.0, upper = 8.0;      // u, the faces of the wall
constexpr double hover = 5.0;                    // u, in front of a surface
constexpr double atOnce_N = 0.05;                // the force grows by 2.5 N/s, 0.04 N in a frame

class HapticMouseAdvance : public HapticMouse
{
protected:
  /// A needle of 150 u below a wall, along z, seen from the side.
  void holdNeedle()
  {
    this->look(Vec3(0, -500, 0), true);
    this->session_->SetSetting("MechanismSource", "needle");
    this->source_->SetFileName(PALPATE_DATA_MECHANISMS "/needle.json");
    this->source_->Update();
    ASSERT_TRUE(this->session_->AddMechanism("needle", this->source_->GetAtFirst())) << this->session_->GetProblem();
    this->engage();
  }

  /// A ball of radius 20 u as the isosurface of a volume of 60 u a side.
  void feelBall()
  {
    this->look(Vec3(0, -500, 0), true);
    this->session_->SetSetting("FieldArray", "distance");
    this->session_->SetSetting("FieldIsosurface", true);
    this->session_->SetSetting("FieldIsovalue", 20.0);
    ASSERT_TRUE(this->session_->AddField("ball", distances(61, 1.0))) << this->session_->GetProblem();
    ASSERT_TRUE(this->session_->FinishField());
    this->engage();
  }

  Vec3 tip() const
  {
    Vec3 tip_W, axis_W;
    EXPECT_TRUE(this->session_->GetSight()->GetHeldAxis(tip_W.data(), axis_W.data()));
    return this->hand() + tip_W;
  }

  std::string phase()
  {
    vtkNew<vtkTable> laws;
    this->session_->GetMechanism()->GetTable(laws);
    return laws->GetValueByName(0, "Phase").ToString();
  }

  /// The largest force until a number of frames have gone.
  double mostForce(int frames)
  {
    double most_N = 0.0;
    for (int i = 0; i < frames; ++i)
    {
      this->rest(1);
      most_N = std::max(most_N, this->force().norm());
    }
    return most_N;
  }

  vtkNew<vtkHapticMechanism> source_;
};
} // namespace

TEST_F(HapticMouseAdvance, AMechanismWaitsInFrontOfAllBodiesWithItsTipUnderThePointer)
{
  this->holdNeedle();
  EXPECT_LT(this->tip().z(), lower) << "in front of the wall";
  EXPECT_EQ(this->force().norm(), 0.0);
  const auto [x_px, y_px] = pixelOf(this->eye_W_, true, Vec3(10.0, 0.0, 0.0));
  this->mouse_->SetPointer(x_px, y_px);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->tip().x(), 10.0, 1e-6);
  EXPECT_NEAR(this->tip().y(), 0.0, 1e-6) << "in the plane through the middle of the bodies";
  EXPECT_LT(this->tip().z(), lower) << "aimed, not advanced";
}

TEST_F(HapticMouseAdvance, PressingANeedlePuncturesTheWallAtItsStrengthAndGoesOnThroughIt)
{
  this->holdNeedle();
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(framesToArrive);
  this->mouse_->SetPressing(true);
  double most_N = 0.0;
  for (int i = 0; i < 1500 && this->phase() != "inside"; ++i)
  {
    most_N = std::max(most_N, this->mostForce(1));
  }
  ASSERT_EQ(this->phase(), "inside");
  EXPECT_NEAR(most_N, strength_N, atOnce_N);
  this->rest(20);
  EXPECT_NEAR(this->force().norm(), drag_N, 0.1 * drag_N) << "the shaft is dragged";
}

TEST_F(HapticMouseAdvance, ANeedleBesideTheMiddleIsHeldFirmlyAndPuncturesToo)
{
  this->holdNeedle();
  const auto [x_px, y_px] = pixelOf(this->eye_W_, true, Vec3(7.0, 0.0, 0.0));
  this->mouse_->SetPointer(x_px, y_px);
  this->rest(framesToArrive);
  this->mouse_->SetPressing(true);
  for (int i = 0; i < 1500 && this->phase() != "inside"; ++i)
  {
    this->rest(1);
  }
  EXPECT_EQ(this->phase(), "inside");
}

TEST_F(HapticMouseAdvance, TheWheelAdvancesANeedleByNotchesAndNoFurtherThanTheDepthBeyondIt)
{
  this->holdNeedle();
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(framesToArrive);
  const double before = this->tip().z();
  EXPECT_TRUE(this->mouse_->GetAdvances());
  this->say(vtkCommand::MouseWheelForwardEvent, 200, 150, true);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->tip().z() - before, 2.0, 1e-9) << "2 mm of the hand at 1000 u/m";
  for (int notch = 0; notch < 10; ++notch)
  {
    this->say(vtkCommand::MouseWheelForwardEvent, 200, 150, true);
    this->rest(20);
  }
  EXPECT_NEAR(this->force().norm(), force_N, 1e-2 * force_N) << "stiffness times PressDepth, below the strength";
  EXPECT_NE(this->phase(), "inside");
}

TEST_F(HapticMouseAdvance, WhenThePointerLeavesAndComesBackElsewhereANeedleInTheWallStaysWhereItIs)
{
  this->holdNeedle();
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(framesToArrive);
  this->mouse_->SetPressing(true);
  for (int i = 0; i < 1500 && this->phase() != "inside"; ++i)
  {
    this->rest(1);
  }
  this->mouse_->SetPressing(false);
  this->mouse_->Leave();
  this->rest(framesToArrive);
  const Vec3 inside_W = this->tip();
  this->mouse_->SetPointer(350.0, 20.0);
  this->rest(framesToArrive);
  EXPECT_LT((this->tip() - inside_W).norm(), 1.0) << "millimetres; the pointer came back 100 mm away";
  EXPECT_EQ(this->phase(), "inside");
  this->say(vtkCommand::KeyPressEvent, 350, 20, false, "Home");
  this->rest(3 * framesToArrive);
  EXPECT_LT(this->tip().z(), lower) << "Home draws the needle out";
  EXPECT_NE(this->phase(), "inside");
}

TEST_F(HapticMouseAdvance, AFieldIsEnteredInTheMiddleOfItsDataAndHeldBackByItsWall)
{
  this->feelBall();
  this->mouse_->SetPointer(pixelOf(this->eye_W_, true, Vec3(28.0, 0.0, 0.0)).first, 150.0);
  this->rest(3 * framesToArrive);
  EXPECT_LT((this->hand() - Vec3(28.0, 0.0, 0.0)).norm(), 0.5)
    << "beside the ball the hand is free in the middle plane";
  EXPECT_EQ(this->force().norm(), 0.0);
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(3 * framesToArrive);
  EXPECT_NEAR(this->proxy().norm(), 20.0, 0.02) << "the wall keeps the proxy out";
  EXPECT_NEAR(this->force().norm(), force_N, 1e-2 * force_N) << "stiffness times PressDepth";
  EXPECT_NEAR(this->force().normalized().dot(this->proxy().normalized()), 1.0, 1e-2);
}

// A computer with other work to do draws few frames, and a person comes from any side.
TEST_F(HapticMouseAdvance, TheForceOfAFieldDoesNotDependOnHowThePointerCameNorOnHowOftenTheViewIsDrawn)
{
  this->feelBall();
  const Vec3 inside_W(6.0, 0.0, 4.0);
  const auto [x_px, y_px] = pixelOf(this->eye_W_, true, inside_W);
  for (const Vec3& from_W : { Vec3(28, 0, 0), Vec3(-28, 0, 0), Vec3(0, 0, 28), Vec3(20, 0, -20) })
  {
    for (const int ticks : { 5, frame, 7 * frame })
    {
      const auto [x0_px, y0_px] = pixelOf(this->eye_W_, true, from_W);
      this->mouse_->SetPointer(x0_px, y0_px);
      this->rest(3 * framesToArrive);
      this->mouse_->SetPointer(x_px, y_px);
      for (int i = 0; i < 3 * framesToArrive * std::max(1, frame / ticks); ++i)
      {
        this->touch_->Update();
        this->session_->Step(ticks);
      }
      EXPECT_NEAR(this->force().norm(), force_N, 1e-2 * force_N) << from_W.transpose() << ", " << ticks;
      const Vec3 towards_W = (inside_W - this->proxy()).normalized();
      EXPECT_NEAR(towards_W.dot(this->force().normalized()), -1.0, 1e-2) << "nearest to the place under the pointer";
    }
  }
  this->mouse_->Leave();
  this->rest(framesToArrive);
  EXPECT_LT(this->force().norm(), 0.02 * force_N);
  this->mouse_->SetPointer(x_px, y_px);
  this->rest(framesToArrive);
  EXPECT_NEAR(this->force().norm(), force_N, 1e-2 * force_N) << "after a click in the panel";
}

TEST_F(HapticMouseAdvance, TheWheelMovesThePlaneOfAFieldAndLeavingItEndsTheForce)
{
  this->feelBall();
  const double x_px = pixelOf(this->eye_W_, true, Vec3(28.0, 0.0, 0.0)).first;
  this->mouse_->SetPointer(x_px, 150.0);
  this->rest(3 * framesToArrive);
  for (int notch = 0; notch < 3; ++notch)
  {
    this->say(vtkCommand::MouseWheelForwardEvent, static_cast<int>(std::lround(x_px)), 150, true);
  }
  this->rest(framesToArrive);
  EXPECT_NEAR(this->hand().y(), 6.0, 1e-6) << "away from the eye: 3 notches of 2 mm";
  this->mouse_->SetPointer(200.0, 150.0);
  this->rest(3 * framesToArrive);
  EXPECT_GT(this->force().norm(), 0.5 * force_N);
  this->mouse_->Leave();
  this->rest(framesToArrive);
  EXPECT_LT(this->force().norm(), 0.02 * force_N);
}

// The bar is 20 pixels from the left edge, from a quarter of the view's height on half of that height long. The data
// are 60 u deep: 112 pixels up the bar are 112/150 of that, from -30 u on.
TEST_F(HapticMouseAdvance, TheHandleOfTheDepthMovesThePlaneOfAFieldAndNotTheCamera)
{
  this->feelBall();
  const int x_px = static_cast<int>(std::lround(pixelOf(this->eye_W_, true, Vec3(28.0, 0.0, 0.0)).first));
  this->mouse_->SetPointer(x_px, 150.0);
  this->rest(3 * framesToArrive);
  int turned = 0;
  this->count({ vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent }, turned);
  this->say(vtkCommand::MouseMoveEvent, 20, 150);
  const double before = this->hand().y();
  this->say(vtkCommand::LeftButtonPressEvent, 20, 150);
  this->say(vtkCommand::MouseMoveEvent, 60, 75 + 112);
  this->rest(2 * framesToArrive);
  EXPECT_NEAR(before, 0.0, 1e-6) << "in the middle";
  EXPECT_NEAR(this->hand().y(), 60.0 * 112.0 / 150.0 - 30.0, 1e-6);
  EXPECT_NEAR(this->hand().x(), 28.0, 0.5) << "under the place that the pointer came from";
  this->say(vtkCommand::LeftButtonReleaseEvent, 60, 187);
  EXPECT_EQ(turned, 0);
  this->say(vtkCommand::LeftButtonPressEvent, 60, 187);
  EXPECT_EQ(turned, 1) << "beside the bar a drag is the camera's";
}

// A cube of 10 u beside the origin of its data, which is in the hand.
TEST_F(HapticMouseAdvance, AToolBesideTheOriginOfItsDataIsPressedUnderThePointer)
{
  this->show(makePlane(100.0));
  this->look(Vec3(60, -200, 250), false);
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(10.0);
  cube->SetYLength(10.0);
  cube->SetZLength(10.0);
  cube->SetCenter(18.0, 3.0, 4.0);
  cube->Update();
  this->session_->SetSetting("ToolHandle", 1);
  this->session_->SetSetting("ToolSource", "Cube1");
  ASSERT_TRUE(this->session_->AddTool("Cube1", cube->GetOutput()));
  this->engage();
  this->mouse_->SetPointer(170.0, 140.0);
  this->rest(3 * framesToArrive);
  const Vec3 over_W = this->ray(170.0, 140.0).atHeight(0.0) + 5.0 * Vec3::UnitZ();
  EXPECT_LT((this->tip() - over_W + hover * this->ray(170.0, 140.0).along).norm(), 1e-6) << "its middle";
  EXPECT_EQ(this->force().norm(), 0.0);
  this->mouse_->SetPressing(true);
  this->rest(framesToArrive);
  EXPECT_GT(this->force().z(), 0.1 * force_N) << "beside its handle a cube gives way by turning";
  EXPECT_LE(this->force().z(), force_N * (1 + 1e-9));
}

TEST_F(HapticMouseAdvance, AToolHeldAlongTheViewPointsAwayFromTheEyeAndGoesThatWay)
{
  this->show(makePlane(100.0));
  const Vec3 eye_W(0.0, 0.01, 300.0);
  this->look(eye_W, true);
  vtkNew<vtkCubeSource> rod;
  rod->SetXLength(40.0);
  rod->SetYLength(4.0);
  rod->SetZLength(4.0);
  rod->Update();
  this->session_->SetSetting("HoldAlong", 3);
  this->session_->SetSetting("ToolSource", "Rod");
  ASSERT_TRUE(this->session_->AddTool("Rod", rod->GetOutput()));
  this->engage();
  Vec3 tip_W, axis_W;
  ASSERT_TRUE(this->session_->GetSight()->GetHeldAxis(tip_W.data(), axis_W.data()));
  EXPECT_LT((axis_W + eye_W.normalized()).norm(), 1e-9);
  this->mouse_->SetPointer(230.0, 170.0);
  this->rest(framesToArrive);
  EXPECT_EQ(this->force().norm(), 0.0);
  this->mouse_->Advance(20.0); // further than the plane; pressed harder a rod that is held at its middle topples
  this->rest(4 * framesToArrive);
  EXPECT_NEAR(this->proxy().z(), 20.0, 0.1) << "half its length above the plane";
  EXPECT_NEAR(this->force().z(), force_N, 1e-2 * force_N);
}
