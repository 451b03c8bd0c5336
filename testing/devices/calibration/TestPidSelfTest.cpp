// SPDX-License-Identifier: GPL-3.0-or-later
// The self-test through the whole of a USB link: descriptors, reports, effects that the firmware runs.
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "testing/devices/hid/ModelCases.h"
#include "testing/devices/hid/PidRig.h"
#include "testing/devices/hid/SunFfbModel.h"

namespace palpate
{
namespace
{

using test::PidLayout;
using test::PidRig;

/// A resting hand, in the firmware's units: half travels, the device's largest force, HID's axes.
constexpr double limpHand = 4.0, restingHand = 8.0, pace = 2e-3;

struct Outcome
{
  SelfTestPlan plan;
  SelfTestState state;
  PidScale scale;

  [[nodiscard]] std::string text() const { return resultOf(this->plan, this->state); }
};

/// Who holds the handle, and how it is wired.
struct Holder
{
  double stiffness = limpHand, motorSign = 1.0;
  bool wheel = false;
  Vec3 rests = Vec3::Zero(); ///< this person's middle [half travels, D]
};

Outcome check(PidRig& rig, test::VirtualHandle& handle, const Holder& holder)
{
  constexpr int longest_ms = 100'000;
  handle.position = { holder.rests.x(), -holder.rests.y() };
  EXPECT_EQ(rig.device.open(), "");
  rig.run(5);
  Outcome outcome{ SelfTestPlan::forDevice(rig.device.info(), {}, holder.wheel), {}, rig.scale() };
  Vec3 hand = holder.rests;
  for (int ms = 0; ms < longest_ms && outcome.state.verdict == SelfTestVerdict::None; ++ms)
  {
    const Vec3 led = askedPlace_D(outcome.plan, outcome.state) / outcome.scale.halfTravel_m;
    const Vec3 asked = outcome.state.stage == SelfTestStage::End ? led : holder.rests;
    hand += (asked - hand).cwiseMax(-pace).cwiseMin(pace);
    const auto& at = handle.position;
    handle.push = { holder.stiffness * (hand.x() - at[0]), holder.stiffness * (-hand.y() - at[1]) };
    rig.run(1);
    rig.command = stepSelfTest(outcome.plan, rig.sample, rig.status, 1e-3, outcome.state);
    rig.command.wrench_D.force *= holder.motorSign;
  }
  return outcome;
}

Outcome check(const PidLayout& layout, double handStiffness, double motorSign, bool wheel = false)
{
  PidRig rig(layout);
  const Outcome outcome = check(rig, rig.stick(), { handStiffness, motorSign, wheel });
  EXPECT_EQ(rig.stick().badReports, 0) << layout.name;
  return outcome;
}

Outcome check(const test::ModelCase& one, const Vec3& rests)
{
  PidRig rig(one.model, one.descriptor);
  Holder holder;
  holder.rests = rests;
  const Outcome outcome = check(rig, *one.model, holder);
  EXPECT_EQ(one.model->badReports, 0) << one.name;
  return outcome;
}

/// In the middle, and off it along both axes.
const std::vector<Vec3> restingPlaces{ Vec3::Zero(), Vec3(0.4, -0.3, 0.0) };

/// A firmware that is right but for its reading of the numbers of a condition.
class MishearingModel final : public test::SunFfbModel
{
public:
  using Heard = std::function<void(Condition&)>;
  MishearingModel(std::span<const std::uint8_t> descriptor, Heard heard)
    : SunFfbModel(descriptor), heard_(std::move(heard))
  {
  }

protected:
  double forceOf(const Effect& effect, std::size_t axis) const override
  {
    Effect heard = effect;
    for (Condition& condition : heard.conditions)
    {
      this->heard_(condition);
    }
    return SunFfbModel::forceOf(heard, axis);
  }

private:
  Heard heard_;
};

HeldProof proofOfMishearing(const MishearingModel::Heard& heard)
{
  test::ModelCase one = test::modelCases()[1];
  EXPECT_EQ(one.name, "SunFFB");
  one.model = std::make_shared<MishearingModel>(one.descriptor, heard);
  const Outcome found = check(one, Vec3::Zero());
  EXPECT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  return heldProofOf(found.plan, found.state);
}

TEST(PidSelfTest, FindsEveryLayoutAsItIs)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    const Outcome found = check(layout, restingHand, 1.0);
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << layout.name << ": " << found.text();
    const double given_m_per_N = found.scale.halfTravel_m / (restingHand * found.scale.maxForce_N);
    for (int axis = 0; axis < 2; ++axis)
    {
      const AxisFinding range = findAxis(found.plan, found.state, axis);
      const MotorFinding motor = findMotor(found.plan, found.state, axis);
      EXPECT_EQ(std::pair(range.sensor, range.sign), std::pair(axis, 1)) << layout.name;
      EXPECT_NEAR(range.high_m - range.low_m, 2.0 * found.scale.halfTravel_m, 2.0 * found.plan.resolution_m);
      EXPECT_EQ(std::pair(motor.sensor, motor.sign), std::pair(axis, 1)) << layout.name;
      // The handle's friction of 0.6 makes the hand lag by tau = 0.6 / 8 = 0.075 s: where a quarter of the path is
      // reached, t = 0.16 s, its slope is 1 - exp(-t / tau) = 0.88 of the true one, and nearer to it afterwards.
      EXPECT_GT(motor.response_m_per_N, 0.88 * given_m_per_N) << layout.name;
      EXPECT_LT(motor.response_m_per_N, 1.02 * given_m_per_N) << layout.name; // rounding to steps
    }
  }
}

