// SPDX-License-Identifier: GPL-3.0-or-later
// A tool in the tick: the effect of its contacts on the hand.
#include <gtest/gtest.h>

#include <cmath>

#include "Tools.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/support/AllocationGuard.h"

namespace palpate::test
{
namespace
{

constexpr double halfCube = 0.02, stiffness = 1000.0, tick_s = 1e-3;

/// A cube above a plane, in the hand of somebody whom the tick lets feel everything.
class ToolTick : public testing::Test
{
protected:
  ToolTick()
  {
    Random random(testSeed(1802));
    const TriangleMesh plane = makeSheet({ 0.4, 0.4, 4, 4, 0.0 }, random);
    this->scene_ = sceneOf(plane);
    const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-halfCube), Vec3::Constant(halfCube))).value;
    this->move_.emplace(tool, makeToolScene(cleanMesh(plane).mesh, tool), tool.gyration_u);
    EXPECT_EQ(this->move_->place({ Vec3(0, 0, 0.03), Quat::Identity() }), "");
    this->parameters_.stiffness_N_per_m = stiffness;
    this->parameters_.safety = SafetyLimits::none();
    ToolContacts nowhere; // the hand takes the tool as it is turned now
    nowhere.held = true;
    nowhere.revision = ++this->revision_;
    this->tick(nowhere, { Vec3(0, 0, 0.03), Quat::Identity() });
    this->state_.toolSet = {}; // as if it had lain there all the time: the next set is no step
  }

  /// The cube's contacts once it has gone to that hand.
  ToolContacts settled(const Pose& hand)
  {
    EXPECT_TRUE(settle(*this->move_, hand));
    return this->now();
  }

  ToolContacts now()
  {
    ToolContacts set = this->move_->contacts();
    set.held = true;
    set.revision = ++this->revision_;
    return set;
  }

  TickOutput tick(const ToolContacts& set, const Pose& hand)
  {
    TickInput input;
    input.tick = ++this->ticks_;
    input.dt_s = tick_s;
    input.sample.pose_D = hand;
    input.scene = this->scene_.get();
    input.tool = &set;
    return renderTick(input, this->parameters_, this->state_);
  }

  std::shared_ptr<const Scene> scene_;
  std::optional<ToolMove> move_;
  std::uint64_t revision_ = 0, ticks_ = 0;
  HapticParameters parameters_;
  RendererState state_;
};

Pose pressed(double depth_m, const Vec3& turn_rad = Vec3::Zero())
{
  return { Vec3(0, 0, halfCube - depth_m), turnBy(turn_rad) };
}

TEST_F(ToolTick, PushesTheHandByTheStiffnessTimesTheWayAndTheLeversSquareTimesTheTurn)
{
  // The cube lies flat, the hand that holds its centre is 3 mm deep and turned about y.
  const double lever = this->move_->tool().gyration_u, y_rad = 0.02;
  const Pose hand = pressed(0.003, Vec3(0, y_rad, 0));
  const ToolContacts set = this->settled(hand);
  const HapticState state = this->tick(set, hand).state;
  const Vec3 lift = set.pose_W.p - hand.p; // at rest the pull leads to where the tool is
  const Vec3 back = turnFromTo(hand.q, set.pose_W.q);
  ASSERT_GT(back.norm(), 0.5 * y_rad) << "it is pressed flat";
  EXPECT_LE((state.force_D - stiffness * lift).norm(), 1e-6 * stiffness * lift.norm());
  EXPECT_LE((state.torque_D - stiffness * lever * lever * back).norm(), 1e-4 * stiffness * lever * lever * back.norm());
  EXPECT_EQ(state.proxy_W.p, set.pose_W.p);
  EXPECT_TRUE(state.tool.held && state.tool.placed);
  ASSERT_GT(state.contacts, 0);
  Vec3 pushed = Vec3::Zero(); // each contact pushes along its normal; together they are the force
  for (int i = 0; i < state.contacts; ++i)
  {
    pushed += stiffness * state.tool.presses[i].push_u * state.tool.presses[i].n_W;
    EXPECT_NEAR(state.tool.presses[i].p_W.z(), 0.0, 1e-6) << "on the plane";
  }
  EXPECT_LE((pushed - state.force_D).norm(), 1e-9 * pushed.norm());
}

