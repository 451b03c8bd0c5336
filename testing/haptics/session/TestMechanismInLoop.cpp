// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose hand holds a needle that is joined to a soft block: felt, recorded, replaced, broken, not computed
// any more.
#include <cmath>

#include <gtest/gtest.h>

#include "HandOfTest.h"
#include "NeedleAndBlock.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/MechanismChoice.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/MechanismWorker.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/support/Eventually.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

SessionOptions virtualTime(const std::string& file = {})
{
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = file;
  return options;
}

MechanismChoice chosen(const MechanismInputs& inputs)
{
  return { std::make_shared<const MechanismInputs>(inputs), "scene", 25.0 };
}

/// Force of the block on a hand there once it is at rest: no snapshots, a solve of the whole body in each tick.
double restingForce_N(double depth)
{
  MechanismHold hold;
  hold.stiffness_N_per_m = handSpring;
  hold.turning_N_m_per_rad = handTurning;
  hold.lowRate_Hz = 0.0;
  std::string refusal;
  const auto touch = MechanismTouch::make(needleAndBlock(), hold, refusal);
  (void)touch->next(0.0, needleAt(Vec3(0, 0, 1e-3)));
  return touch->next(1e-3, needleAt(Vec3(0, 0, -depth))).wrench_W.force.z();
}

Recording recordingIn(const std::string& file)
{
  auto read = readRecording(file);
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::holds_alternative<Recording>(read) ? std::move(std::get<Recording>(read)) : Recording();
}

/// That it is computed anew bit for bit in so many ticks.
void expectReplay(
  const Recording& recording, std::uint64_t ticks, const std::function<void(const TickOutput&)>& watch = {})
{
  const ReplayResult result = replay(recording, {}, 1, watch);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, ticks);
}

/// Of the needle whose tip is held, where the hand is that far aside: least energy of both springs of the hand,
/// K ((aside - L sin t)^2 + L^2 (1 - cos t)^2) / 2 + K_r t^2 / 2, by Newton's steps.
double turnAboutTheTip_rad(double aside)
{
  const double lever = handSpring * needleLength;
  double t = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    const double slope = handTurning * t + lever * (needleLength * std::sin(t) - aside * std::cos(t));
    t -= slope / (handTurning + lever * (needleLength * std::cos(t) + aside * std::sin(t)));
  }
  return t;
}

/// A hand with a needle, in virtual time unless said.
class MechanismInLoop : public testing::Test
{
protected:
  void begin(const MechanismInputs& inputs, bool turns = true, const SessionOptions& asked = virtualTime())
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = handSpring;
    parameters.limitStiffness = false;
    parameters.mechanismTurning_N_m_per_rad = handTurning;
    parameters.safety = this->safety;
    ASSERT_EQ(this->session.setParameters(parameters), "");
    this->session.choose<MechanismTask>(chosen(inputs));
    auto device = std::make_unique<HandOfTest>(turns);
    device->move(needleAt(Vec3(0, 0, 0.005)));
    ASSERT_EQ(this->session.start(std::move(device), asked), "");
  }

  const HapticState& hold(const Pose& hand, int ticks = 1)
  {
    static_cast<HandOfTest*>(this->session.device())->move(hand);
    EXPECT_EQ(this->session.step(ticks), ticks);
    return this->session.state();
  }

  /// The tip goes there at 0.1 m/s from where it is, then rests there.
  const HapticState& lower(double from, double to, int rest = 0)
  {
    const auto ticks = static_cast<int>(std::lround(std::abs(to - from) / 1e-4));
    for (int i = 1; i <= ticks; ++i)
    {
      const double force_N = this->session.state().force_W.norm();
      const double now_N = this->hold(needleAt(Vec3(0, 0, from + (to - from) * i / ticks))).force_W.norm();
      this->mostStep_N = std::max(this->mostStep_N, std::abs(now_N - force_N));
    }
    return rest > 0 ? this->hold(needleAt(Vec3(0, 0, to)), rest) : this->session.state();
  }

  /// Goes in, comes out and in again, 0.7 s long.
  void stroke()
  {
    this->lower(0.005, -0.02);
    this->lower(-0.02, 0.003);
    this->lower(0.003, -0.02);
  }

  /// However the mechanism changes meanwhile.
  void holdWithoutAStep(const Pose& hand, int ticks)
  {
    double last_N = this->session.state().force_W.norm();
    for (int i = 0; i < ticks; ++i)
    {
      const double now_N = this->hold(hand).force_W.norm();
      EXPECT_LE(std::abs(now_N - last_N), ToolBlend::largestStep_N) << i;
      last_N = now_N;
    }
  }

  HapticSession session;
  SafetyLimits safety = SafetyLimits::none();
  double mostStep_N = 0.0;
};

