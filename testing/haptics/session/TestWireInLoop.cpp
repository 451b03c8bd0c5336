// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose hand pushes a wire out of its sheath into a bent tube: felt as by the wire's own tick, recorded,
// gripped anew, turned, pulled out.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "HandOfTest.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/MechanismChoice.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/MechanismWorker.h"
#include "haptics/session/plan/HandMap.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/support/TemporaryFolder.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

using testing::HasSubstr;

constexpr double spring_N_per_m = 1000.0, turning_N_m_per_rad = 5e-4, scale_u_per_m = 1000.0;
constexpr double way_mm = 0.1; // a tick: .1 m/s

Tube shortTube()
{
  return { .first_mm = 10.0, .angle_rad = 0.5 * std::numbers::pi, .last_mm = 40.0, .around = 16, .ring_mm = 2.0 };
}

WireDescription angledWire()
{
  WireDescription wire = nitinolWire(100.0, 24, 0.1);
  wire.shape.tip = WireTip::Angled;
  wire.shape.tip_u = 6.0;
  return wire;
}

MechanismInputs wireIn(const WireDescription& description, const TriangleMesh& vessel_mm)
{
  MechanismBody body;
  body.name = "wire";
  body.kind = MechanismBodyKind::Wire;
  body.wire = std::make_shared<const PlannedWire>(planWire(description, vessel_mm, 1));
  MechanismInputs inputs;
  inputs.mechanism.bodies = { body };
  inputs.unit_m = 1.0 / scale_u_per_m;
  return inputs;
}

Pose handAt(double along_mm, double turn_rad = 0.0)
{
  return { Vec3(along_mm / scale_u_per_m, 0, 0), Quat(Eigen::AngleAxisd(turn_rad, Vec3::UnitX())) };
}

class WireInLoop : public testing::Test
{
protected:
  void begin(const MechanismInputs& inputs, bool turns = true, bool engage = true, const std::string& file = {})
  {
    HapticParameters& p = this->parameters;
    p.stiffness_N_per_m = spring_N_per_m;
    p.limitStiffness = false;
    p.mechanismTurning_N_m_per_rad = turning_N_m_per_rad;
    p.map.scale_u_per_m = scale_u_per_m;
    p.safety = this->safety;
    ASSERT_EQ(this->session.setParameters(p), "");
    this->session.choose<MechanismTask>({ std::make_shared<const MechanismInputs>(inputs), "wire", 30.0 });
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = file;
    options.engage = engage;
    ASSERT_EQ(this->session.start(std::make_unique<HandOfTest>(turns), options), "");
  }

  const HapticState& hold(double along_mm, double turn_rad = 0.0, int ticks = 1)
  {
    static_cast<HandOfTest*>(this->session.device())->move(handAt(along_mm, turn_rad));
    EXPECT_EQ(this->session.step(ticks), ticks);
    return this->session.state();
  }

  const HapticState& push(double from_mm, double to_mm, double turn_rad = 0.0)
  {
    const auto ticks = static_cast<int>(std::lround(std::abs(to_mm - from_mm) / way_mm));
    for (int i = 1; i <= ticks; ++i)
    {
      const double before_N = this->session.state().force_D.norm();
      const double now_N = this->hold(from_mm + (to_mm - from_mm) * i / ticks, turn_rad).force_D.norm();
      this->mostRise_N = std::max(this->mostRise_N, now_N - before_N);
    }
    return this->session.state();
  }

  void clutch(bool held)
  {
    HandWishes wishes;
    wishes.clutch = held;
    const HapticState& state = this->session.state();
    const auto change = this->hands.follow(wishes, this->parameters.map, { state.handle_D, state.device_W.p });
    ASSERT_TRUE(change);
    this->parameters.map = change->map;
    this->parameters.clutch = change->clutch;
    ASSERT_EQ(this->session.setParameters(this->parameters), "");
  }

  HapticSession session;
  HapticParameters parameters;
  SafetyLimits safety = SafetyLimits::none();
  HandMap hands;
  double mostRise_N = 0.0;
};