TEST_F(ToolTick, LimitsForceAndTorqueAndTheirRise)
{
  const Pose hand = pressed(0.005, Vec3(0, 0.5, 0));
  const ToolContacts set = this->settled(hand);
  const ToolPush asked = toolPush(set, hand, stiffness, ToolCoupling::Constraints);
  ASSERT_GT(asked.wrench_W.force.norm(), 2.0);
  ASSERT_GT(asked.wrench_W.torque.norm(), 0.05);
  SafetyLimits& limits = this->parameters_.safety;
  limits.maxForce_N = 2.0;
  limits.maxTorque_Nm = 0.05;
  limits.maxRise_N_per_s = 150.0;
  limits.maxTorqueRise_Nm_per_s = 5.0;
  for (int i = 1; i <= 100; ++i)
  {
    const HapticState state = this->tick(set, hand).state;
    EXPECT_LE(state.force_D.norm(), std::min(2.0, 150.0 * tick_s * i) * (1.0 + 1e-12));
    EXPECT_LE(state.torque_D.norm(), std::min(0.05, 5.0 * tick_s * i) * (1.0 + 1e-12));
    EXPECT_TRUE(state.clamped);
  }
}

TEST_F(ToolTick, OfADeviceThatTurnsNobodyGivesTheForceAlone)
{
  const Pose hand = pressed(0.003, Vec3(0, 0.1, 0));
  const ToolContacts set = this->settled(hand);
  this->parameters_.safety.maxTorque_Nm = 0.0;
  const TickOutput out = this->tick(set, hand);
  EXPECT_EQ(out.command.wrench_D.torque, Vec3(0, 0, 0));
  EXPECT_GT(out.command.wrench_D.force.z(), 0.9 * stiffness * 0.003);
  EXPECT_GT(out.state.renderedTorque_D.norm(), 0.0) << "it is seen";
  EXPECT_FALSE(out.state.clamped);
}

TEST_F(ToolTick, SaysWhatOtherContactsAddToTheEnergyAndAllocatesNothing)
{
  const Pose hand = pressed(0.002);
  const ToolContacts none = this->now();
  const ToolContacts touching = this->settled(hand);
  const AllocationGuard guard;
  EXPECT_EQ(this->tick(none, hand).state.tool.injected_J, 0.0);
  const double injected_J = this->tick(touching, hand).state.tool.injected_J;
  HapticState state;
  for (int i = 0; i < 300; ++i)
  {
    state = this->tick(touching, hand).state;
    EXPECT_EQ(state.tool.injected_J, 0.0);
  }
  EXPECT_EQ(guard.allocations() + guard.locks(), 0u);
  const double held_J = 0.5 * stiffness * 0.002 * 0.002;
  EXPECT_NEAR(injected_J, held_J, 1e-3 * held_J);
  EXPECT_NEAR(state.energy.excess_J, held_J, 1e-3 * held_J) << "nobody has pressed it in";
}

TEST_F(ToolTick, WithFrictionDragsTheHandByFrictionTimesThePushAndAllocatesNothing)
{
  const double friction = 0.4, depth = 0.002, slide = 0.005;
  this->parameters_.contact.friction.kinetic = friction;
  const ToolContacts before = this->settled(pressed(depth)), touching = this->now();
  Pose hand = pressed(depth);
  hand.p.x() += slide;
  HapticState state = this->tick(before, hand).state;
  const AllocationGuard guard;
  for (int i = 0; i < 300; ++i)
  {
    state = this->tick(touching, hand).state;
  }
  EXPECT_EQ(guard.allocations() + guard.locks(), 0u);
  EXPECT_NEAR(state.force_D.z(), stiffness * depth, 1e-3 * stiffness * depth);
  EXPECT_NEAR(-state.force_D.x(), friction * stiffness * depth, 1e-3 * stiffness * depth);
}

TEST_F(ToolTick, SpreadsTheStepOfOtherContactsOverTime)
{
  const Pose hand = pressed(0.002);
  const ToolContacts none = this->now();
  const ToolContacts touching = this->settled(hand);
  Vec3 last = this->tick(none, hand).state.force_D;
  EXPECT_EQ(last, Vec3(0, 0, 0));
  const double whole_N = stiffness * 0.002;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 force = this->tick(touching, hand).state.force_D;
    EXPECT_LE((force - last).norm(), 0.2 + 1e-9);
    last = force;
  }
  EXPECT_NEAR(last.z(), whole_N, 1e-3 * whole_N);
}

