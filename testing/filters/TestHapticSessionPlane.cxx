// SPDX-License-Identifier: GPL-3.0-or-later
// Plane worlds in a session: lines as walls, walls that a joystick holds, the guide of a hand in space. Virtual time.
#include <algorithm>
#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::Not;

namespace
{
constexpr int ticksToGuide = 600;
constexpr double wall = 200.0; // N/m

class HapticSessionPlane : public VirtualSession
{
protected:
  HapticSessionPlane()
  {
    this->session_->SetSetting("Passivity", false);
    this->session_->SetSetting("Stiffness", wall);
  }

  void show(const std::vector<Vec3>& line_W) { this->VirtualSession::show(makePath(line_W)); }

  Vec3 force() { return Vec3(this->session_->GetForce()); }
};

// The hand is led 3 mm over the line and a simulated joystick holds it: the wall is where the line is.
TEST_F(HapticSessionPlane, AJoystickHoldsTheWallsOfLinesItself)
{
  this->session_->SetSetting("DeviceName", "simulated-joystick");
  this->session_->SetSetting("Hand", "firm");
  for (const Vec3& p : { Vec3(0, 5, 0), Vec3(10, -3, 0) })
  {
    this->session_->AddStrokePoint(p.x(), p.y(), p.z());
  }
  this->show({ { -40, 0, 0 }, { 40, 0, 0 } });
  EXPECT_TRUE(this->session_->GetPlaneWorld());
  EXPECT_TRUE(test::says(this->session_->GetPlanText(), { "device itself holds", "125 Hz" }));
  std::ostringstream drag; // K s (Th - T) / 2
  drag.precision(3);
  drag << "a drag of " << std::min(wall, this->session_->GetLargestStiffness()) * 0.1 * (0.008 - 0.001) / 2 << " N";
  EXPECT_THAT(this->session_->GetPlanText(), HasSubstr(drag.str()));
  this->session_->TouchingOn();
  this->session_->Step(ticksToEngage);
  bool felt = false;
  for (int i = 0; i < 200; ++i)
  {
    this->session_->Step(10);
    const double depth_m = std::max(0.0, -Vec3(this->session_->GetHandPosition()).y()) / scale;
    if (depth_m > 1e-3)
    {
      felt = true;
      ASSERT_GE(this->session_->GetWallsHeld(), 1);
      const double viscous_N = 0.1; // the hand is slow
      ASSERT_NEAR(this->force().y(), std::min(this->session_->GetStiffnessUsed() * depth_m, 3.0), viscous_N);
    }
  }
  EXPECT_TRUE(felt);
  this->session_->SetSetting("HoldWalls", false);
  EXPECT_TRUE(test::says(this->session_->GetPlanText(), { "program renders the walls", "as set" }));
  this->session_->Step(10);
  EXPECT_EQ(this->session_->GetWallsHeld(), 0);
}

// A slice at x = 5 mm. Led by 200 N/m: 4 mm beside it 0.8 N, 30 mm beside it no more than 2 N; off: nothing.
TEST_F(HapticSessionPlane, AHandInSpaceIsLedToThePlaneAndTouchesWhatIsBelowIt)
{
  this->session_->SetSetting("LinesAsWalls", vtkHapticSession::On);
  this->show({ { 5, -40, 1 }, { 5, 40, 1 }, { 5, 40, 50 } });
  ASSERT_TRUE(this->session_->GetPlaneWorld());
  this->session_->SetHandPosition(5, 0, 10);
  this->session_->TouchingOn();
  this->session_->Step(ticksToEngage);
  this->session_->SetHandPosition(9, 0, 10);
  this->session_->Step(ticksToGuide);
  EXPECT_EQ(this->session_->GetGuideShare(), 1.0);
  EXPECT_LE((this->force() - Vec3(-200.0 * 0.004, 0, 0)).norm(), 1e-9);
  EXPECT_NEAR(this->session_->GetProxyPosition()[0], 5.0, 1e-12);

  this->session_->SetHandPosition(7, 0, -2); // and 3 mm through the line
  this->session_->Step(200);
  EXPECT_LE((this->force() - Vec3(-200.0 * 0.002, 0, wall * 0.003)).norm(), 1e-9);

  this->session_->SetHandPosition(35, 0, 10);
  this->session_->Step(200);
  EXPECT_LE((this->force() - Vec3(-2.0, 0, 0)).norm(), 1e-9);

  this->session_->SetSetting("PlaneGuide", false);
  this->session_->Step(ticksToGuide);
  EXPECT_EQ(this->session_->GetGuideShare(), 0.0);
  EXPECT_LE(this->force().norm(), 1e-9);
}

TEST_F(HapticSessionPlane, LinesAreWallsOnlyWhereThatIsAskedForOrTheDeviceMovesInAPlane)
{
  const auto line = makePath({ { -40, 0, 0 }, { 40, 0, 0 } });
  EXPECT_THAT(
    errorsOf(this->session_, [&] { this->session_->AddSurface("line", line, nullptr); }), Not(::testing::IsEmpty()));
  this->session_->SetSetting("DeviceName", "simulated-joystick");
  this->session_->ClearSurfaces();
  EXPECT_TRUE(this->session_->AddSurface("line", line, nullptr));
  this->session_->SetSetting("LinesAsWalls", vtkHapticSession::Off);
  EXPECT_THAT(
    errorsOf(this->session_, [&] { this->session_->AddSurface("line", line, nullptr); }), Not(::testing::IsEmpty()));
}

TEST_F(HapticSessionPlane, ASurfaceBesideTheLinesIsNoPlaneWorldAndTwoPlanesAreNone)
{
  this->session_->SetSetting("LinesAsWalls", vtkHapticSession::On);
  this->show({ { -40, 0, 0 }, { 40, 0, 0 } });
  EXPECT_TRUE(this->session_->GetPlaneWorld());
  ASSERT_TRUE(this->session_->AddSurface("other", makePath({ { 0, -40, 0 }, { 0, 40, 0 } }), nullptr));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_TRUE(this->session_->GetPlaneWorld());
  ASSERT_TRUE(this->session_->AddSurface("third", makePath({ { 0, -40, 9 }, { 0, 40, 9 } }), nullptr));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->GetPlaneWorld());
  this->show({ { -40, 0, 0 }, { 40, 0, 0 } });
  ASSERT_TRUE(this->session_->AddSurface("plane", makePlane(40.0), nullptr));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->GetPlaneWorld());
}

