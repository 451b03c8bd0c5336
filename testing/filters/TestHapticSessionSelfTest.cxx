// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "devices/calibration/CalibrationFiles.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace
{
namespace fs = std::filesystem;

/// A check in virtual time, with a folder of its own for what is kept.
class HapticSessionSelfTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->session_->VirtualTimeOn();
    this->session_->SetDeviceName("simulated-joystick");
    this->session_->SetCalibrationFolder(this->folder_.c_str());
  }

  void finish()
  {
    constexpr int longest_ticks = 100'000, atOnce = 100;
    for (int i = 0; i < longest_ticks / atOnce && this->session_->GetSelfTestState() == vtkHapticSession::CheckRuns;
         ++i)
    {
      this->session_->Step(atOnce);
    }
  }

  const palpate::test::TemporaryFolder temporary_;
  const fs::path folder_ = this->temporary_.path() / "calibration"; // not there yet
  vtkNew<vtkHapticSession> session_;
};

TEST_F(HapticSessionSelfTest, PassesOnASimulatedDeviceAndSaysWhatToDoMeanwhile)
{
  this->session_->StartSelfTest();
  ASSERT_EQ(this->session_->GetSelfTestState(), vtkHapticSession::CheckRuns) << this->session_->GetProblem();
  EXPECT_THAT(this->session_->GetSelfTestAsk(), HasSubstr("still"));
  EXPECT_STREQ(this->session_->GetSelfTestResult(), "");
  EXPECT_EQ(this->session_->GetSelfTestProgress(), 0.0);
  this->finish();
  EXPECT_EQ(this->session_->GetSelfTestState(), vtkHapticSession::CheckPassed);
  EXPECT_STREQ(this->session_->GetSelfTestAsk(), "");
  EXPECT_THAT(this->session_->GetSelfTestResult(), HasSubstr("The device works."));
  EXPECT_EQ(this->session_->GetSelfTestProgress(), 1.0);
}

TEST_F(HapticSessionSelfTest, WhatItFoundIsKeptAndAppliedFromThenOn)
{
  this->session_->StartSelfTest();
  this->finish();
  ASSERT_TRUE(this->session_->KeepCalibration()) << this->session_->GetProblem();
  const KeptCalibration kept = loadCalibration(this->folder_.string(), "simulated-joystick", "");
  ASSERT_TRUE(kept.calibration) << kept.problem;

  const AxisCalibration& x = kept.calibration->axes[0];
  EXPECT_NEAR(x.low_m, -0.05, 1e-4); // its stops, to a step of 0.1 mm
  EXPECT_NEAR(x.high_m, 0.05, 1e-4);

  // As if it ended at 30 mm on the right: the middle, -10 mm for the driver, is then the origin.
  Calibration shorter = *kept.calibration;
  shorter.axes[0].low_m = -0.05;
  shorter.axes[0].high_m = 0.03;
  ASSERT_EQ(saveCalibration(this->folder_.string(), shorter), "");
  this->session_->SetScale(1.0);
  this->session_->AddStrokePoint(0.0, 0.0, 0.0);
  this->session_->TouchingOn();
  this->session_->Step(1);
  EXPECT_DOUBLE_EQ(this->session_->GetHandPosition()[0], 0.01);
}

TEST_F(HapticSessionSelfTest, StoppedItSaysSoAndThereIsNothingToKeep)
{
  this->session_->StartSelfTest();
  this->session_->Step(10);
  this->session_->StopSelfTest();
  EXPECT_EQ(this->session_->GetSelfTestState(), vtkHapticSession::CheckAborted);
  EXPECT_THAT(this->session_->GetSelfTestResult(), HasSubstr("it was stopped"));
  EXPECT_THAT(errorsOf(this->session_, [this] { EXPECT_FALSE(this->session_->KeepCalibration()); }), SizeIs(1));
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("nothing to keep"));
  EXPECT_FALSE(fs::exists(this->folder_));
}

TEST_F(HapticSessionSelfTest, HasTheDeviceForItself)
{
  this->session_->StartSelfTest();
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->TouchingOn(); }), SizeIs(1));
  EXPECT_FALSE(this->session_->GetTouching());
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("being checked"));
  this->session_->StopSelfTest();

  this->session_->AddStrokePoint(0.0, 0.0, 0.0);
  this->session_->TouchingOn();
  ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->StartSelfTest(); }), SizeIs(1));
  EXPECT_EQ(this->session_->GetSelfTestState(), vtkHapticSession::CheckAborted); // still that of the check before
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("let go first"));
}

TEST_F(HapticSessionSelfTest, ADeviceWithoutForceIsRefused)
{
  this->session_->SetDeviceName("fed");
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->StartSelfTest(); }), SizeIs(1));
  EXPECT_EQ(this->session_->GetSelfTestState(), vtkHapticSession::CheckNone);
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("no force"));
}

TEST_F(HapticSessionSelfTest, ADamagedCalibrationIsNamedWhereTheDeviceIsListedAndOpened)
{
  fs::create_directories(this->folder_);
  const std::string file = calibrationFile(this->folder_.string(), "simulated-joystick", "");
  std::ofstream(file) << "nonsense";
  this->session_->SetCalibrationFolder("");
  this->session_->SetCalibrationFolder(this->folder_.c_str());
  for (int i = 0; i < this->session_->GetNumberOfKnownDevices(); ++i)
  {
    const bool joystick = std::string(this->session_->GetKnownDeviceName(i)) == "simulated-joystick";
    EXPECT_EQ(std::string(this->session_->GetKnownDeviceProblem(i)).find(file) != std::string::npos, joystick);
  }
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->TouchingOn(); }), SizeIs(1));
  EXPECT_FALSE(this->session_->GetTouching());
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr(file));
}
} // namespace
