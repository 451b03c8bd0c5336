// SPDX-License-Identifier: GPL-3.0-or-later
// A device's walls, dampers and faults are found.
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

TEST(SelfTest, WallsAndViscosityThatAreRightAreFeltOnEachSideOfEachAxis)
{
  const SelfTested found = run(fineJoystick(), "light", {});
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_EQ(heldProofOf(found.plan, found.state), HeldProof::Felt) << found.text();
  EXPECT_EQ(found.calibration().held, HeldProof::Felt);
  for (int motor = 0; motor < 2; ++motor)
  {
    for (const double share : findHeld(found.plan, found.state, motor).walls)
    {
      EXPECT_NEAR(share, 1.0, 0.05); // the hand lags by a fortieth of the rise, each slope by less
    }
  }
}

TEST(SelfTest, OneWallThatIsWrongOnOneSideKeepsAllWallsWithTheProgram)
{
  const std::vector<std::pair<double, HeldProof>> kinds = { { -1.0, HeldProof::WrongWay }, { 0.0, HeldProof::NoForce },
    { 0.6, HeldProof::WrongSize }, { 1.5, HeldProof::WrongSize }, { 10.0, HeldProof::WrongSize } };
  for (const auto& [share, proof] : kinds)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      Wiring wiring;
      wiring.sides[side] = share;
      DeviceModel model = fineJoystick();
      model.maxStiffness_N_per_m = 1e4; // or the simulated device would not give the stiffest
      const SelfTested found = run(model, "light", wiring);
      EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
      EXPECT_EQ(heldProofOf(found.plan, found.state), proof) << share << " on side " << side << ": " << found.text();
      EXPECT_EQ(found.calibration().held, proof);
      EXPECT_NE(found.text().find("The program renders the walls"), std::string::npos);
      EXPECT_LE(found.largest_N, found.plan.push_N * (1.0 + 1e-12));
    }
  }
}

TEST(SelfTest, ADamperThatDrivesOrDoesNothingIsFelt)
{
  for (const auto& [brake, proof] : { std::pair(-0.5, HeldProof::Drives), std::pair(0.0, HeldProof::NoBrake) })
  {
    Wiring wiring;
    wiring.brake = brake;
    const SelfTested found = run(fineJoystick(), "light", wiring);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
    EXPECT_EQ(heldProofOf(found.plan, found.state), proof) << found.text();
  }
}

TEST(SelfTest, AWallThatTakesTheHandAwayIsLetGoInThatTickAndTheRestIsStillTested)
{
  bool taken = false;
  const auto takesAway = [&taken](int, DeviceSample& sample, SelfTestState& state)
  {
    const bool pushedIntoWall =
      state.stage == SelfTestStage::Push && pushRounds[static_cast<std::size_t>(state.round)].kind == PushKind::Wall;
    if (pushedIntoWall && !taken && state.stage_s > 0.2)
    {
      sample.pose_D.p.x() += 0.02; // further than a third of the workspace
      taken = true;
    }
  };
  const SelfTested found = run(fineJoystick(), "light", {}, obliging, takesAway);
  EXPECT_TRUE(taken);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_EQ(found.calibration().held, HeldProof::WrongWay);
}

