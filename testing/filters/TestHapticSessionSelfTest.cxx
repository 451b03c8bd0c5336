// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "devices/calibration/CalibrationFiles.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace
{
namespace fs = std::filesystem;

/// A check in virtual time, with a folder of its own for its results.
class HapticSessionSelfTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->session_->SetSetting("VirtualTime", true);
    this->session_->SetSetting("DeviceName", "simulated-joystick");
    this->session_->GetDeviceCheck()->SetCalibrationFolder(this->folder_.c_str());
  }

  void finish()
  {
    constexpr int longest_ticks = 100'000, atOnce = 100;
    for (int i = 0;
         i < longest_ticks / atOnce && this->session_->GetDeviceCheck()->GetState() == vtkHapticDeviceCheck::CheckRuns;
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
  this->session_->GetDeviceCheck()->Start();
  ASSERT_EQ(this->session_->GetDeviceCheck()->GetState(), vtkHapticDeviceCheck::CheckRuns)
    << this->session_->GetProblem();
  EXPECT_THAT(this->session_->GetDeviceCheck()->GetAsk(), HasSubstr("still"));
  EXPECT_STREQ(this->session_->GetDeviceCheck()->GetResult(), "");
  EXPECT_EQ(this->session_->GetDeviceCheck()->GetProgress(), 0.0);
  this->finish();
  EXPECT_EQ(this->session_->GetDeviceCheck()->GetState(), vtkHapticDeviceCheck::CheckPassed);
  EXPECT_STREQ(this->session_->GetDeviceCheck()->GetAsk(), "");
  EXPECT_THAT(this->session_->GetDeviceCheck()->GetResult(), HasSubstr("The device works."));
  EXPECT_EQ(this->session_->GetDeviceCheck()->GetProgress(), 1.0);
}

TEST_F(HapticSessionSelfTest, WhatItFoundIsKeptAndAppliedFromThenOn)
{
  this->session_->GetDeviceCheck()->Start();
  this->finish();
  ASSERT_TRUE(this->session_->GetDeviceCheck()->KeepCalibration()) << this->session_->GetProblem();
  const KeptCalibration kept = loadCalibration(this->folder_.string(), "simulated-joystick", "");
  ASSERT_TRUE(kept.value) << kept.problem;

  const AxisCalibration& x = kept.value->axes[0];
  EXPECT_NEAR(x.low_m, -0.05, 1e-4); // its stops, to a step of 0.1 mm
  EXPECT_NEAR(x.high_m, 0.05, 1e-4);

  // As if it ended at 30 mm on the right: the middle, -10 mm for the driver, is then the origin.
  Calibration shorter = *kept.value;
  shorter.axes[0].low_m = -0.05;
  shorter.axes[0].high_m = 0.03;
  ASSERT_EQ(saveCalibration(this->folder_.string(), shorter), "");
  this->session_->SetSetting("Scale", 1.0);
  this->session_->AddStrokePoint(0.0, 0.0, 0.0);
  this->session_->TouchingOn();
  this->session_->Step(1);
  EXPECT_DOUBLE_EQ(this->session_->GetHandPosition()[0], 0.01);
}

TEST_F(HapticSessionSelfTest, StoppedItSaysSoAndThereIsNothingToKeep)
{
  this->session_->GetDeviceCheck()->Start();
  this->session_->Step(10);
  this->session_->GetDeviceCheck()->Stop();
  EXPECT_EQ(this->session_->GetDeviceCheck()->GetState(), vtkHapticDeviceCheck::CheckAborted);
  EXPECT_THAT(this->session_->GetDeviceCheck()->GetResult(), HasSubstr("was stopped"));
  EXPECT_THAT(
    errorsOf(this->session_, [this] { EXPECT_FALSE(this->session_->GetDeviceCheck()->KeepCalibration()); }), SizeIs(1));
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("no result to save"));
  EXPECT_FALSE(fs::exists(this->folder_));
}

TEST_F(HapticSessionSelfTest, HasTheDeviceForItself)
{
  this->session_->GetDeviceCheck()->Start();
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->TouchingOn(); }), SizeIs(1));
  EXPECT_FALSE(this->session_->GetTouching());
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("device check is running"));
  this->session_->GetDeviceCheck()->Stop();

  this->session_->AddStrokePoint(0.0, 0.0, 0.0);
  this->session_->TouchingOn();
  ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->GetDeviceCheck()->Start(); }), SizeIs(1));
  EXPECT_EQ(
    this->session_->GetDeviceCheck()->GetState(), vtkHapticDeviceCheck::CheckAborted); // still that of the check before
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("release the touch"));
}

TEST_F(HapticSessionSelfTest, ADeviceWithoutForceIsRefused)
{
  this->session_->SetSetting("DeviceName", "fed");
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->GetDeviceCheck()->Start(); }), SizeIs(1));
  EXPECT_EQ(this->session_->GetDeviceCheck()->GetState(), vtkHapticDeviceCheck::CheckNone);
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("no force"));
}

TEST_F(HapticSessionSelfTest, ADamagedCalibrationIsNamedWhereTheDeviceIsListedAndOpened)
{
  fs::create_directories(this->folder_);
  const std::string file = calibrationFile(this->folder_.string(), "simulated-joystick", "");
  std::ofstream(file) << "nonsense";
  this->session_->GetDeviceCheck()->SetCalibrationFolder("");
  this->session_->GetDeviceCheck()->SetCalibrationFolder(this->folder_.c_str());
  for (int i = 0; i < this->session_->GetDevices()->GetNumberOfDevices(); ++i)
  {
    const bool joystick = std::string(this->session_->GetDevices()->GetName(i)) == "simulated-joystick";
    EXPECT_EQ(std::string(this->session_->GetDevices()->GetProblem(i)).find(file) != std::string::npos, joystick);
  }
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->TouchingOn(); }), SizeIs(1));
  EXPECT_FALSE(this->session_->GetTouching());
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr(file));
}
} // namespace