TEST_F(MechanismInLoop, ATipOnABlockIsPushedAsByTheBlockAtRestAndGoesInAtItsStrength)
{
  this->begin(needleAndBlock());
  const double before = 1.2e-3, beyond = 3e-3;
  ASSERT_LT(restingForce_N(before), punctureAt_N);
  const HapticState on = this->lower(0.005, -before, 400);
  EXPECT_NEAR(on.force_W.z(), restingForce_N(before), 1e-3 * punctureAt_N);
  EXPECT_LT(on.force_W.z(), handSpring * before) << "it gives way";
  EXPECT_NEAR(on.mechanism.laws[0].force_N, on.force_W.norm(), 1e-6);
  EXPECT_EQ(on.mechanism.laws[0].phase, ConstraintPhase::Closed);
  EXPECT_EQ(on.mechanism.changes.count, 0u);
  const HapticState in = this->lower(-before, -beyond, 1000);
  EXPECT_EQ(in.mechanism.laws[0].phase, ConstraintPhase::Inside);
  ASSERT_EQ(in.mechanism.changes.count, 1u);
  EXPECT_EQ(in.mechanism.changes.at(0).change, ConstraintChange::Punctured);
  EXPECT_EQ(in.mechanism.changes.at(0).law, 0u);
  EXPECT_NEAR(in.force_W.z(), shaftFriction_N, 1e-6) << "what the shaft holds";
  const double moved_N = handSpring * 1e-4; // by the hand in a tick
  EXPECT_LE(this->mostStep_N, ToolBlend::largestStep_N + 2.0 * moved_N);
}

TEST_F(MechanismInLoop, ARodThatIsHeldAtItsTipPushesAndTurnsTheHandAsItsLeverDoes)
{
  this->begin(tipHeld());
  const double aside = 1e-4;
  const HapticState state = this->hold(needleAt(Vec3(aside, 0, 0)), 1000);
  const double turn_rad = turnAboutTheTip_rad(aside);
  EXPECT_NEAR(state.force_W.x(), handSpring * (needleLength * std::sin(turn_rad) - aside), 1e-9);
  EXPECT_NEAR(std::abs(state.torque_D.y()), handTurning * turn_rad, 1e-9);
  EXPECT_NEAR(state.torque_D.norm(), std::abs(state.torque_D.y()), 1e-9);
  EXPECT_LE(state.mechanism.residual_u, 1e-12);
}

TEST_F(MechanismInLoop, AHandThatTheDeviceCannotTurnFeelsNoTorqueAndOnlyAlongTheRod)
{
  this->begin(tipHeld(), false);
  const double lifted = 2e-3;
  const HapticState state = this->hold(needleAt(Vec3(0, 0, lifted)), 1000);
  EXPECT_NEAR(state.force_W.z(), -handSpring * lifted, 1e-9);
  EXPECT_EQ(state.torque_D, Vec3(0, 0, 0));
  EXPECT_EQ(this->session.status<MechanismTask>().check.freeTurns, 3);
}

TEST_F(MechanismInLoop, GivesNoForceUntilItIsAskedFor)
{
  this->safety = SafetyLimits();
  SessionOptions options = virtualTime();
  options.engage = false;
  this->begin(needleAndBlock(), true, options);
  const HapticState state = this->lower(0.005, -0.004, 200);
  EXPECT_EQ(state.force_D, Vec3(0, 0, 0));
  EXPECT_GT(state.mechanism.laws[0].force_N, 0.1);
  this->session.engage();
  EXPECT_EQ(this->hold(needleAt(Vec3(0, 0, -0.004)), 200).force_D, Vec3(0, 0, 0)) << "it would not start small";
  this->lower(-0.004, 0.005, 200);
  EXPECT_GT(this->lower(0.005, -0.004, 200).force_D.z(), 0.1);
}

