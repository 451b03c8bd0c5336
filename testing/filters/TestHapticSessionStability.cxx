// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "devices/simulated/DeviceModels.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/recording/Recording.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace
{
constexpr double speed = 0.05; // m/s
constexpr double start = 80.0; // u above the plane: 1.6 s of free air, longer than the engage ramp
constexpr double goal = -2.0;  // u, where the stroke turns
constexpr int ticksInFreeAir = 1500;
constexpr int ticksToTurn = 1640; // (start - goal) / scale / speed / period

/// A hand that is led straight down onto the plane z = 0 and back, in virtual time, one tick at a time.
class HapticSessionStability : public VirtualSession
{
protected:
  void SetUp() override
  {
    this->session_->SetSetting("StrokeSpeed", speed);
    this->session_->SetSetting("DeviceName", "simulated-generic");
    this->session_->AddStrokePoint(0.0, 0.0, start);
    this->session_->AddStrokePoint(0.0, 0.0, goal);
    this->show(makePlane(100.0));
  }

  /// Heights of the hand in each of so many ticks after the start [u]; without a force if it is let go.
  std::vector<double> heights(int ticks, bool release = false)
  {
    this->startTouching();
    if (release)
    {
      this->session_->Release();
    }
    std::vector<double> z;
    for (int i = 0; i < ticks; ++i)
    {
      this->session_->Step(1);
      z.push_back(this->hand_W().z());
    }
    this->session_->TouchingOff();
    return z;
  }

  /// The theoretical limit for a device by its own description [N/m].
  static double largest(const std::string& device, const LoopSettings& loop)
  {
    return stabilityLimits(infoOf(*deviceModel(device)), loop).largest_N_per_m;
  }

  [[nodiscard]] Vec3 hand_W() const { return Vec3(this->session_->GetHandPosition()); }
  [[nodiscard]] Vec3 force_W() const { return Vec3(this->session_->GetForce()); }
};

std::size_t firstDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
}
} // namespace

TEST_F(HapticSessionStability, IsOnByDefault)
{
  EXPECT_TRUE(this->session_->IsOn("Passivity"));
  EXPECT_TRUE(this->session_->IsOn("LimitStiffness"));
  EXPECT_EQ(static_cast<int>(this->session_->GetSetting("VelocityMethod")), vtkHapticSession::AdaptiveWindow);
  EXPECT_EQ(this->session_->GetSetting("Delay"), 0);
  EXPECT_STREQ(this->session_->GetSettingText("Hand"), "stylus");
}

TEST_F(HapticSessionStability, TheStiffnessIsCutToWhatTheDeviceCanHoldUnlessToldOtherwise)
{
  const double most = deviceModel("simulated-joystick")->maxStiffness_N_per_m;
  ASSERT_LT(most, stiffness);
  this->session_->SetSetting("DeviceName", "simulated-joystick");
  this->startTouching();
  this->session_->Step(1);
  EXPECT_EQ(this->session_->GetStiffnessUsed(), most);
  EXPECT_TRUE(this->session_->GetStiffnessLimited());
  EXPECT_EQ(this->session_->GetSetting("Stiffness"), stiffness);
  this->session_->SetSetting("LimitStiffness", false);
  this->session_->Step(1);
  EXPECT_EQ(this->session_->GetStiffnessUsed(), stiffness);
  EXPECT_FALSE(this->session_->GetStiffnessLimited());
}

TEST_F(HapticSessionStability, AForceBeyondTheLargestThatIsGivenIsCutAndSaid)
{
  constexpr double stiff = 2000.0, scale = 1000.0, shallow = 1.0, deep = 2.0; // N/m, u/m, u, u
  constexpr double most = 3.0;                                                // N, without a device that has a limit
  this->session_->SetSetting("DeviceName", "fed");
  this->session_->SetSetting("Scale", scale);
  this->session_->SetSetting("Stiffness", stiff);
  this->session_->SetSetting("LimitStiffness", false);
  this->session_->SetHandPosition(0.0, 0.0, 10.0);
  this->startTouching();
  this->session_->Step(ticksInFreeAir);
  for (const double depth : { shallow, deep, shallow })
  {
    this->session_->SetHandPosition(0.0, 0.0, -depth);
    this->session_->Step(300);
    const double asked = stiff * depth / scale;
    EXPECT_NEAR(this->session_->GetForceMagnitude(), std::min(asked, most), 1e-9) << depth;
    EXPECT_EQ(this->session_->GetForceLimited(), asked > most) << depth;
  }
  this->session_->TouchingOff();
}

