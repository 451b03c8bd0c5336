// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism in the tick without a session, and as bytes of a recording.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "NeedleAndBlock.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/inputs/Mechanisms.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/support/AllocationGuard.h"

namespace palpate::test
{
namespace
{

TEST(MechanismTick, AWorkerThatDoesNotComeBackForASecondEndsTheForceAndNothingIsAllocated)
{
  const auto felt = feltBlock();
  MechanismTick room;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = handSpring;
  parameters.mechanismTurning_N_m_per_rad = handTurning;
  parameters.safety = SafetyLimits::none();
  const auto state = std::make_unique<RendererState>();
  TickInput input;
  input.mechanism = felt.get();
  input.mechanismTick = &room;
  double last_N = 0.0, pushed_N = 0.0;
  int faultAt = 0;
  Fault fault = Fault::None;
  for (int i = 0; i < 1500; ++i)
  {
    input.tick = static_cast<std::uint64_t>(i);
    input.sample.pose_D = needleAt(Vec3(0, 0, std::max(0.001 - 1e-4 * i, -0.004)));
    const AllocationGuard guard;
    const TickOutput output = renderTick(input, parameters, *state);
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u);
    last_N = output.command.wrench_D.force.norm();
    pushed_N = std::max(pushed_N, last_N);
    faultAt = fault == Fault::None && output.state.fault != Fault::None ? i : faultAt;
    fault = output.state.fault;
  }
  EXPECT_GT(pushed_N, 0.3);
  EXPECT_EQ(fault, Fault::BodyLate);
  EXPECT_NEAR(faultAt, 1000, 2);
  EXPECT_EQ(last_N, 0.0);
}

/// The tick's report of a mechanism whose hand is there, or nowhere.
class TickOfMechanism
{
public:
  TickOfMechanism()
  {
    this->parameters_.stiffness_N_per_m = handSpring;
    this->parameters_.mechanismTurning_N_m_per_rad = handTurning;
    this->parameters_.safety = SafetyLimits::none();
    this->input_.mechanismTick = &this->room_;
  }