TEST_F(MechanismInLoop, ReplaysBitForBitAndTellsItsChanges)
{
  const TemporaryFolder folder;
  this->begin(needleAndBlock(ElasticModel::NeoHookean), true, virtualTime(folder.file("a")));
  this->stroke();
  const std::uint64_t changes = this->session.state().mechanism.changes.count;
  EXPECT_GE(changes, 3u) << "in, out, in";
  const std::uint64_t ticks = this->session.report().ticks;
  EXPECT_EQ(this->session.stop(), "");
  const Recording recording = recordingIn(folder.file("a"));
  EXPECT_GT(recording.mechanisms.size(), 10u);
  std::uint64_t told = 0;
  for (const RecordedEntry& entry : recording.entries)
  {
    const auto* const change = std::get_if<RecordedChange>(&entry);
    told += change != nullptr && change->event.kind == EventKind::Constraint;
  }
  EXPECT_EQ(told, changes);
  expectReplay(recording, ticks);
}

TEST_F(MechanismInLoop, EveryBitThatFlipsInARecordingOfItIsNamed)
{
  const TemporaryFolder folder;
  this->begin(needleAndBlock(), true, virtualTime(folder.file("a")));
  this->lower(0.005, -0.002);
  EXPECT_EQ(this->session.stop(), "");
  FlippedBits(folder.file("a")).expectEachIsNamed(34, "joined");
}

TEST_F(MechanismInLoop, OfARecordingBegunWhileTheNeedleIsInReplaysBitForBit)
{
  const TemporaryFolder folder;
  this->begin(needleAndBlock(ElasticModel::NeoHookean));
  ASSERT_EQ(this->lower(0.005, -0.02).mechanism.laws[0].phase, ConstraintPhase::Inside);
  for (const char* const name : { "a", "b" }) // the second goes on where the first ends
  {
    ASSERT_EQ(this->session.record(folder.file(name)), "");
    this->lower(-0.02, -0.015);
    this->lower(-0.015, -0.02);
  }
  EXPECT_EQ(this->session.stop(), "");
  for (const char* const name : { "a", "b" })
  {
    double most_N = 0.0;
    expectReplay(recordingIn(folder.file(name)), 100u,
      [&most_N](const TickOutput& out) { most_N = std::max(most_N, out.command.wrench_D.force.norm()); });
    EXPECT_GE(most_N, 0.99 * shaftFriction_N);
  }
}

TEST_F(MechanismInLoop, ALawThatAPersonBreaksLetsTheHandGoWithoutAStepAndReplays)
{
  const TemporaryFolder folder;
  this->begin(tipHeld(), true, virtualTime(folder.file("a")));
  const Pose hand = needleAt(Vec3(0, 0, 3e-3));
  ASSERT_NEAR(this->hold(hand, 500).force_W.z(), -3.0, 1e-6);
  this->session.breakConstraint(0);
  this->holdWithoutAStep(hand, 500);
  EXPECT_LE(this->session.state().force_W.norm(), 1e-6);
  EXPECT_EQ(this->session.state().mechanism.laws[0].phase, ConstraintPhase::Gone);
  EXPECT_EQ(this->session.stop(), "");
  expectReplay(recordingIn(folder.file("a")), 1000u);
}

TEST_F(MechanismInLoop, ABodyThatFindsNoPlaceToRestIsSaidInEachTickAndTheHandFeelsItsOwnLawsAlone)
{
  MechanismInputs inputs = tipHeld();
  MechanismBody& sledge = inputs.mechanism.bodies.emplace_back(bodyOf("sledge", MechanismBodyKind::Rigid));
  sledge.halfSize_u = Vec3::Constant(0.01);
  sledge.load_W = Vec3(0.1, 0, -1); // down, and along the plane that it would glide on
  for (const auto& [name, at] : { std::pair("front", Vec3(0.01, 0, -0.01)), std::pair("left", Vec3(-0.01, 0.01, -0.01)),
         std::pair("right", Vec3(-0.01, -0.01, -0.01)) })
  {
    MechanismConstraint& runner = inputs.mechanism.laws.emplace_back();
    runner.name = name;
    runner.a = "sledge";
    runner.b = "world";
    runner.point_A = runner.point_B = at;
  }
  this->begin(inputs);
  const double aside = 1e-4;
  constexpr int ticks = 1000;
  const HapticState state = this->hold(needleAt(Vec3(aside, 0, 0)), ticks);
  EXPECT_TRUE(state.mechanism.capped);
  EXPECT_TRUE(state.capped);
  EXPECT_GE(this->session.report().cappedTicks, static_cast<std::uint64_t>(ticks));
  EXPECT_NEAR(state.force_W.x(), handSpring * (needleLength * std::sin(turnAboutTheTip_rad(aside)) - aside), 1e-9);
  const double gone = state.mechanism.pose_W[2].p.x();
  EXPECT_GT(gone, 0.0);
  EXPECT_LE(gone, sledge.load_W.norm() / handSpring * (ticks + 1)) << "as through what drags at it";
}