TEST_F(WireInLoop, ItsForceAndTorqueAreThoseOfTheWiresOwnTick)
{
  PushedWire own(angledWire(), shortTube().mesh());
  this->parameters.sceneBlend_s = 0.0; // else the first force comes over 30 ms
  this->begin(wireIn(angledWire(), shortTube().mesh()));
  double most_N = 0.0, most_Nm = 0.0;
  for (int i = 0; i <= 700; ++i)
  {
    const double turn_rad = i * 4e-3;
    const HapticState& state = this->hold(i * way_mm, turn_rad);
    ASSERT_TRUE(state.mechanism.held);
    WireInput input;
    input.plan = own.planned.plan.get();
    input.hand_W = state.mechanism.hand_W;
    input.coupling_N_per_u = spring_N_per_m / scale_u_per_m;
    const double lever_m = mechanismLever_m(turning_N_m_per_rad, spring_N_per_m);
    input.turning_Nu_per_rad = spring_N_per_m * lever_m * lever_m * scale_u_per_m; // to the bit: errors of it grow
    input.budget = this->parameters.contact.workBudget;
    const WireResult& result = own.ticks.step(input);
    ASSERT_LE((state.force_W - result.wrench_W.force).norm(), 1e-9) << i;
    ASSERT_LE((state.torque_D - result.wrench_W.torque / scale_u_per_m).norm(), 1e-9) << i;
    ASSERT_NEAR(state.mechanism.wire.pushed_u, result.pushed_u, 1e-9);
    ASSERT_NEAR(state.mechanism.wire.turned_rad, result.turned_rad, 1e-9);
    ASSERT_NEAR(state.mechanism.wire.wall_N, result.wall_N, 1e-9);
    ASSERT_EQ(state.contacts, result.pressCount);
    most_N = std::max(most_N, result.wrench_W.force.norm());
    most_Nm = std::max(most_Nm, state.torque_D.norm());
  }
  EXPECT_GT(most_N, 0.1);
  EXPECT_GT(most_Nm, 1e-5);
}

TEST_F(WireInLoop, AlongAPathItHasEveryBitOfItsOwnTick)
{
  PushedWire own(angledWire(), shortTube().mesh());
  MechanismHold hold;
  hold.stiffness_N_per_m = spring_N_per_m;
  hold.scale_u_per_m = scale_u_per_m;
  std::string refusal;
  const auto touch = MechanismTouch::make(wireIn(angledWire(), shortTube().mesh()), hold, refusal);
  ASSERT_NE(touch, nullptr) << refusal;
  own.coupling_N_per_mm = spring_N_per_m / scale_u_per_m;
  for (int i = 0; i <= 500; ++i)
  {
    const WireResult& result = own.tick(way_mm * i);
    const MechanismResult along = touch->next(1e-3 * (i + 1), { Vec3(way_mm * i, 0, 0), Quat::Identity() });
    ASSERT_EQ(along.wrench_W.force, result.wrench_W.force) << i;
    ASSERT_EQ(along.pose_W[0].p, result.tip_W);
  }
  EXPECT_EQ(touch->check().wire->beams, 24);
}

TEST_F(WireInLoop, ReplaysBitForBitWithAnyNumberOfWorkersAlsoFromHalfway)
{
  const TemporaryFolder folder;
  this->begin(wireIn(angledWire(), shortTube().mesh()), true, true, folder.file("whole"));
  this->push(0.0, 30.0);
  ASSERT_GT(this->session.state().force_W.norm(), 0.01);
  const HapticState before = this->session.state();
  ASSERT_EQ(this->session.record(folder.file("half")), "");
  const HapticState& after = this->hold(30.0);
  EXPECT_NEAR(after.mechanism.wire.pushed_u, before.mechanism.wire.pushed_u, 0.05) << "as a recording begins";
  EXPECT_NEAR(after.mechanism.wire.wall_N, before.mechanism.wire.wall_N, 0.1 * before.mechanism.wire.wall_N);
  this->push(30.0, 40.0, 1.0);
  this->push(40.0, 35.0, 2.0);
  EXPECT_EQ(this->session.stop(), "");
  for (const auto& [name, ticks] : { std::pair("whole", 300u), std::pair("half", 151u) })
  {
    auto read = readRecording(folder.file(name));
    ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
    for (const unsigned workers : { 1u, 2u, 4u })
    {
      double most_N = 0.0;
      const ReplayResult result = replay(std::get<Recording>(read), {}, workers,
        [&most_N](const TickOutput& out) { most_N = std::max(most_N, out.command.wrench_D.force.norm()); });
      EXPECT_EQ(result.problem + result.difference, "");
      EXPECT_EQ(result.ticks, ticks);
      EXPECT_GT(most_N, 0.01);
    }
  }
}

