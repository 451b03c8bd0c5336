// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/recording/Recording.h"
#include "testing/support/Says.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkCellArray.h"
#include "vtkHapticSession.h"
#include "vtkHapticStroke.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
/// With a fed hand at (0, 0, 1) over the plane z = 0.
class HapticSession : public VirtualSession
{
protected:
  void SetUp() override
  {
    this->session_->SetHandPosition(0.0, 0.0, 1.0);
    this->show(makePlane(100.0));
  }

  void showNothing()
  {
    this->session_->ClearSurfaces();
    this->session_->CommitScene();
    ASSERT_FALSE(this->session_->FinishScene());
  }

  void engage()
  {
    this->startTouching();
    this->session_->Step(ticksToEngage);
    ASSERT_EQ(this->session_->GetEngageState(), vtkHapticSession::Engaged);
  }

  [[nodiscard]] Vec3 force() const { return Vec3(this->session_->GetForce()); }
  [[nodiscard]] Vec3 proxy_W() const { return Vec3(this->session_->GetProxyPosition()); }
};

void expectReplays(const std::string& file, int ticks)
{
  const auto recording = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(recording)) << std::get<std::string>(recording);
  const ReplayResult result = replay(std::get<Recording>(recording));
  EXPECT_EQ(result.problem, "");
  EXPECT_EQ(result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(ticks));
}
} // namespace