TEST(SelfTest, AMotorThatPushesAlongBothAxesIsAFault)
{
  Wiring wiring;
  wiring.motors(1, 0) = 0.8;
  const SelfTested found = run(fineJoystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
  EXPECT_EQ(found.state.reason, SelfTestReason::BothAxes);
  EXPECT_NE(found.text().find("two axes at once"), std::string::npos) << found.text();
}

TEST(SelfTest, TwoMotorsBehindOneAxisOfAStickAreAFault)
{
  Wiring wiring;
  wiring.motors << 1, 1, 0, 0, 0, 0, 0, 0, 1;
  const SelfTested found = run(fineJoystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
  EXPECT_EQ(found.state.reason, SelfTestReason::SharedAxis);
}

TEST(SelfTest, ADeviceThatAnswersOnceThePushIsOverIsAFault)
{
  Wiring wiring;
  wiring.late_ticks = 200;
  const SelfTested found = run(fineJoystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
  EXPECT_EQ(found.state.reason, SelfTestReason::AnswersLate);
  EXPECT_NE(found.text().find("only after the force pulse"), std::string::npos) << found.text();
}

TEST(SelfTest, ADeviceThatAnswersOnlySomePushesIsAFault)
{
  for (const int failsEach : { 2, 3, 4 })
  {
    Wiring wiring;
    wiring.failsEach = failsEach;
    const SelfTested found = run(fineJoystick(), "light", wiring);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
    EXPECT_EQ(found.state.reason, SelfTestReason::Sometimes) << failsEach;
  }
}

TEST(SelfTest, ADeviceWhoseForceFadesIsNotTakenAtItsWord)
{
  Wiring wiring;
  wiring.keeps = 0.9; // six pushes lie between the two that are compared: 0.53 of the first
  const SelfTested found = run(fineJoystick(), "light", wiring);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Inconclusive) << found.text();
  EXPECT_EQ(found.state.reason, SelfTestReason::Fades);
  EXPECT_NE(found.text().find("let the motors cool"), std::string::npos) << found.text();
}

TEST(SelfTest, ADeviceThatGoesOnPushingWhenNobodyRenewsItIsAFault)
{
  // A simulated device keeps its last command for ever.
  const SelfTested found = run(fineJoystick(), "light", {}, obliging, {}, { false, 0.2 });
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
  EXPECT_EQ(found.state.reason, SelfTestReason::NoExpiry);
  EXPECT_NE(found.text().find("do not expire"), std::string::npos) << found.text();
}

/// A wheel that calls itself a stick: nothing moves along y.
Wiring wheelWiring(bool secondMotorToo)
{
  Wiring wiring;
  wiring.sensors(1, 1) = 0.0;
  wiring.motors(1, 1) = 0.0;
  wiring.motors(0, 1) = secondMotorToo ? -1.0 : 0.0;
  return wiring;
}

TEST(SelfTest, AWheelThatCallsItselfAStickIsFoundByPushing)
{
  for (const bool secondMotorToo : { false, true })
  {
    const SelfTested found = run(fineJoystick(), "light", wheelWiring(secondMotorToo));
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
    EXPECT_TRUE(found.state.oneAxis);
    const Calibration c = found.calibration();
    EXPECT_EQ(c.refusal(), "");
    EXPECT_EQ(c.axisCount, 1);
    EXPECT_EQ(std::pair(c.axes[0].motor, c.axes[0].motorSign), std::pair(0, 1));
    EXPECT_NE(found.text().find("is a wheel"), std::string::npos) << found.text();
  }
}

TEST(SelfTest, AMotorThatNeverAnswersIsPushedNoMoreThanFourTimes)
{
  int pushes = 0;
  bool pushed = false;
  const auto count = [&](int, DeviceSample&, SelfTestState& state)
  {
    const bool now = state.stage == SelfTestStage::Push && state.axis == 1;
    pushes += now && !pushed ? 1 : 0;
    pushed = now;
  };
  static_cast<void>(run(fineJoystick(), "light", wheelWiring(false), obliging, count));
  EXPECT_EQ(pushes, 4);
}

TEST(SelfTest, WhoSaysThatItIsAWheelIsAskedForOneAxisOnly)
{
  bool askedForMore = false;
  const auto look = [&](int, DeviceSample&, SelfTestState& state)
  { askedForMore = askedForMore || (state.stage == SelfTestStage::End && state.axis > 0); };
  const SelfTested found = run(fineJoystick(), "light", wheelWiring(false), obliging, look, { true, 0.0 });
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_FALSE(askedForMore);
  EXPECT_EQ(found.calibration().axisCount, 1);
}

TEST(SelfTest, OfAStickThatSomebodyCallsAWheelOnlyXIsKept)
{
  const SelfTested found = run(fineJoystick(), "light", {}, obliging, {}, { true, 0.0 });
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_EQ(found.calibration().axisCount, 1);
}

} // namespace
} // namespace palpate::test
