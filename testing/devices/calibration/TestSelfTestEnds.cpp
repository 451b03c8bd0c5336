// SPDX-License-Identifier: GPL-3.0-or-later
// A test ends without force, whatever the device or the person does, and says why.
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "testing/devices/calibration/SelfTested.h"

namespace palpate::test
{
namespace
{

TEST(SelfTest, PositionsWhereNoHandCanBeEndIt)
{
  for (const double leap_m : { 0.2, 10.0 }) // four times, and two hundred times, the radius
  {
    const auto leaps = [leap_m](int tick, DeviceSample& sample, SelfTestState&)
    { sample.pose_D.p.x() += tick == 700 ? leap_m : 0.0; };
    const SelfTested found = run(joystick(), "light", {}, obliging, leaps);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Aborted);
    EXPECT_EQ(found.state.reason, SelfTestReason::Impossible);
    EXPECT_NE(found.text().find("impossible positions"), std::string::npos) << found.text();
  }
}

TEST(SelfTest, UnpluggedAtAnyStepItEndsWithoutForce)
{
  for (const SelfTestStage stage : { SelfTestStage::Still, SelfTestStage::End, SelfTestStage::Middle,
         SelfTestStage::Settle, SelfTestStage::Brace, SelfTestStage::Push, SelfTestStage::Rest })
  {
    MiswiredDevice device(fineJoystick(), *handModel("light"), {});
    ASSERT_EQ(device.open(), "");
    const SelfTestPlan plan = SelfTestPlan::forDevice(device.info());
    SelfTestState state;
    DeviceCommand last;
    for (int tick = 1; tick < longest_ticks && state.verdict == SelfTestVerdict::None; ++tick)
    {
      device.lead(askedPlace_D(plan, state));
      DeviceSample sample;
      const DeviceStatus status = device.read(tick * period_s, sample);
      last = stepSelfTest(plan, sample, state.stage == stage ? DeviceStatus::Lost : status, period_s, state);
      device.write(last);
    }
    EXPECT_EQ(state.verdict, SelfTestVerdict::Aborted);
    EXPECT_EQ(state.reason, SelfTestReason::Lost);
    EXPECT_EQ(last.wrench_D.force, Vec3::Zero());
    EXPECT_EQ(last.wallCount, 0);
    EXPECT_EQ(last.viscosity_Ns_per_m, 0.0);
  }
}

TEST(SelfTest, WhyALinkWasLostIsSaidInItsWords)
{
  LinkReport link;
  link.lostFor = "another program has taken its effects away";
  link.outOfRange = 3;
  SelfTestState state;
  state.verdict = SelfTestVerdict::Aborted;
  state.reason = SelfTestReason::Lost;
  const std::string said = resultOf({}, state, link);
  EXPECT_NE(said.find(link.lostFor), std::string::npos) << said;
  EXPECT_NE(said.find("3 of its positions were outside"), std::string::npos) << said;
}

TEST(SelfTest, ALimitedRangeIsFoundAndSaid)
{
  Wiring wiring;
  wiring.travel_m.x() = 0.4 * joystick().travel_m;
  const SelfTested found = run(joystick(), "light", wiring);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  EXPECT_NEAR(c.axes[0].high_m - c.axes[0].low_m, 0.8 * joystick().travel_m, 2.0 * joystick().encoderStep_m);
  EXPECT_NEAR(c.axes[1].high_m - c.axes[1].low_m, 2.0 * joystick().travel_m, 2.0 * joystick().encoderStep_m);
  EXPECT_NE(found.text().find("less than half of the 100 mm"), std::string::npos) << found.text();
}

TEST(SelfTest, AnAxisThatIsNotMeasuredIsNotWaitedForForEver)
{
  Wiring wiring;
  wiring.sensors(0, 0) = 0.0;
  const SelfTested found = run(joystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_EQ(found.state.reason, SelfTestReason::NotMoved);
  EXPECT_EQ(found.largest_N, 0.0);
}

TEST(SelfTest, AHandThatMovesByItselfMakesItInconclusiveAndIsSaid)
{
  // Swings by 4 mm to each side, twice a second, from the first push on.
  const auto swings = [](const Vec3& asked_D, double time_s, const SelfTestState& state)
  {
    constexpr double turns_Hz = 2.0, swing_m = 4e-3;
    const bool pushed = state.stage >= SelfTestStage::Settle;
    return pushed ? Vec3(asked_D + Vec3(swing_m * std::sin(2.0 * M_PI * turns_Hz * time_s), 0, 0)) : asked_D;
  };
  const SelfTested swinging = run(joystick(), "stylus", {}, swings);
  EXPECT_EQ(swinging.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_NE(swinging.text().find("the hand moved during"), std::string::npos) << swinging.text();

  // Creeps by 3 mm a second, slow enough to count as still; but both pushes of a pair go in the same direction.
  const auto creeps = [](const Vec3& asked_D, double time_s, const SelfTestState& state)
  {
    constexpr double speed_m_per_s = 3e-3;
    return state.stage >= SelfTestStage::Settle ? Vec3(asked_D + Vec3(0, speed_m_per_s * (time_s - 40.0), 0)) : asked_D;
  };
  const SelfTested creeping = run(*deviceModel("simulated-premium"), "firm", {}, creeps);
  EXPECT_EQ(creeping.state.verdict, SelfTestVerdict::Inconclusive) << creeping.text();
  EXPECT_EQ(creeping.state.reason, SelfTestReason::PushUnclear);
  EXPECT_FALSE(calibrationFrom(creeping.plan, creeping.state, creeping.device, "2026-01-31"));
}

TEST(SelfTest, SomebodyWhoNeverHoldsStillIsNotPushed)
{
  const auto fidgets = [](const Vec3&, double time_s, const SelfTestState&)
  { return Vec3(Vec3(std::sin(20.0 * time_s), std::cos(20.0 * time_s), 0.0) * 5e-3); };
  const SelfTested found = run(joystick(), "firm", {}, fidgets);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_EQ(found.state.reason, SelfTestReason::NeverStill);
  EXPECT_EQ(found.largest_N, 0.0);
}

TEST(SelfTest, SomebodyWhoDoesNothingIsAskedNoLongerThanHalfAMinute)
{
  const SelfTested found =
    run(joystick(), "light", {}, [](const Vec3&, double, const SelfTestState&) { return Vec3(Vec3::Zero()); });
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_EQ(found.state.reason, SelfTestReason::NotMoved);
}

TEST(SelfTest, ADeviceThatRunsAwayLosesItsForceInThatTick)
{
  // Without a hand: nothing holds against the push.
  const DeviceModel& free = *deviceModel("simulated-premium");
  const auto stays = [](int, DeviceSample&, SelfTestState& state)
  {
    if (state.stage == SelfTestStage::End || state.stage == SelfTestStage::Still)
    {
      state = SelfTestState{};
      state.stage = SelfTestStage::Settle; // no hand can lead it to its ends
    }
  };
  const SelfTested found = run(free, "none", {}, obliging, stays);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Aborted) << found.text();
  EXPECT_TRUE(found.state.reason == SelfTestReason::TooFar || found.state.reason == SelfTestReason::TooFast);
  EXPECT_EQ(found.atEnd_N, Vec3::Zero());
}

/// The reason that ends the test at once while it pushes.
SelfTestReason reasonWhen(const std::function<void(DeviceSample&)>& break_, const DeadMan& deadMan, double dt_s)
{
  DeviceInfo info;
  info.abilities = {};
  info.maxForce_N = { 5.0, true };
  SelfTestState state;
  state.stage = SelfTestStage::Push;
  const SelfTestPlan plan = SelfTestPlan::forDevice(info, deadMan);
  DeviceSample sample;
  sample.buttons = 1;
  for (int tick = 0; tick < 100; ++tick)
  {
    EXPECT_EQ(state.verdict, SelfTestVerdict::None);
    static_cast<void>(stepSelfTest(plan, sample, DeviceStatus::Ok, period_s, state));
  }
  break_(sample);
  const DeviceCommand last = stepSelfTest(plan, sample, DeviceStatus::Ok, dt_s, state);
  EXPECT_EQ(last.wrench_D.force, Vec3::Zero());
  EXPECT_EQ(state.verdict, SelfTestVerdict::Aborted);
  EXPECT_EQ(stepSelfTest(plan, sample, DeviceStatus::Ok, period_s, state).wrench_D.force, Vec3::Zero());
  return state.reason;
}

TEST(SelfTest, WhateverIsUnexpectedWhileItPushesEndsTheForceInThatTick)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reasonWhen([&](DeviceSample& s) { s.pose_D.p.z() = nan; }, {}, period_s), SelfTestReason::NotFinite);
  EXPECT_EQ(reasonWhen([](DeviceSample& s) { s.pose_D.p.x() = 0.09; }, {}, period_s), SelfTestReason::TooFar);
  // 30 mm in a tick, a fifth of which counts at once: 6 m/s, where a workspace of 0.1 m allows 2.
  EXPECT_EQ(reasonWhen([](DeviceSample& s) { s.pose_D.p.x() = 0.03; }, {}, period_s), SelfTestReason::TooFast);
  EXPECT_EQ(reasonWhen([](DeviceSample& s) { s.buttons = 0; }, DeadMan{ 1, false }, period_s), SelfTestReason::LetGo);
  EXPECT_EQ(reasonWhen([](DeviceSample&) {}, {}, 0.025), SelfTestReason::Late);
}

