// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "testing/devices/calibration/MiswiredDevice.h"

namespace palpate
{
namespace
{

using test::MiswiredDevice;
using test::Wiring;

constexpr double period_s = 1e-3;
constexpr int longest_ticks = 200'000;

/// Who holds the device: goes where it is asked to at the pace of a hand, or does something of its own.
using Person = std::function<Vec3(const Vec3& asked_D, double time_s, const SelfTestState& state)>;

Vec3 obliging(const Vec3& asked_D, double, const SelfTestState&)
{
  return asked_D;
}

struct SelfTested
{
  SelfTestPlan plan;
  SelfTestState state;
  DeviceInfo device;
  double largest_N = 0.0;
  double longestPush_s = 0.0;
  Vec3 atEnd_N = Vec3::Zero(); ///< the command with the verdict

  [[nodiscard]] Calibration calibration() const
  {
    return calibrationFrom(this->plan, this->state, this->device, "2026-01-31").value_or(Calibration{});
  }
  [[nodiscard]] std::string text() const { return resultOf(this->plan, this->state); }
};

/// What the device says of itself is changed by that before the test is planned.
struct Says
{
  bool wheel = false;
  double effectsEndAfter_s = 0.0;
};

SelfTested run(const DeviceModel& model, const std::string& hand, const Wiring& wiring, const Person& person = obliging,
  const std::function<void(int tick, DeviceSample& sample, SelfTestState& state)>& meddle = {}, const Says& says = {})
{
  constexpr double pace_m_per_s = 0.1;
  MiswiredDevice device(model, *handModel(hand), wiring);
  EXPECT_EQ(device.open(), "");
  DeviceInfo info = device.info();
  info.effectsEndAfter_s = says.effectsEndAfter_s;
  SelfTested outcome{ SelfTestPlan::forDevice(info, {}, says.wheel), {}, info };
  Vec3 hand_D = Vec3::Zero();
  double push_s = 0.0;
  for (int tick = 1; tick < longest_ticks && outcome.state.verdict == SelfTestVerdict::None; ++tick)
  {
    const Vec3 way_D = person(askedPlace_D(outcome.plan, outcome.state), tick * period_s, outcome.state) - hand_D;
    hand_D += way_D * std::min(1.0, pace_m_per_s * period_s / std::max(way_D.norm(), 1e-12));
    device.lead(hand_D);
    DeviceSample sample;
    const DeviceStatus status = device.read(tick * period_s, sample);
    if (meddle)
    {
      meddle(tick, sample, outcome.state);
    }
    const DeviceCommand command = stepSelfTest(outcome.plan, sample, status, period_s, outcome.state);
    device.write(command);
    const double force_N = command.wrench_D.force.norm();
    outcome.largest_N = std::max(outcome.largest_N, force_N);
    push_s = force_N > 0.0 ? push_s + period_s : 0.0;
    outcome.longestPush_s = std::max(outcome.longestPush_s, push_s);
    outcome.atEnd_N = command.wrench_D.force;
  }
  return outcome;
}

/// How far, as a share, the slope of a push is off at most that is seen in steps. Least squares take the part of the
/// way above its first quarter: a step's rounding takes step^3 / 12 from the way^3 / 12 of the sum of squares, the part
/// of a step at either end step^2 way / 16. Friction shortens the way.
double roundingError(const PushPair& pushes, std::size_t axis, double step_m)
{
  const double way_m = 0.75 * std::min(std::fabs(pushes[0][axis].moved_m), std::fabs(pushes[1][axis].moved_m));
  return 2.5 * (step_m / way_m) * (step_m / way_m);
}

/// How far, as a share, a strength k f h / (f - h) is off at most: the slopes f = 1 / K and h = 1 / (K + k) of a hand
/// of stiffness K without and with a spring k have errors of their own, each of which counts by its logarithmic
/// derivative.
double strengthError(const SelfTested& found, std::size_t axis, double step_m, double hand_N_per_m)
{
  const MotorAnswers& seen = found.state.motors[axis];
  const double ratio = hand_N_per_m / wallStiffness_N_per_m(found.plan, found.state, static_cast<int>(axis));
  return ratio * roundingError(seen.free[0], axis, step_m) + (1.0 + ratio) * roundingError(seen.walls[0], axis, step_m);
}

const DeviceModel& joystick()
{
  return *deviceModel("simulated-joystick");
}

Mat3 swapped()
{
  Mat3 m;
  m << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  return m;
}

TEST(SelfTest, ADeviceAsItShouldBeIsFoundAsItIs)
{
  const SelfTested found = run(joystick(), "light", {});
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  ASSERT_EQ(c.refusal(), "");
  EXPECT_EQ(c.axisCount, 2);
  for (int i = 0; i < 2; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const AxisCalibration& axis = c.axes[at];
    EXPECT_EQ(std::pair(axis.sensor, axis.sensorSign), std::pair(i, 1));
    EXPECT_EQ(std::pair(axis.motor, axis.motorSign), std::pair(i, 1));
    EXPECT_NEAR(axis.low_m, -joystick().travel_m, joystick().encoderStep_m); // which rounds down
    EXPECT_NEAR(axis.high_m, joystick().travel_m, joystick().encoderStep_m);
    const double step_m = joystick().encoderStep_m, hand_N_per_m = handModel("light")->stiffness_N_per_m;
    EXPECT_NEAR(axis.response_m_per_N * hand_N_per_m, 1.0, roundingError(found.state.motors[at].free[0], at, step_m));
    EXPECT_NEAR(axis.strength, 1.0, strengthError(found, at, step_m, hand_N_per_m));
  }
}

TEST(SelfTest, NoPushIsStrongerThanATenthOrLongerThanHalfASecond)
{
  for (const DeviceModel& model : deviceModels())
  {
    const SelfTested found = run(model, "light", {});
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << model.name << ": " << found.text();
    EXPECT_LE(found.largest_N, 0.1 * std::min(model.maxForce_N, 5.0) * (1.0 + 1e-12)) << model.name;
    EXPECT_GT(found.largest_N, 0.0);
    EXPECT_LE(found.longestPush_s, 0.5) << model.name;
  }
}

TEST(SelfTest, AnExactDeviceShowsTheStiffnessOfTheHandThatHoldsIt)
{
  for (const char* name : { "light", "stylus", "firm" })
  {
    const HandModel& hand = *handModel(name);
    const SelfTested found = run(*deviceModel("simulated-ideal"), name, {});
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
    const Calibration c = found.calibration();
    for (const AxisCalibration& axis : c.axes)
    {
      // What is left is how fast the hand follows: it lags by b / K, a hundredth of a second of the ramp's 0.4.
      EXPECT_NEAR(axis.response_m_per_N * hand.stiffness_N_per_m, 1.0, 0.05) << name;
    }
  }
}

TEST(SelfTest, EverySwappedAndTurnedSensorIsFound)
{
  for (int signs = 0; signs < 4; ++signs)
  {
    for (const Mat3& order : { Mat3(Mat3::Identity()), swapped() })
    {
      Wiring wiring;
      wiring.sensors = order * Vec3(signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, 1.0).asDiagonal();
      const SelfTested found = run(joystick(), "light", wiring);
      ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
      const Calibration c = found.calibration();
      for (int i = 0; i < 2; ++i)
      {
        const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
        EXPECT_EQ(wiring.sensors(axis.sensor, i), axis.sensorSign); // what shows axis i of D, and which way
        EXPECT_EQ(std::pair(axis.motor, axis.motorSign), std::pair(i, 1));
      }
    }
  }
}

TEST(SelfTest, EverySwappedAndTurnedMotorIsFoundWhateverTheSensorsAre)
{
  for (int signs = 0; signs < 4; ++signs)
  {
    for (const Mat3& order : { Mat3(Mat3::Identity()), swapped() })
    {
      Wiring wiring;
      wiring.motors = order * Vec3(signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, 1.0).asDiagonal();
      wiring.sensors = swapped() * Vec3(1.0, -1.0, 1.0).asDiagonal();
      const SelfTested found = run(joystick(), "light", wiring);
      ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
      const Calibration c = found.calibration();
      for (int i = 0; i < 2; ++i)
      {
        const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
        EXPECT_EQ(wiring.motors(i, axis.motor), axis.motorSign); // a positive command moves axis i of D that way
      }
    }
  }
}

TEST(SelfTest, SwappedAxesOfThreeAreFound)
{
  Wiring wiring;
  wiring.sensors << 0, 0, -1, 1, 0, 0, 0, 1, 0;
  wiring.motors << 0, 1, 0, 0, 0, 1, -1, 0, 0;
  const SelfTested found = run(*deviceModel("simulated-premium"), "light", wiring);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  for (int i = 0; i < 3; ++i)
  {
    const AxisCalibration& axis = c.axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(wiring.sensors(axis.sensor, i), axis.sensorSign);
    EXPECT_EQ(wiring.motors(i, axis.motor), axis.motorSign);
  }
}

TEST(SelfTest, AMotorThatIsWeakIsSaidAndMeasuredAgainstTheDevicesOwnSpring)
{
  Wiring wiring;
  wiring.motors(1, 1) = 0.25;
  DeviceModel smooth = joystick(); // a quarter of the push would not overcome its friction
  smooth.friction_N = 0.0;
  const SelfTested found = run(smooth, "light", wiring);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  const Calibration c = found.calibration();
  EXPECT_NEAR(c.axes[1].response_m_per_N / c.axes[0].response_m_per_N, 0.25, 0.05);
  EXPECT_NEAR(
    c.axes[0].strength, 1.0, strengthError(found, 0, smooth.encoderStep_m, handModel("light")->stiffness_N_per_m));
  EXPECT_NE(found.text().find("weak beside the strongest"), std::string::npos) << found.text();
}

TEST(SelfTest, ADeadMotorIsAFaultAndGivesNoCalibration)
{
  for (int motor = 0; motor < 2; ++motor)
  {
    Wiring wiring;
    wiring.motors(motor, motor) = 0.0;
    const SelfTested found = run(joystick(), "light", wiring);
    EXPECT_EQ(found.state.verdict, SelfTestVerdict::Faulty) << found.text();
    EXPECT_EQ(found.state.reason, SelfTestReason::NoMotion);
    EXPECT_EQ(findMotor(found.plan, found.state, motor).motion, MotorMotion::None);
    EXPECT_EQ(findMotor(found.plan, found.state, 1 - motor).motion, MotorMotion::Clear);
    EXPECT_FALSE(calibrationFrom(found.plan, found.state, found.device, "2026-01-31"));
    EXPECT_NE(found.text().find(std::string("motor ") + "xy"[motor] + ": moves nothing"), std::string::npos);
  }
}

/// A joystick fine enough that what is found is what its walls are, not its steps or its friction.
DeviceModel fineJoystick()
{
  DeviceModel fine = joystick();
  fine.friction_N = 0.0;
  fine.encoderStep_m = 1e-6;
  return fine;
}

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
  // A simulated device does what it was told last for ever.
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
  // Swings by 4 mm each way, twice a second, from the first push on.
  const auto swings = [](const Vec3& asked_D, double time_s, const SelfTestState& state)
  {
    constexpr double turns_Hz = 2.0, swing_m = 4e-3;
    const bool pushed = state.stage >= SelfTestStage::Settle;
    return pushed ? Vec3(asked_D + Vec3(swing_m * std::sin(2.0 * M_PI * turns_Hz * time_s), 0, 0)) : asked_D;
  };
  const SelfTested swinging = run(joystick(), "stylus", {}, swings);
  EXPECT_EQ(swinging.state.verdict, SelfTestVerdict::Inconclusive);
  EXPECT_NE(swinging.text().find("the hand moved during"), std::string::npos) << swinging.text();

  // Creeps by 3 mm a second, slow enough to count as still; but both pushes of a pair go the same way.
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
  // In nobody's hand: nothing holds against the push.
  const DeviceModel& free = *deviceModel("simulated-premium");
  const auto stays = [](int, DeviceSample&, SelfTestState& state)
  {
    if (state.stage == SelfTestStage::End || state.stage == SelfTestStage::Still)
    {
      state = SelfTestState{};
      state.stage = SelfTestStage::Settle; // nobody can lead it to its ends
    }
  };
  const SelfTested found = run(free, "none", {}, obliging, stays);
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Aborted) << found.text();
  EXPECT_TRUE(found.state.reason == SelfTestReason::TooFar || found.state.reason == SelfTestReason::TooFast);
  EXPECT_EQ(found.atEnd_N, Vec3::Zero());
}

/// What ends the test at once while it pushes.
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
  EXPECT_NE(askOf(check.plan, check.state).find("move the handle"), std::string::npos) << askOf(check.plan, check.state);
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
} // namespace palpate