TEST_F(WireInLoop, EveryBitThatFlipsInARecordingOfItIsNamed)
{
  const TemporaryFolder folder;
  this->begin(wireIn(angledWire(), shortTube().mesh()), true, true, folder.file("a"));
  this->push(0.0, 2.0);
  EXPECT_EQ(this->session.stop(), "");
  FlippedBits(folder.file("a")).expectEachIsNamed(35, "joined");
}

TEST_F(WireInLoop, GivesNoForceUntilItIsAskedFor)
{
  this->safety = SafetyLimits();
  this->safety.engageRamp_s = 0.05;
  this->begin(wireIn(angledWire(), shortTube().mesh()), true, false);
  EXPECT_EQ(this->push(0.0, 35.0).force_D, Vec3(0, 0, 0));
  EXPECT_GT(this->session.state().mechanism.wire.wall_N, 0.0);
  this->push(35.0, 0.0);
  this->session.engage();
  EXPECT_LT(this->push(0.0, 35.0).force_D.x(), -0.01);
}

TEST_F(WireInLoop, WhileTheClutchIsHeldTheSheathHoldsItSoThatAShortHandPushesALongWire)
{
  this->safety = SafetyLimits();
  this->safety.engageRamp_s = 0.02;
  this->begin(wireIn(nitinolWire(100.0, 24, 0.1), shortTube().mesh()));
  constexpr double stroke_mm = 16.0;
  const double limit_N = this->safety.maxRise_N_per_s * 1e-3;
  for (int i = 1; i <= 4; ++i)
  {
    const HapticState before = this->push(0.0, stroke_mm);
    EXPECT_NEAR(before.mechanism.wire.pushed_u, i * stroke_mm, 1.0) << "but for the hand's spring";
    this->clutch(true);
    this->push(stroke_mm, 0.0);
    EXPECT_EQ(this->session.state().force_D, Vec3(0, 0, 0)) << "it has faded";
    EXPECT_NEAR(this->session.state().mechanism.wire.pushed_u, before.mechanism.wire.pushed_u, 0.1);
    this->clutch(false);
  }
  EXPECT_LE(this->mostRise_N, limit_N + 1e-12);
  EXPECT_GT(this->session.state().mechanism.wire.pushed_u, 60.0);
}

TEST_F(WireInLoop, PulledOutItLetsTheHandGo)
{
  this->begin(wireIn(angledWire(), shortTube().mesh()));
  this->push(0.0, 30.0);
  ASSERT_GT(this->session.state().force_W.norm(), 0.01);
  this->push(30.0, -30.0);
  EXPECT_LE(this->hold(-30.0, 0.0, 5).force_W.norm(), 1e-9);
  EXPECT_LE(this->session.state().mechanism.wire.pushed_u, 0.0);
  EXPECT_GE(this->session.state().mechanism.wire.pushed_u, -100.0 / 24.0 - 1e-6) << "a beam behind the mouth it stays";
  EXPECT_EQ(this->session.state().contacts, 0);
}