  TickOutput next(const FeltMechanism& felt, const Pose& hand, std::span<const HapticEvent> events = {})
  {
    this->input_.mechanism = &felt;
    this->input_.sample.pose_D = hand;
    this->input_.events = events;
    ++this->input_.tick;
    return renderTick(this->input_, this->parameters_, *this->state_);
  }

private:
  HapticParameters parameters_;
  std::unique_ptr<RendererState> state_ = std::make_unique<RendererState>();
  MechanismTick room_;
  TickInput input_;
};

TEST(MechanismTick, AnotherMechanismThatRestsBeforeItsFirstTickSaysNothingOfTheOneBeforeAndKeepsALawThatIsBroken)
{
  const auto pierced = feltBlock();
  MechanismInputs two = needleAndBlock();
  MechanismConstraint tip = tipHeld().mechanism.laws[0];
  tip.b = "block";
  two.mechanism.laws.insert(two.mechanism.laws.begin(), tip);
  std::string refusal;
  const auto bodies = MechanismBodies::make(two.soft, refusal);
  const MechanismPlan plan = planMechanism(two.mechanism, bodies->atRest(), 2);
  const FeltMechanism other(2, plan, bodies->newest());
  const Pose above = needleAt(Vec3(0, 0, 1e-3));
  Pose nowhere;
  nowhere.p.x() = std::numeric_limits<double>::quiet_NaN();

  TickOfMechanism ticks;
  MechanismNow now;
  for (int i = 0; i <= 100; ++i)
  {
    now = ticks.next(*pierced, needleAt(Vec3(0, 0, 1e-3 - 1e-4 * i))).state.mechanism;
  }
  ASSERT_EQ(now.laws[0].phase, ConstraintPhase::Inside);
  ASSERT_GT(now.changes.count, 0u);
  const Vec3 before_W = now.pose_W[0].p;

  const HapticEvent broken{ 0, EventKind::BreakConstraint, 1 };
  now = ticks.next(other, nowhere, std::span(&broken, 1)).state.mechanism;
  EXPECT_EQ(now.revision, 2u);
  EXPECT_EQ(now.lawCount, 2);
  EXPECT_FALSE(now.held) << "it has been nowhere";
  EXPECT_EQ(now.laws[0].phase, ConstraintPhase::Open);
  EXPECT_EQ(now.laws[1].phase, ConstraintPhase::Gone);
  EXPECT_EQ(now.changes.count, 0u);
  EXPECT_NE(now.pose_W[0].p, before_W);
  now = ticks.next(other, above).state.mechanism;
  EXPECT_TRUE(now.held);
  EXPECT_EQ(now.laws[0].phase, ConstraintPhase::Closed);
  EXPECT_EQ(now.laws[1].phase, ConstraintPhase::Gone);
  EXPECT_EQ(now.hand_W.p, above.p);
  EXPECT_LE(now.hand_W.q.angularDistance(above.q), 1e-12) << "the hand turns it";
  const Vec3 held_W = now.pose_W[0].p;
  const TickOutput resting = ticks.next(other, nowhere);
  EXPECT_TRUE(resting.state.mechanism.held) << "where it was";
  EXPECT_EQ(resting.state.mechanism.pose_W[0].p, held_W);
  EXPECT_EQ(resting.state.proxy_W.p, held_W);
}

std::vector<char> bytesOf(const FeltMechanism& mechanism)
{
  ByteWriter out;
  putMechanism(out, mechanism);
  return out.bytes();
}

TEST(RecordedMechanisms, ComeBackToTheLastBitAndAreRefusedWhereTheyCannotBe)
{
  const auto felt = feltBlock();
  const std::vector<char> bytes = bytesOf(*felt);
  ByteReader in(bytes.data(), bytes.size());
  const RecordedMechanism read = readMechanism(in);
  ASSERT_TRUE(in.ok());
  EXPECT_EQ(in.left(), 0u);
  auto back = std::make_shared<PressedBody>(*read.bodies[0].body);
  back->scene = felt->bodies()[0]->scene;
  EXPECT_EQ(bytesOf(FeltMechanism(read.revision, read.plan, { back })), bytes);
  const auto refused = [&](const auto& change)
  {
    MechanismPlan plan = felt->plan();
    change(plan);
    const std::vector<char> wrong = bytesOf(FeltMechanism(1, plan, felt->bodies()));
    ByteReader again(wrong.data(), wrong.size());
    (void)readMechanism(again);
    return !again.ok();
  };
  EXPECT_FALSE(refused([](MechanismPlan&) {}));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.held = 1; }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.characteristic_u = 0.0; }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.bodies[1].soft = 1; }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.bodies[0].pose_W.q.coeffs().setZero(); }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.laws[0].b = 2; }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.laws[0].kind = static_cast<ConstraintKind>(11); }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.laws[0].place_B.vertices[2] = 1u << 20; }));
  EXPECT_TRUE(refused([](MechanismPlan& p) { p.laws[0].friction = std::nan(""); }));
  for (std::size_t size = 0; size < bytes.size(); size += 997)
  {
    ByteReader cut(bytes.data(), size);
    (void)readMechanism(cut);
    EXPECT_FALSE(cut.ok()) << size;
  }
}

TEST(RecordedMechanisms, AStateAtVerticesThatABodyDoesNotHaveIsNotGoneOnFrom)
{
  const auto felt = feltBlock();
  const std::vector<char> bytes = bytesOf(*felt);
  ByteReader in(bytes.data(), bytes.size());
  const RecordedMechanism mechanism = readMechanism(in);
  MechanismState state;
  state.laws[0].place_B.vertices[1] = 1u << 20;
  EXPECT_TRUE(fits(state, mechanism)) << "of another plan";
  state.revision = mechanism.plan.revision;
  EXPECT_FALSE(fits(state, mechanism));
  EXPECT_TRUE(isUsable(state));
  state.laws[3].force_W.x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isUsable(state));
}

TEST(RecordedMechanisms, ThatAreLeftOutOfARecordingAreSaid)
{
  Recording recording;
  RecordedChange change;
  change.event = { 1, EventKind::Mechanism, 17 };
  recording.entries.emplace_back(change);
  EXPECT_NE(replay(recording).problem, "");
}

} // namespace
} // namespace palpate::test
