// SPDX-License-Identifier: GPL-3.0-or-later
// The hand is fitted to the scene: when it is asked for, and by itself when touching begins.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkPolyData.h"

using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double small = 5.0, large = 300.0;

/// The scale of a fit to a plane of that half width, by a session that is asked for it.
double fittedScale(double half)
{
  vtkNew<vtkHapticSession> other;
  other->SetSetting("VirtualTime", true);
  other->AddSurface("plane", makePlane(half), nullptr);
  other->CommitScene();
  EXPECT_TRUE(other->FinishScene());
  other->FitWorkspace();
  return other->GetSetting("Scale");
}

class HapticSessionFit : public VirtualSession
{
protected:
  void SetUp() override { this->session_->SetHandPosition(0.0, 0.0, 1.0); }
};
} // namespace

TEST_F(HapticSessionFit, WithNothingShownItSaysWhatToDoAndThatIsGoneOnceItFits)
{
  EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->FitWorkspace(); }), ::testing::SizeIs(1));
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("show a surface"));
  this->show(makePlane(large));
  this->session_->FitWorkspace();
  EXPECT_STREQ(this->session_->GetProblem(), "");
  EXPECT_EQ(this->session_->GetSetting("Scale"), fittedScale(large));
}

// The worker takes its time: nobody is told to ask again.
TEST_F(HapticSessionFit, ASceneThatIsBeingBuiltIsFittedToOnceItIsThere)
{
  this->session_->AddSurface("plane", makePlane(large), nullptr);
  this->session_->CommitScene();
  this->session_->FitWorkspace();
  EXPECT_STREQ(this->session_->GetProblem(), "");
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_EQ(this->session_->GetSetting("Scale"), fittedScale(large));
}

TEST_F(HapticSessionFit, OnTouchItFitsToWhatIsShownBeforeOrAMomentLater)
{
  this->session_->SetSetting("FitOnTouch", true);
  this->show(makePlane(small));
  EXPECT_EQ(this->session_->GetSetting("Scale"), scale); // only when touching begins
  this->startTouching();
  EXPECT_EQ(this->session_->GetSetting("Scale"), fittedScale(small));
  this->session_->TouchingOff();
  this->startTouching();
  this->session_->Step(100);
  this->show(makePlane(large)); // handed over a moment after the touch
  EXPECT_EQ(this->session_->GetSetting("Scale"), fittedScale(large));
  this->session_->Step(2000);
  this->show(makePlane(small)); // shown later: the hand stays as it is
  EXPECT_EQ(this->session_->GetSetting("Scale"), fittedScale(large));
}

TEST_F(HapticSessionFit, WhatIsSetByHandIsNotFittedAway)
{
  this->session_->SetSetting("FitOnTouch", true);
  this->session_->SetSetting("Scale", 123.0);
  this->show(makePlane(large));
  this->startTouching();
  EXPECT_EQ(this->session_->GetSetting("Scale"), 123.0);
}

TEST_F(HapticSessionFit, AnotherDeviceThanTheOneThatRunsIsSaidUntilItRuns)
{
  this->show(makePlane(large));
  this->session_->SetSetting("DeviceName", "fed");
  this->startTouching();
  this->session_->SetSetting("DeviceName", "mouse");
  this->session_->Step(1);
  EXPECT_TRUE(palpate::test::says(this->session_->GetWarning(), { "fed still", "to use mouse" }));
  this->session_->TouchingOff();
  this->startTouching();
  this->session_->Step(1);
  EXPECT_STREQ(this->session_->GetWarning(), "");
}