TEST_F(HapticSession, ForceIsStiffnessTimesDepthOverScale)
{
  this->engage();
  EXPECT_EQ(this->force(), Vec3::Zero());
  constexpr double depth = 2.0;
  this->session_->SetHandPosition(3.0, 4.0, -depth);
  this->session_->Step(100); // longer than the rise limit needs for 1 N
  EXPECT_LT((this->force() - Vec3(0.0, 0.0, stiffness * depth / scale)).norm(), 1e-12);
  EXPECT_LT((this->proxy_W() - Vec3(3.0, 4.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(this->session_->GetContacts(), 1);
  EXPECT_NEAR(this->session_->GetDepth(), depth, 1e-12);
}

// The origin lies below the plane that is shown here: a hand that came from there would be stopped by its lower side.
TEST_F(VirtualSession, BeforeAHandIsPutSomewhereThereIsNoneAndItBeginsWhereItIsPut)
{
  vtkNew<vtkMatrix4x4> raised;
  raised->SetElement(2, 3, 5.0);
  ASSERT_TRUE(this->session_->AddSurface("surface", makePlane(100.0), raised));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  this->startTouching();
  this->session_->Step(ticksToEngage);
  EXPECT_THAT(this->session_->GetFaultText(), HasSubstr("no hand position yet"));
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  this->session_->SetHandPosition(0.0, 0.0, 8.0);
  this->session_->Step(ticksToEngage);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  constexpr double depth = 2.0;
  this->session_->SetHandPosition(0.0, 0.0, 5.0 - depth);
  this->session_->Step(100);
  EXPECT_LT((Vec3(this->session_->GetForce()) - Vec3(0.0, 0.0, stiffness * depth / scale)).norm(), 1e-12);
}

TEST_F(HapticSession, CountsEveryTickOfVirtualTime)
{
  this->session_->TouchingOn();
  this->session_->Step(250);
  this->session_->Step(250);
  EXPECT_EQ(this->session_->GetTicks(), 500);
  EXPECT_EQ(this->session_->GetMissed(), 0);
  EXPECT_EQ(this->session_->GetPeriods(), 500);
}

TEST_F(HapticSession, IsSafeAndWithoutForceWhenItStops)
{
  this->engage();
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  this->session_->TouchingOff();
  EXPECT_EQ(this->session_->GetEngageState(), vtkHapticSession::Safe);
  EXPECT_EQ(this->force(), Vec3::Zero());
}

TEST_F(HapticSession, LetsGoWhenTold)
{
  this->engage();
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  ASSERT_GT(this->session_->GetForceMagnitude(), 0.5);
  this->session_->Release();
  this->session_->Step(100);
  EXPECT_EQ(this->force(), Vec3::Zero());
  EXPECT_EQ(this->session_->GetEngageState(), vtkHapticSession::Safe);
}

TEST_F(HapticSession, AMovedSurfacePushesFromItsNewPlace)
{
  this->engage();
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 5.0);
  this->session_->SetHandPosition(0.0, 0.0, 6.0);
  this->session_->Step(10);
  this->session_->ClearSurfaces();
  ASSERT_TRUE(this->session_->AddSurface("surface", makePlane(100.0), up));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(1000); // the blend of a new scene has faded
  this->session_->SetHandPosition(0.0, 0.0, 4.0);
  this->session_->Step(100);
  EXPECT_NEAR(this->proxy_W().z(), 5.0, 1e-12);
  EXPECT_LT((this->force() - Vec3(0.0, 0.0, stiffness * 1.0 / scale)).norm(), 1e-12);
}

TEST_F(HapticSession, AnEmptySceneReleasesAndSaysSo)
{
  this->engage();
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  this->showNothing();
  this->session_->Step(1000);
  EXPECT_LT(this->session_->GetForceMagnitude(), 1e-6);
  EXPECT_STRNE(this->session_->GetFaultText(), "");
}

TEST_F(HapticSession, ASimulatedHandStrokesAPlaneAlongItsStroke)
{
  constexpr double depth = 3.0;
  vtkNew<vtkHapticStroke> stroke;
  stroke->SetInputData(makePlane(50.0));
  stroke->SetDepth(depth);
  stroke->SetWindow(0.0);
  stroke->Update();
  this->session_->SetSetting("DeviceName", "simulated-generic");
  this->session_->SetStrokePath(stroke->GetOutput());
  ASSERT_EQ(this->session_->GetNumberOfStrokePoints(), stroke->GetOutput()->GetNumberOfPoints());
  this->session_->TouchingOn();
  ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
  this->session_->Step(2000); // 100 mm of lift and stroke: on the way back, far from both ends
  EXPECT_EQ(this->session_->GetEngageState(), vtkHapticSession::Engaged) << this->session_->GetFaultText();
  EXPECT_GT(this->session_->GetForceMagnitude(), 0.0);
  EXPECT_LT(this->session_->GetForceResidual(), 1e-9);
}

TEST_F(HapticSession, TwoRunsAreTheSameToTheLastBit)
{
  const auto run = [this]
  {
    this->session_->SetHandPosition(0.0, 0.0, 1.0);
    this->session_->TouchingOn();
    this->session_->Step(ticksToEngage);
    for (int i = 0; i < 50; ++i)
    {
      this->session_->SetHandPosition(0.1 * i, 0.2 * i, 1.0 - 0.07 * i);
      this->session_->Step(7);
    }
    const Vec3 result = this->force();
    this->session_->TouchingOff();
    return result;
  };
  const Vec3 first = run();
  EXPECT_GT(first.norm(), 0.0);
  EXPECT_EQ(run(), first);
}

TEST_F(HapticSession, ARecordingReplaysBitForBit)
{
  const palpate::test::TemporaryFolder folder;
  const std::string file = folder.file("session.palpate");
  this->session_->SetSetting("RecordFile", file.c_str());
  this->engage();
  this->session_->SetHandPosition(1.0, 2.0, -2.0);
  this->session_->Step(200);
  this->session_->TouchingOff();
  EXPECT_STREQ(this->session_->GetProblem(), "");
  expectReplays(file, ticksToEngage + 200);
}

TEST_F(HapticSession, ARecordingThatBeginsBeforeThereIsAHandReplaysAndItsHandBeginsWhereItWasPut)
{
  const palpate::test::TemporaryFolder folder;
  const std::string file = folder.file("session.palpate");
  vtkNew<vtkHapticSession> fresh;
  fresh->SetSetting("VirtualTime", true);
  ASSERT_TRUE(fresh->AddSurface("surface", makePlane(100.0), nullptr));
  fresh->CommitScene();
  ASSERT_TRUE(fresh->FinishScene());
  fresh->SetSetting("RecordFile", file.c_str());
  fresh->TouchingOn();
  fresh->Step(10);
  fresh->SetHandPosition(0.0, 0.0, 7.0);
  fresh->Step(10);
  fresh->TouchingOff();
  expectReplays(file, 20);
  this->session_->SetSetting("Scale", fresh->GetSetting("Scale"));
  this->session_->SetSetting("DeviceName", "replay");
  this->session_->SetSetting("ReplayFile", file.c_str());
  this->startTouching();
  this->session_->Step(1);
  EXPECT_LT((Vec3(this->session_->GetHandPosition()) - Vec3(0.0, 0.0, 7.0)).norm(), 1e-12);
}

TEST_F(HapticSession, TheWorkspaceCanBeFittedToTheScene)
{
  this->session_->FitWorkspace();
  // the bounds of the plane are 200 u across: half their diagonal fills the workspace, whose radius is in metres
  const double half = 0.5 * std::hypot(200.0, 200.0);
  EXPECT_EQ(Vec3(this->session_->GetSettingNumbers("Offset")), Vec3::Zero());
  const double radius_m = half / this->session_->GetSetting("Scale");
  EXPECT_GT(radius_m, 0.01);
  EXPECT_LT(radius_m, 1.0);
}

TEST_F(HapticSession, NumbersThatCannotBeAreRefusedAndTheOldOnesStay)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { -1.0, std::nan(""), infinity })
  {
    EXPECT_THAT(
      errorsOf(this->session_, [&] { this->session_->SetSetting("Stiffness", bad); }).at(0), HasSubstr("stiffness"));
    EXPECT_THAT(
      errorsOf(this->session_, [&] { this->session_->SetSetting("Radius", bad); }).at(0), HasSubstr("radius"));
    EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("Scale", bad); }).at(0), HasSubstr("scale"));
    EXPECT_THAT(
      errorsOf(this->session_, [&] { this->session_->SetSetting("StrokeSpeed", bad); }).at(0), HasSubstr("Speed"));
  }
  EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("Rotation", 1.0, 1.0, 0.0, 0.0); }).at(0),
    HasSubstr("unit quaternion"));
  EXPECT_EQ(this->session_->GetSetting("Stiffness"), stiffness);
  EXPECT_EQ(this->session_->GetSetting("Radius"), 0.0);
  EXPECT_EQ(this->session_->GetSetting("Scale"), scale);
}