TEST_F(MechanismInLoop, AnotherMechanismInItsPlaceAndNoneAtAllNeverStep)
{
  this->begin(needleAndBlock());
  const Pose hand = needleAt(Vec3(0, 0, -0.0012));
  const double pressed_N = this->lower(0.005, -0.0012, 300).force_W.norm();
  ASSERT_GT(pressed_N, 0.5);
  MechanismInputs stronger = needleAndBlock();
  stronger.mechanism.laws[0].strength_N = 3.0;
  MechanismInputs held = tipHeld();
  for (const MechanismChoice& next : { chosen(stronger), chosen(held), MechanismChoice{} })
  {
    this->session.choose<MechanismTask>(next);
    this->holdWithoutAStep(hand, 300);
  }
  EXPECT_FALSE(this->session.state().mechanism.held);
  EXPECT_LE(this->session.state().force_W.norm(), 1e-3);
}

TEST_F(MechanismInLoop, WhatIsNoMechanismIsSaidAndNotFelt)
{
  MechanismInputs joinedToNothing = tipHeld();
  joinedToNothing.mechanism.laws[0].b = "nobody";
  MechanismInputs notHeld = tipHeld();
  notHeld.mechanism.bodies[0].kind = MechanismBodyKind::Rigid;
  notHeld.mechanism.bodies[0].halfSize_u = Vec3::Constant(needleLength);
  for (const MechanismInputs& wrong : { joinedToNothing, notHeld })
  {
    this->begin(wrong);
    const HapticState& state = this->hold(needleAt(Vec3::Zero()), 5);
    EXPECT_FALSE(state.mechanism.held);
    EXPECT_FALSE(this->session.status<MechanismTask>().building);
    EXPECT_NE(this->session.status<MechanismTask>().problem, "");
    EXPECT_EQ(this->session.status<MechanismTask>().problem.find('\n'), std::string::npos);
    EXPECT_EQ(this->session.stop(), "");
  }
}

TEST_F(MechanismInLoop, ItIsBeingComputedUntilTheServoIsGivenItAndItsBodiesAreToBeSeenFromThenOn)
{
  this->begin(needleAndBlock(), true, SessionOptions{});
  EXPECT_TRUE(this->session.status<MechanismTask>().building);
  EXPECT_TRUE(eventually([&] { return !this->session.status<MechanismTask>().building; }));
  const MechanismStatus first = this->session.status<MechanismTask>();
  EXPECT_GT(first.plan, 0u);
  ASSERT_EQ(first.soft.size(), 1u);
  EXPECT_EQ(first.soft[0].shape->dent_u.size(), first.soft[0].asMade->mesh.vertices_W.size());
  EXPECT_TRUE(eventually([&] { return this->session.state().mechanism.revision == first.plan; }));
  MechanismInputs stronger = needleAndBlock();
  stronger.mechanism.laws[0].strength_N = 3.0;
  this->session.choose<MechanismTask>(chosen(stronger));
  EXPECT_TRUE(this->session.status<MechanismTask>().building);
  EXPECT_TRUE(eventually([&] { return this->session.status<MechanismTask>().plan > first.plan; }));
  EXPECT_FALSE(this->session.status<MechanismTask>().building);
}

TEST_F(MechanismInLoop, ItsThreadMakesPacketsThatGiveWay)
{
  this->begin(needleAndBlock(ElasticModel::NeoHookean), true, SessionOptions{});
  EXPECT_TRUE(eventually([&] { return this->session.status<MechanismTask>().snapshots > 2; }));
  EXPECT_EQ(this->session.status<MechanismTask>().problem, "");
  EXPECT_TRUE(eventually([&] { return this->session.state().mechanism.held; }));
  static_cast<HandOfTest*>(this->session.device())->move(needleAt(Vec3(0, 0, -0.002)));
  EXPECT_TRUE(eventually([&] { return this->session.state().mechanism.laws[0].force_N > 0.0; }));
}

} // namespace
} // namespace palpate::test