// While it goes over to another scene it may stand nowhere for a moment.
TEST_F(ToolTick, GoneAndBackItPushesFromNothingOnAndNeverHarderThanBefore)
{
  const Pose hand = pressed(0.003);
  ToolContacts set = this->settled(hand), nowhere;
  const double whole_N = this->tick(set, hand).state.force_D.norm();
  ASSERT_NEAR(whole_N, stiffness * 0.003, 1e-3 * stiffness * 0.003);
  nowhere.held = true;
  nowhere.revision = ++this->revision_;
  EXPECT_EQ(this->tick(nowhere, hand).state.force_D, Vec3(0, 0, 0));
  set.revision = ++this->revision_;
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 force = this->tick(set, hand).state.force_D;
    EXPECT_LE((force - last).norm(), 0.2 + 1e-9);
    EXPECT_LE(force.norm(), whole_N * (1.0 + 1e-9));
    last = force;
  }
  EXPECT_NEAR(last.norm(), whole_N, 1e-3 * whole_N);
}

// A device that waits for its hand has no pose, and the tool has.
TEST_F(ToolTick, WithoutAHandStaysWhereItIs)
{
  const Pose hand = pressed(0.003);
  const ToolContacts set = this->settled(hand);
  const HapticState with = this->tick(set, hand).state;
  TickInput input;
  input.tick = ++this->ticks_;
  input.dt_s = tick_s;
  input.status = DeviceStatus::Waiting;
  input.scene = this->scene_.get();
  input.tool = &set;
  const HapticState without = renderTick(input, this->parameters_, this->state_).state;
  EXPECT_TRUE(without.held);
  EXPECT_TRUE(without.tool.placed);
  EXPECT_EQ(without.proxy_W.p, with.proxy_W.p);
  EXPECT_EQ(without.proxy_W.q.coeffs(), with.proxy_W.q.coeffs());
  EXPECT_EQ(without.tool.hand_W.p, with.tool.hand_W.p);
}

TEST_F(ToolTick, GivesNothingOverAClosedWayOfWaysAndTurns)
{
  // Within one set of contacts the spring has a potential. A force that is held for a tick gives at most K |step|^2 a
  // tick more than it takes.
  const ToolContacts set = this->settled(pressed(0.003));
  const double lever = this->move_->tool().gyration_u;
  constexpr int ticks = 100000;
  Pose last;
  double bound_J = 0.0, turned_J = 0.0;
  HapticState state;
  for (int i = 0; i <= ticks; ++i)
  {
    const double s = 2.0 * std::numbers::pi * i / ticks;
    const Pose hand{ Vec3(0.004 * std::sin(s), 0, halfCube - 0.002 + 0.003 * std::cos(s)),
      turnBy(Vec3(0, 0.05 * std::sin(s), 0)) };
    state = this->tick(set, hand).state;
    if (i > 0)
    {
      const double turn = lever * turnFromTo(last.q, hand.q).norm();
      bound_J += stiffness * ((hand.p - last.p).squaredNorm() + turn * turn);
      turned_J = std::max(turned_J, std::abs(state.turned_J));
    }
    last = hand;
  }
  ASSERT_GT(turned_J, 10.0 * bound_J) << "turning is a part of it";
  EXPECT_LE(std::abs(state.energy.delivered_J), bound_J);
  EXPECT_LE(state.energy.peakExcess_J, bound_J);
}

TEST_F(ToolTick, TurnsWithTheHandFromWhereItWasTaken)
{
  const ToolContacts set = this->now();
  this->state_ = RendererState{};
  const Quat first = turnBy(Vec3(0.3, -0.2, 0.5)), more = turnBy(Vec3(0, 0, 0.25));
  const auto wanted = [&](const Quat& hand) { return this->tick(set, { Vec3(0, 0, 0.05), hand }).state.tool.hand_W.q; };
  EXPECT_LE(turnFromTo(wanted(first), Quat::Identity()).norm(), 1e-12) << "as its mesh was given";
  EXPECT_LE(turnFromTo(wanted(more * first), more).norm(), 1e-12);
  EXPECT_LE(turnFromTo(wanted(Quat(0, 0, 0, 0)), more).norm(), 1e-12) << "a turn that is none";
  this->parameters_.clutch = true;
  wanted(more * more * first);
  this->parameters_.clutch = false;
  EXPECT_LE(turnFromTo(wanted(more * more * first), more).norm(), 1e-12) << "taken anew after the clutch";
  this->parameters_.map.q_WD = turnBy(Vec3(0, 1, 0));
  EXPECT_LE(turnFromTo(wanted(more * more * first), more).norm(), 1e-12) << "and in another map";
}

TEST_F(ToolTick, WithoutAPlaceForTheToolGivesNoForceAndSaysWhy)
{
  ToolContacts waiting;
  waiting.held = true;
  waiting.revision = 1;
  const HapticState state = this->tick(waiting, pressed(0.005)).state;
  EXPECT_EQ(state.force_D, Vec3(0, 0, 0));
  EXPECT_EQ(state.fault, Fault::ToolWaits);
}

} // namespace
} // namespace palpate::test