TEST_F(HapticSessionStability, HowStiffTheDeviceCanBeIsKnownBeforeItRunsAndFollowsTheSettings)
{
  PassivityPlan plan;
  plan.enabled = true;
  const double plain = largest("simulated-generic", { period_s, 0.0, plan });
  EXPECT_EQ(this->session_->GetLargestStiffness(), plain);
  plan.delay_ticks = 4.0;
  this->session_->SetSetting("Delay", 4);
  EXPECT_EQ(this->session_->GetLargestStiffness(), largest("simulated-generic", { period_s, 0.0, plan }));
  EXPECT_LT(this->session_->GetLargestStiffness(), plain);
  plan.enabled = false;
  this->session_->SetSetting("Passivity", false);
  EXPECT_EQ(this->session_->GetLargestStiffness(), largest("simulated-generic", { period_s, 0.0, plan }));
  EXPECT_THAT(this->session_->GetStabilityText(), HasSubstr("without the passivity controller"));
}

TEST_F(HapticSessionStability, TheSentenceIsThatOfTheChosenDeviceAndOfTheRunningOneWhileItRuns)
{
  const std::string generic = this->session_->GetStabilityText();
  EXPECT_THAT(generic, HasSubstr("0.1 kg and 1 N s/m"));
  this->startTouching();
  this->session_->SetSetting("DeviceName", "fed");
  EXPECT_EQ(this->session_->GetStabilityText(), generic);
  this->session_->TouchingOff();
  EXPECT_THAT(this->session_->GetStabilityText(), HasSubstr("renders no force"));
  EXPECT_TRUE(std::isinf(this->session_->GetLargestStiffness()));
}

/// Damping (1/2 + delay + reserve) K T from the start, at most one K T more to repay, with v T = displacement of the
/// last tick.
class HapticSessionPassivity
  : public HapticSessionStability
  , public ::testing::WithParamInterface<int>
{
};

TEST_P(HapticSessionPassivity, AddsForceOnTheWayInAndNoneInFreeAir)
{
  const int delay = GetParam();
  const PassivityPlan plan;
  this->session_->SetSetting("VelocityMethod", vtkHapticSession::BackwardDifference);
  this->session_->SetSetting("Delay", delay);
  this->startTouching();
  double before = start;
  int inward = 0;
  for (int i = 0; i < ticksToTurn; ++i)
  {
    this->session_->Step(1);
    const double way_m = (before - this->hand_W().z()) / scale;
    before = this->hand_W().z();
    const bool touches = this->session_->GetContacts() > 0;
    const double least = touches && way_m > 0.0 ? (0.5 + delay + plan.reserve) * stiffness * way_m : 0.0;
    const double most = least > 0.0 ? least + plan.repay * stiffness * way_m : 0.0;
    if (!touches || way_m > 0.0)
    {
      ASSERT_GE(this->session_->GetStabiliserForce(), least * (1.0 - 1e-9)) << "tick " << i;
      ASSERT_LE(this->session_->GetStabiliserForce(), most * (1.0 + 1e-9)) << "tick " << i;
    }
    inward += touches && way_m > 0.0;
  }
  EXPECT_GT(inward, 20);
}

INSTANTIATE_TEST_SUITE_P(Delays, HapticSessionPassivity, ::testing::Values(0, 2));

TEST_F(HapticSessionStability, WithoutPassivityTheForceIsTheSpringsAlone)
{
  this->session_->SetSetting("Passivity", false);
  this->startTouching();
  int inward = 0;
  for (int i = 0; i < ticksToTurn; ++i)
  {
    this->session_->Step(1);
    ASSERT_EQ(this->session_->GetStabiliserForce(), 0.0);
    const double depth_m = std::max(0.0, -this->hand_W().z()) / scale;
    ASSERT_NEAR(this->force_W().z(), stiffness * depth_m, 1e-12);
    inward += depth_m > 0.0;
  }
  EXPECT_GT(inward, 20);
}

TEST_F(HapticSessionStability, ThePeakOfTheStabiliserIsTheLargestOfAllTicks)
{
  this->startTouching();
  double largest_N = 0.0;
  for (int i = 0; i < ticksToTurn; ++i)
  {
    this->session_->Step(1);
    largest_N = std::max(largest_N, this->session_->GetStabiliserForce());
  }
  EXPECT_GT(largest_N, 0.0);
  EXPECT_EQ(this->session_->GetPeakStabiliserForce(), largest_N);
}

