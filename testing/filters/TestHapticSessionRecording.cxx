// SPDX-License-Identifier: GPL-3.0-or-later
// A recording that is begun, ended, saved and played again through the session.
#include <cmath>
#include <filesystem>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/core/Types.h"
#include "haptics/recording/Recording.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
/// A fed hand that presses on the plane z = 0, 2 u deep.
class HapticSessionRecording : public VirtualSession
{
protected:
  void SetUp() override
  {
    this->session_->SetHandPosition(0.0, 0.0, 1.0);
    this->show(makePlane(100.0));
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->moveTo(0.0);
    this->session_->Step(100);
  }

  void moveTo(double x) { this->session_->SetHandPosition(x, 0.0, -2.0); }

  /// Where the hand was, tick by tick.
  std::vector<Vec3> record(int ticks)
  {
    std::vector<Vec3> way;
    this->session_->SetSetting("Recording", true);
    for (int tick = 0; tick < ticks; ++tick)
    {
      this->moveTo(0.1 * tick);
      this->session_->Step(1);
      way.emplace_back(this->session_->GetHandPosition());
    }
    this->session_->SetSetting("Recording", false);
    return way;
  }

  const palpate::test::TemporaryFolder folder_;
};
} // namespace

TEST_F(HapticSessionRecording, BegunWhileTouchingIsSavedUnderANameAndOpensThere)
{
  EXPECT_STREQ(this->session_->GetRecordingText(), "");
  this->record(300);
  const std::string working = this->session_->GetRecordedFile();
  EXPECT_THAT(
    this->session_->GetRecordingText(), HasSubstr("0.3 s recorded in " + working + ": save it, or replay it"));
  EXPECT_STREQ(this->session_->GetSettingText("ReplayFile"), working.c_str());
  const std::string named = this->folder_.file("kept.palpate");
  this->session_->SaveRecording(named.c_str());
  EXPECT_STREQ(this->session_->GetProblem(), "");
  EXPECT_STREQ(this->session_->GetRecordedFile(), named.c_str());
  EXPECT_STREQ(this->session_->GetSettingText("ReplayFile"), named.c_str());
  EXPECT_FALSE(std::filesystem::exists(working)) << "it is not there twice";
  const auto recording = readRecording(named);
  ASSERT_TRUE(std::holds_alternative<Recording>(recording)) << std::get<std::string>(recording);
  const ReplayResult result = replay(std::get<Recording>(recording));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 300U);
}

TEST_F(HapticSessionRecording, WantedBeforeATouchBeginsAndEndsWithIt)
{
  this->session_->TouchingOff();
  this->session_->SetSetting("Recording", true);
  EXPECT_THAT(this->session_->GetRecordingText(), HasSubstr("begins with Touch"));
  this->startTouching();
  this->session_->Step(1200);
  EXPECT_THAT(this->session_->GetRecordingText(), HasSubstr("1.2 s so far"));
  this->session_->TouchingOff();
  EXPECT_FALSE(this->session_->IsOn("Recording"));
  EXPECT_THAT(this->session_->GetRecordingText(), HasSubstr("1.2 s recorded"));
  std::filesystem::remove(this->session_->GetRecordedFile());
}

TEST_F(HapticSessionRecording, PlayedAgainMovesTheHandWhereItWasWhateverScaleIsSetNow)
{
  const std::vector<Vec3> way = this->record(60);
  this->session_->TouchingOff();
  this->session_->SetSetting("Scale", 17.0);
  this->session_->SetSetting("Offset", 1.0, 2.0, 3.0);
  this->session_->SetSetting("DeviceName", "replay");
  this->startTouching();
  EXPECT_EQ(this->session_->GetSetting("Scale"), scale);
  for (std::size_t tick = 0; tick < way.size(); ++tick)
  {
    this->session_->Step(1);
    ASSERT_LT((Vec3(this->session_->GetHandPosition()) - way[tick]).norm(), 1e-9) << tick;
  }
  EXPECT_STREQ(this->session_->GetWarning(), "") << "what it touched is shown";
  std::filesystem::remove(this->session_->GetRecordedFile());
}

TEST_F(HapticSessionRecording, AHandWhoseMapChangedOnTheWayIsPlayedWhereItWas)
{
  this->session_->SetSetting("Recording", true);
  std::vector<Vec3> way;
  for (int tick = 0; tick < 40; ++tick)
  {
    if (tick == 20)
    {
      this->session_->SetSetting("Scale", 2.5 * scale);
      this->session_->SetSetting("Rotation", 0.5, 0.5, 0.5, 0.5);
    }
    this->moveTo(tick);
    this->session_->Step(1);
    way.emplace_back(this->session_->GetHandPosition());
  }
  this->session_->TouchingOff();
  this->session_->SetSetting("DeviceName", "replay");
  this->startTouching();
  for (std::size_t tick = 0; tick < way.size(); ++tick)
  {
    this->session_->Step(1);
    ASSERT_LT((Vec3(this->session_->GetHandPosition()) - way[tick]).norm(), 1e-9) << tick;
  }
  std::filesystem::remove(this->session_->GetRecordedFile());
}

TEST_F(HapticSessionRecording, WhoseSceneIsGoneSaysSoAndItsHandMovesAllTheSame)
{
  const std::vector<Vec3> way = this->record(60);
  this->session_->TouchingOff();
  this->show(makePlane(33.0));
  this->session_->SetSetting("DeviceName", "replay");
  this->startTouching();
  this->session_->Step(1);
  EXPECT_THAT(this->session_->GetWarning(), HasSubstr("differs from the recorded one"));
  this->session_->ClearSurfaces();
  this->session_->CommitScene();
  EXPECT_FALSE(this->session_->FinishScene());
  this->session_->Step(1);
  EXPECT_THAT(this->session_->GetWarning(), HasSubstr("recorded scene is not visible"));
  EXPECT_LT((Vec3(this->session_->GetHandPosition()) - way[1]).norm(), 1e-9);
  this->show(makePlane(100.0));
  this->session_->Step(1);
  EXPECT_STREQ(this->session_->GetWarning(), "") << "it is shown again";
  std::filesystem::remove(this->session_->GetRecordedFile());
}

TEST_F(HapticSessionRecording, WhatCannotBeSavedIsRefusedInOneLineAndNothingIsLost)
{
  const auto refusedBy = [this](const std::string& file)
  { return errorsOf(this->session_, [&] { this->session_->SaveRecording(file.c_str()); }); };
  EXPECT_THAT(refusedBy(this->folder_.file("a")).at(0), HasSubstr("record first"));
  this->session_->SetSetting("Recording", true);
  this->session_->Step(10);
  EXPECT_THAT(refusedBy(this->folder_.file("a")).at(0), HasSubstr("stop recording"));
  this->session_->SetSetting("Recording", false);
  const std::string working = this->session_->GetRecordedFile();
  EXPECT_THAT(refusedBy("/no/such/folder/a").at(0), HasSubstr("/no/such/folder/a"));
  EXPECT_STREQ(this->session_->GetRecordedFile(), working.c_str());
  EXPECT_TRUE(std::filesystem::exists(working));
  std::filesystem::remove(working);
}

TEST_F(HapticSessionRecording, AFileThatCannotBeWrittenIsSaidAndTouchingGoesOn)
{
  this->session_->SetSetting("RecordFile", "/no/such/folder/a");
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->SetSetting("Recording", true); }).at(0),
    HasSubstr("/no/such/folder"));
  EXPECT_FALSE(this->session_->IsOn("Recording"));
  EXPECT_TRUE(this->session_->GetTouching());
}