TEST(SelfTest, ADeviceThatIsLostEndsIt)
{
  Wiring wiring;
  wiring.lostAfter_ticks = 500;
  const SelfTested found = run(joystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Aborted);
  EXPECT_EQ(found.state.reason, SelfTestReason::Lost);
}

/// A test that has heard nothing of the device for that long.
struct Unheard
{
  SelfTestPlan plan = SelfTestPlan::forDevice(SimulatedDevice(joystick(), *handModel("light"), {}).info());
  SelfTestState state;

  void wait(double duration_s)
  {
    for (int tick = 0; tick < std::lround(duration_s / period_s); ++tick)
    {
      const DeviceCommand command = stepSelfTest(this->plan, {}, DeviceStatus::Waiting, period_s, this->state);
      ASSERT_EQ(command.wrench_D.force.norm(), 0.0);
    }
  }
};

TEST(SelfTest, ADeviceThatHasNotSaidWhereTheHandIsIsWaitedForWithoutForceAndThePersonIsToldToMoveIt)
{
  Unheard check;
  check.wait(29.9);
  EXPECT_EQ(check.state.verdict, SelfTestVerdict::None);
  EXPECT_NE(askOf(check.plan, check.state).find("move the handle"), std::string::npos)
    << askOf(check.plan, check.state);
  static_cast<void>(stepSelfTest(check.plan, {}, DeviceStatus::Ok, period_s, check.state));
  EXPECT_NE(askOf(check.plan, check.state).find("still"), std::string::npos) << askOf(check.plan, check.state);
  check.wait(29.9); // counted anew
  EXPECT_EQ(check.state.verdict, SelfTestVerdict::None);
}