TEST(PidSelfTest, FindsAFirmwareThatTakesADirectionAsTheOneTheForceComesFrom)
{
  const Outcome found = check(test::plainLayout(), restingHand, -1.0);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_EQ(findAxis(found.plan, found.state, axis).sign, 1);
    EXPECT_EQ(findMotor(found.plan, found.state, axis).sign, -1);
  }
}

// The firmware's walls and its forces are on one scale.
TEST(PidSelfTest, FeelsTheWallsAndTheViscosityOfEveryLayoutThatOffersThem)
{
  int offered = 0;
  for (const PidLayout& layout : test::allLayouts())
  {
    const Outcome found = check(layout, limpHand, 1.0);
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << layout.name << ": " << found.text();
    offered += found.plan.offersWalls ? 1 : 0;
    EXPECT_EQ(heldProofOf(found.plan, found.state), found.plan.offersWalls ? HeldProof::Felt : HeldProof::Unfelt)
      << layout.name << ": " << found.text();
  }
  EXPECT_GT(offered, 0);
}

TEST(PidSelfTest, AFirmwareThatIgnoresOrMisScalesTheCentreOrTheDeadBandKeepsTheWallsWithTheProgram)
{
  for (const double way : { -1.0, 0.0, 0.5, 2.0 })
  {
    EXPECT_EQ(proofOfMishearing([way](Condition& told) { told.centre *= way; }), HeldProof::Misplaced) << way;
  }
  for (const double way : { 0.0, 0.5, 2.0 })
  {
    EXPECT_EQ(proofOfMishearing([way](Condition& told) { told.deadBand *= way; }), HeldProof::Misplaced) << way;
  }
}

TEST(PidSelfTest, AFirmwareThatIgnoresTheSaturationKeepsTheWallsWithTheProgram)
{
  const auto ignores = [](Condition& told)
  { told.positiveSaturation = told.negativeSaturation = Condition::unlimited; };
  EXPECT_EQ(proofOfMishearing(ignores), HeldProof::NoLimit);
}

// SunFFB is among them, which the two tests above refuse once it hears something else.
TEST(PidSelfTest, OfTheFirmwaresThatPeopleHaveOnlyThoseWhoseWallsHoldAreBelievedWhereverTheHandRests)
{
  for (const Vec3& rests : restingPlaces)
  {
    for (const test::ModelCase& one : test::modelCases())
    {
      const Outcome found = check(one, rests);
      ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << one.name << rests.transpose() << found.text();
      for (int motor = 0; motor < 2; ++motor)
      {
        EXPECT_EQ(findMotor(found.plan, found.state, motor).sign, 1) << one.name;
      }
      EXPECT_EQ(found.plan.offersWalls, one.name.find("adapt-ffb-joy") == std::string::npos) << one.name;
      EXPECT_EQ(heldProofOf(found.plan, found.state) == HeldProof::Felt, one.holds)
        << one.name << rests.transpose() << found.text();
    }
  }
}