TEST_F(HapticSessionStability, TheEnergyIsTheSumOfForceTimesWay)
{
  this->startTouching();
  double sum_J = 0.0;
  Vec3 held_W = Vec3::Zero();
  Vec3 before_W(0.0, 0.0, start);
  for (int i = 0; i < 2 * ticksToTurn; ++i)
  {
    this->session_->Step(1);
    sum_J += held_W.dot(this->hand_W() - before_W) / scale;
    held_W = this->force_W();
    before_W = this->hand_W();
    ASSERT_NEAR(this->session_->GetDeliveredEnergy(), sum_J, 1e-15) << "tick " << i;
    ASSERT_GE(this->session_->GetPeakExcessEnergy(), this->session_->GetExcessEnergy());
  }
  EXPECT_LT(sum_J, -1e-6) << "the controller takes energy from a hand that goes in and out";
}

TEST_F(HapticSessionStability, ADelayIsThatOfTheSimulatedLinkToo)
{
  constexpr int delay = 5;
  this->session_->SetSetting("Passivity", false); // else the force would depend on the delay, not only its time
  const std::vector<double> free = this->heights(ticksToTurn, true);
  const std::vector<double> pushed = this->heights(ticksToTurn);
  this->session_->SetSetting("Delay", delay);
  const std::vector<double> late = this->heights(ticksToTurn);
  ASSERT_LT(firstDifference(pushed, free), free.size());
  EXPECT_EQ(firstDifference(late, free), firstDifference(pushed, free) + delay);
}

TEST_F(HapticSessionStability, NobodyHoldsADeviceWhoseHandIsNone)
{
  this->session_->SetSetting("Hand", "none");
  EXPECT_EQ(this->heights(ticksInFreeAir), std::vector<double>(ticksInFreeAir, start));
  this->session_->SetSetting("Hand", "light");
  EXPECT_LT(this->heights(ticksInFreeAir).back(), start - 50.0); // led 75 u down by then, less a lag
}

TEST_F(HapticSessionStability, OnlySimulatedDevicesAreHeld)
{
  EXPECT_TRUE(this->session_->GetDeviceTakesHand());
  for (const char* name : { "fed", "replay" })
  {
    this->session_->SetSetting("DeviceName", name);
    EXPECT_FALSE(this->session_->GetDeviceTakesHand()) << name;
  }
}

TEST_F(HapticSessionStability, EverySettingReachesTheRecording)
{
  const palpate::test::TemporaryFolder folder;
  const std::string file = folder.file("stability.palpate");
  this->session_->SetSetting("RecordFile", file.c_str());
  this->session_->SetSetting("VelocityMethod", vtkHapticSession::LowPass);
  this->session_->SetSetting("Delay", 3);
  this->heights(10);
  const auto recording = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(recording)) << std::get<std::string>(recording);
  const HapticParameters& parameters = std::get<Recording>(recording).parameters;
  EXPECT_EQ(parameters.velocity.method, VelocityMethod::LowPass);
  EXPECT_TRUE(parameters.passivity.enabled);
  EXPECT_EQ(parameters.passivity.delay_ticks, 3.0);
  EXPECT_EQ(parameters.stiffnessLimit_N_per_m, this->session_->GetLargestStiffness());
}

TEST_F(HapticSessionStability, SettingsThatCannotBeAreRefusedAndTheOldOnesStay)
{
  for (const int ticks : { -1, 17 })
  {
    EXPECT_THAT(
      errorsOf(this->session_, [&] { this->session_->SetSetting("Delay", ticks); }), ElementsAre(HasSubstr("delay")));
  }
  for (const int method : { -1, 3 })
  {
    EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("VelocityMethod", method); }),
      ElementsAre(HasSubstr("velocity: must be 0 (backward difference), 1 (low pass) or 2 (adaptive window)")));
  }
  EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("Hand", "third"); }),
    ElementsAre(AllOf(HasSubstr("third"), HasSubstr("none, light, stylus, firm"))));
  EXPECT_EQ(this->session_->GetSetting("Delay"), 0);
  EXPECT_EQ(static_cast<int>(this->session_->GetSetting("VelocityMethod")), vtkHapticSession::AdaptiveWindow);
  EXPECT_STREQ(this->session_->GetSettingText("Hand"), "stylus");
}