TEST(SelfTest, ADeviceThatNeverSaysWhereTheHandIsEndsItWithThatReason)
{
  Unheard check;
  check.wait(30.1);
  EXPECT_EQ(check.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_EQ(check.state.reason, SelfTestReason::Silent);
  EXPECT_EQ(askOf(check.plan, check.state), "");
  EXPECT_NE(resultOf(check.plan, check.state).find("not reported a position"), std::string::npos);
}

TEST(SelfTest, APersonCanStopIt)
{
  SelfTestState state;
  stopSelfTest(state);
  EXPECT_EQ(state.verdict, SelfTestVerdict::Aborted);
  EXPECT_EQ(state.reason, SelfTestReason::Stopped);
}

TEST(SelfTest, SaysWhatToDoAtEachStepAndNothingAfterwards)
{
  DeviceInfo info;
  info.deviceClass = DeviceClass::Joystick2D;
  info.maxForce_N = { 5.0, true };
  const SelfTestPlan plan = SelfTestPlan::forDevice(info);
  SelfTestState state;
  EXPECT_NE(askOf(plan, state).find("still"), std::string::npos);
  state.stage = SelfTestStage::End;
  EXPECT_NE(askOf(plan, state).find("left"), std::string::npos);
  state.up = true;
  EXPECT_NE(askOf(plan, state).find("right"), std::string::npos);
  state.axis = 1;
  EXPECT_NE(askOf(plan, state).find("away from you"), std::string::npos);
  EXPECT_EQ(resultOf(plan, state), "");
  stopSelfTest(state);
  EXPECT_EQ(askOf(plan, state), "");
  EXPECT_NE(resultOf(plan, state).find("was stopped"), std::string::npos);
}

TEST(SelfTest, ADeviceWithoutForceIsRefusedInWords)
{
  DeviceInfo info;
  info.rendersForce = false;
  EXPECT_NE(SelfTestPlan::forDevice(info).refusal().find("no force"), std::string::npos);
  info.rendersForce = true;
  EXPECT_EQ(SelfTestPlan::forDevice(info).refusal(), "");
  info.workspaceRadius_m.value = std::numeric_limits<double>::infinity();
  EXPECT_NE(SelfTestPlan::forDevice(info).refusal(), "");
}

} // namespace
} // namespace palpate::test