TEST(PidSelfTest, ConditionsThatAreTakenButNotFeltLeaveTheWallsToTheProgram)
{
  PidLayout layout = test::plainLayout();
  layout.habits.deadConditions = true;
  const Outcome found = check(layout, limpHand, 1.0);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  EXPECT_EQ(heldProofOf(found.plan, found.state), HeldProof::NoForce) << found.text();
}

// Of a corridor the second device leaves one wall to the host, which closes it by a force.
TEST(PidSelfTest, AFirmwareThatPointsWhereForcesGoIsCorrected)
{
  for (PidLayout layout : { test::plainLayout(), test::oneSidedLayout() })
  {
    layout.habits.pointsTo = true;
    const Outcome found = check(layout, limpHand, 1.0);
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
    for (int motor = 0; motor < 2; ++motor)
    {
      EXPECT_EQ(findMotor(found.plan, found.state, motor).sign, -1);
    }
    EXPECT_EQ(heldProofOf(found.plan, found.state), HeldProof::Felt) << layout.name << ": " << found.text();
  }
}

TEST(PidSelfTest, OneMotorBehindTwoAxesIsAWheelOnceSomebodySaysSo)
{
  PidLayout layout = test::plainLayout();
  layout.habits.oneMotor = true;
  const Outcome stick = check(layout, limpHand, 1.0);
  EXPECT_NE(stick.state.verdict, SelfTestVerdict::None) << "it must not wait for ever";
  EXPECT_NE(stick.state.verdict, SelfTestVerdict::Passed) << stick.text();
  const Outcome wheel = check(layout, limpHand, 1.0, true);
  EXPECT_EQ(wheel.state.verdict, SelfTestVerdict::Passed) << wheel.text();
}

TEST(PidSelfTest, AnotherProgramThatTakesTheDeviceEndsItAndIsNamed)
{
  for (const bool wipesSilently : { false, true })
  {
    PidLayout layout = test::plainLayout();
    layout.habits.wipesSilently = wipesSilently;
    PidRig rig(layout);
    ASSERT_EQ(rig.device.open(), "");
    rig.run(5);
    const SelfTestPlan plan = SelfTestPlan::forDevice(rig.device.info());
    SelfTestState state;
    state.stage = SelfTestStage::Settle; // no hand leads it to its ends
    bool taken = false;
    int sinceTaken_ms = 0;
    for (int ms = 0; ms < 20'000 && state.verdict == SelfTestVerdict::None; ++ms)
    {
      if (!taken && state.stage == SelfTestStage::Push && state.stage_s > 0.1)
      {
        rig.stick().uploadFromElsewhere();
        taken = true;
      }
      sinceTaken_ms += taken ? 1 : 0;
      const auto& at = rig.stick().position;
      rig.stick().push = { -restingHand * at[0], -restingHand * at[1] };
      rig.run(1);
      rig.command = stepSelfTest(plan, rig.sample, rig.status, 1e-3, state);
    }
    EXPECT_TRUE(taken);
    EXPECT_EQ(state.verdict, SelfTestVerdict::Aborted) << wipesSilently;
    EXPECT_EQ(state.reason, SelfTestReason::Lost);
    EXPECT_LE(sinceTaken_ms, 250);
    const std::string said = resultOf(plan, state, rig.device.linkReport());
    EXPECT_NE(said.find("another program"), std::string::npos) << said;
  }
}

TEST(PidSelfTest, SeesThatWhatIsNotRenewedEnds)
{
  const Outcome found = check(test::plainLayout(), limpHand, 1.0);
  EXPECT_EQ(endedByItself(found.plan, found.state, 0), true) << found.text();
  EXPECT_EQ(endedByItself(found.plan, found.state, 1), true) << found.text();
}

} // namespace
} // namespace palpate