TEST_F(HapticSession, ARefusalIsTakenBackWhenTheSameSucceeds)
{
  const auto refused = [this](const std::function<void()>& change, const char* reason)
  {
    EXPECT_EQ(errorsOf(this->session_, change).size(), 1u);
    EXPECT_THAT(this->session_->GetProblem(), HasSubstr(reason));
  };
  refused([this] { this->session_->SetSetting("LineRadius", std::nan("")); }, "radius of lines");
  this->session_->SetSetting("LineRadius", 0.0);
  EXPECT_STREQ(this->session_->GetProblem(), "");
  refused([this] { this->session_->SetSetting("Stiffness", -1.0); }, "stiffness");
  this->session_->SetSetting("LineRadius", 0.5); // something else
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("stiffness"));
  this->session_->SetSetting("Stiffness", stiffness);
  EXPECT_STREQ(this->session_->GetProblem(), "");
  refused([this] { this->session_->SetSetting("StiffnessFeltRange", -1.0, 1.0); }, "stiffness");
  this->session_->SetSetting("StiffnessFeltRange", 0.0, 1.0);
  EXPECT_STREQ(this->session_->GetProblem(), "");
}

TEST_F(HapticSession, ASurfaceThatIsThereAgainOrNoLongerShownIsNotSaidToBeRefused)
{
  const auto showEmpty = [this]
  {
    this->session_->ClearSurfaces();
    vtkNew<vtkPolyData> empty;
    EXPECT_EQ(errorsOf(this->session_, [&] { this->session_->AddSurface("surface", empty, nullptr); }).size(), 1u);
    this->session_->CommitScene();
    EXPECT_FALSE(this->session_->FinishScene());
    EXPECT_THAT(this->session_->GetProblem(), HasSubstr("surface: it has no polygons"));
  };
  showEmpty();
  this->show(makePlane(100.0));
  EXPECT_STREQ(this->session_->GetProblem(), "");
  showEmpty();
  this->showNothing();
  EXPECT_STREQ(this->session_->GetProblem(), "");
}