TEST_F(WireInLoop, ADeviceWithoutTurnsTurnsItByAParameterAtATurnInASecond)
{
  const Tube wide{ .radius_mm = 20.0, .before_mm = 30.0, .first_mm = 60.0, .ring_mm = 5.0 };
  this->begin(wireIn(angledWire(), wide.mesh()), false);
  this->push(0.0, 30.0);
  const Vec3 before_mm = this->session.state().proxy_W.p;
  this->parameters.wireTurn_deg = 120.0;
  ASSERT_EQ(this->session.setParameters(this->parameters), "");
  EXPECT_NEAR(this->hold(30.0, 0.0, 100).mechanism.wire.turned_rad, 0.2 * std::numbers::pi, 1e-9) << "of .1 s";
  const HapticState& state = this->hold(30.0, 0.0, 500);
  EXPECT_NEAR(state.mechanism.wire.turned_rad, 2.0 / 3.0 * std::numbers::pi, 1e-9);
  const Vec3 turned_mm = Eigen::AngleAxisd(2.0 / 3.0 * std::numbers::pi, Vec3::UnitX()) * before_mm;
  EXPECT_GT(before_mm.tail<2>().norm(), 3.0);
  EXPECT_LE((state.proxy_W.p - turned_mm).norm(), 1e-3);
  EXPECT_EQ(state.torque_D, Vec3(0, 0, 0));
}

TEST_F(WireInLoop, OfADeviceThatTurnsTheParameterIsAddedToTheHand)
{
  const Tube wide{ .radius_mm = 20.0, .before_mm = 30.0, .first_mm = 60.0, .ring_mm = 5.0 };
  this->begin(wireIn(angledWire(), wide.mesh()));
  this->parameters.wireTurn_deg = 45.0;
  ASSERT_EQ(this->session.setParameters(this->parameters), "");
  this->hold(0.0);
  for (int i = 1; i <= 200; ++i)
  {
    this->hold(0.0, 1e-3 * i);
  }
  EXPECT_NEAR(this->hold(0.0, 0.2, 300).mechanism.wire.turned_rad, 0.25 * std::numbers::pi + 0.2, 1e-6);
}

TEST_F(WireInLoop, ItsNodesAreToBeSeenInTheScene)
{
  WireDescription wire = angledWire();
  wire.mouth_W = Vec3(5, 0, 0);
  this->begin(wireIn(wire, shortTube().mesh()));
  this->push(0.0, 30.0);
  const HapticState& state = this->hold(30.0, 0.0, 200);
  const std::vector<Vec3> nodes_W = this->session.status<MechanismTask>().wire_W;
  ASSERT_EQ(nodes_W.size(), 25u);
  EXPECT_LE((nodes_W.back() - state.proxy_W.p).norm(), 1e-3);
  const double length_mm = planWire(wire, shortTube().mesh(), 1).plan->length_u(); // a chord less at the angle
  EXPECT_NEAR(nodes_W.front().x(), 5.0 + state.mechanism.wire.pushed_u - length_mm, 1e-3);
  ASSERT_GT(state.mechanism.touching, 0);
  const auto drawn = state.mechanism.found.begin();
  const auto largest = std::max_element(drawn, drawn + state.mechanism.touching,
    [](const FoundPress& a, const FoundPress& b) { return a.force_W.norm() < b.force_W.norm(); });
  EXPECT_NEAR(largest->force_W.norm(), state.mechanism.wire.wall_N, 1e-12) << "the arrows that are drawn";
  EXPECT_LE((largest->at_W - state.mechanism.wire.wall_W).norm(), 1e-12);
}

TEST_F(WireInLoop, WhatCannotBeIsOneSentenceAndIsNotFelt)
{
  WireDescription thick = angledWire();
  thick.diameter_u = 3.0;
  MechanismInputs beside = wireIn(angledWire(), shortTube().mesh());
  beside.mechanism.bodies.emplace_back().name = "world";
  MechanismInputs nothing = wireIn(angledWire(), shortTube().mesh());
  nothing.mechanism.bodies[0].wire = nullptr;
  for (const auto& [inputs, fault] : { std::pair(wireIn(thick, shortTube().mesh()), "thicker than the vessel"),
         std::pair(beside, "only body"), std::pair(nothing, "without a vessel") })
  {
    this->begin(inputs);
    EXPECT_FALSE(this->hold(20.0, 0.0, 5).mechanism.held);
    EXPECT_THAT(this->session.status<MechanismTask>().problem, HasSubstr(fault));
    EXPECT_EQ(this->session.state().force_D, Vec3(0, 0, 0));
    EXPECT_EQ(this->session.stop(), "");
  }
}

} // namespace
} // namespace palpate::test