TEST_F(HapticSessionPlane, LinesInSpaceAreRefusedWithWhatToDo)
{
  this->session_->SetSetting("LinesAsWalls", vtkHapticSession::On);
  const auto bent = makePath({ { -40, 0, 0 }, { 40, 0, 0 }, { 40, 40, 0 }, { 40, 40, 9 } });
  const std::vector<std::string> said =
    errorsOf(this->session_, [&] { this->session_->AddSurface("bent", bent, nullptr); });
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], ::testing::AllOf(HasSubstr("bent"), HasSubstr("in no plane"), HasSubstr("line radius")));
}

TEST_F(HapticSessionPlane, FittingTurnsAJoystickIntoThePlaneOfTheLines)
{
  this->session_->SetSetting("DeviceName", "simulated-joystick");
  this->show({ { 5, -40, -40 }, { 5, 40, -40 }, { 5, 40, 40 } });
  EXPECT_TRUE(test::says(this->session_->GetPlanText(), { "because the plane is not" }));
  this->session_->FitWorkspace();
  EXPECT_THAT(this->session_->GetPlanText(), HasSubstr("device itself holds"));
  const Quat q(this->session_->GetSettingNumbers("Rotation")[0], this->session_->GetSettingNumbers("Rotation")[1],
    this->session_->GetSettingNumbers("Rotation")[2], this->session_->GetSettingNumbers("Rotation")[3]);
  EXPECT_LE((q * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LE((q * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-12);
}

TEST_F(HapticSessionPlane, ARateThatNoLinkHasIsRefusedAndTheOldOneStays)
{
  EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("WallRate", 5.0); }), ::testing::SizeIs(1));
  EXPECT_THAT(
    errorsOf(this->session_, [&] { this->session_->SetSetting("WallRate", std::nan("")); }), ::testing::SizeIs(1));
  EXPECT_EQ(this->session_->GetSetting("WallRate"), 125.0);
}

} // namespace