TEST_F(HapticSession, AnUnknownDeviceIsRefusedByNameAndTheOldOneStays)
{
  const auto errors = errorsOf(this->session_, [&] { this->session_->SetSetting("DeviceName", "touchstone"); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("touchstone"));
  EXPECT_THAT(errors[0], HasSubstr("fed"));
  EXPECT_STREQ(this->session_->GetSettingText("DeviceName"), "fed");
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("touchstone"));
}

TEST_F(HapticSession, ASimulatedHandWithoutAStrokeDoesNotStart)
{
  this->session_->SetSetting("DeviceName", "simulated-ideal");
  const auto errors = errorsOf(this->session_, [&] { this->session_->TouchingOn(); });
  EXPECT_EQ(errors.size(), 1u);
  EXPECT_FALSE(this->session_->GetTouching());
}

TEST_F(HapticSession, ARecordingThatCannotBeReadDoesNotStart)
{
  this->session_->SetSetting("DeviceName", "replay");
  this->session_->SetSetting("ReplayFile", "nowhere.palpate");
  const auto errors = errorsOf(this->session_, [&] { this->session_->TouchingOn(); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("nowhere.palpate"));
  EXPECT_FALSE(this->session_->GetTouching());
}

TEST_F(HapticSession, ARecordFileThatCannotBeWrittenDoesNotStart)
{
  this->session_->SetSetting("RecordFile", "no/such/folder/x.palpate");
  const auto errors = errorsOf(this->session_, [&] { this->session_->TouchingOn(); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("no/such/folder/x.palpate"));
  EXPECT_FALSE(this->session_->GetTouching());
}

TEST_F(HapticSession, ASurfaceWithoutPolygonsIsRefusedByNameAndTheSceneStays)
{
  this->session_->ClearSurfaces();
  const auto errors = errorsOf(this->session_,
    [&] {
      this->session_->AddSurface("path", makePath({ Vec3::Zero(), Vec3::Ones() }), nullptr);
    });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("path: it has no polygons"));
  double bounds[6];
  EXPECT_TRUE(this->session_->GetSceneBounds(bounds));
  EXPECT_EQ(bounds[0], -100.0);
}

TEST_F(HapticSession, LinesAreTouchedOnceTheyHaveARadiusAndTheReportSaysSo)
{
  const vtkSmartPointer<vtkPolyData> both = makePlane(100.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 3 });
  both->SetLines(lines);
  this->show(both);
  EXPECT_TRUE(test::says(this->session_->GetSceneReport(), { "not touched: surface", "1 lines", "radius is 0" }));
  double flat[6], thick[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(flat));
  constexpr double radius = 2.5;
  this->session_->SetSetting("LineRadius", radius);
  this->show(both);
  EXPECT_TRUE(
    test::says(this->session_->GetSceneReport(), { "surface (lines)", "1 of 1 segments", "2.5 u", "0.0025 u" }));
  ASSERT_TRUE(this->session_->GetSceneBounds(thick));
  EXPECT_NEAR(thick[5] - flat[5], radius, 1e-6);
  const auto errors = errorsOf(this->session_, [&] { this->session_->SetSetting("LineRadius", std::nan("")); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("radius of lines"));
  EXPECT_EQ(this->session_->GetSetting("LineRadius"), radius);
}

TEST_F(HapticSession, ReportsWhatWasDropped)
{
  const vtkSmartPointer<vtkPolyData> plane = makePlane(100.0);
  plane->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
  this->show(plane);
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("surface: "));
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("1"));
}

TEST_F(HapticSession, RunsInRealTimeAndStopsWithoutForce)
{
  this->session_->SetSetting("VirtualTime", false);
  this->session_->TouchingOn();
  ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
  this->session_->TouchingOff();
  EXPECT_EQ(this->session_->GetPeriods(), this->session_->GetTicks() + this->session_->GetMissed());
  EXPECT_EQ(this->force(), Vec3::Zero());
}
