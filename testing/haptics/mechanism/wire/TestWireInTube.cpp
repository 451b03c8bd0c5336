// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "BentTube.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/AllocationGuard.h"

namespace palpate::test
{
namespace
{

/// The vessel turns by half a turn and leads on beside the sheath: there the wire is not in the sheath.
TEST(WireInTube, WhereItComesBackBesideTheSheathTheWallHoldsIt)
{
  const Tube tube{ .first_mm = 10.0, .angle_rad = std::numbers::pi, .last_mm = 40.0, .around = 24, .ring_mm = 0.5 };
  PushedWire wire(nitinolWire(length_mm, 64, 0.0), tube.mesh());
  double deepest_mm = 0.0;
  Vec3 tip_mm = Vec3::Zero();
  for (int i = 0; i <= 1150; ++i)
  {
    const WireResult& result = wire.tick(way_mm * i);
    deepest_mm = std::max(deepest_mm, result.deepest_u);
    tip_mm = result.tip_W;
  }
  EXPECT_LT(tip_mm.x(), -10.0);
  EXPECT_NEAR(tip_mm.y(), 50.0, 0.75);
  EXPECT_LE(std::abs(tip_mm.z()), 0.75);
  EXPECT_LE(deepest_mm, 0.03);
  EXPECT_GE(nearestWall_mm(*wire.planned.plan, wire.ticks.state()), 0.25 - 0.03);
}

/// A wire that leaves the sheath by 50 mm and presses a flat wall without friction: its tip slides along the wall, so
/// that it is half of a pinned column of 100 mm. The sheath is a little askew, else it would stay straight.
class PressedColumn
{
public:
  static constexpr double wall_mm = 50.0, wire_mm = 62.0;

  /// The force at which so much more wire is outside than there is room for.
  double bent_N(double more_mm)
  {
    WireResult result;
    for (; result.pushed_u < wall_mm + more_mm; this->hand_mm_ += 0.02)
    {
      result = this->wire_.tick(this->hand_mm_);
    }
    for (int i = 0; i < 1000; ++i)
    {
      result = this->wire_.tick(this->hand_mm_);
    }
    this->outside_mm_ = result.pushed_u;
    return result.wrench_W.force.norm();
  }

  /// Euler's force, and the elastica's first term beyond it, of a wire that is clamped so far behind the mouth.
  [[nodiscard]] double theory_N(double behind_mm) const
  {
    const double column_mm = this->outside_mm_ + behind_mm;
    const double euler_N = std::pow(0.5 * std::numbers::pi / column_mm, 2) * roundSection(0.25, 60e3, 0.3).bend_Nu2;
    return euler_N * (1.0 + 0.5 * (this->outside_mm_ - wall_mm) / this->outside_mm_);
  }
  [[nodiscard]] double beam_mm() const { return this->wire_.planned.plan->wire.beams[0].length_u; }

private:
  static WireDescription description()
  {
    WireDescription wire = nitinolWire(wire_mm, 64, 0.0);
    wire.direction_W = Vec3(1.0, 1e-3, 0.0);
    return wire;
  }

  PushedWire wire_{ description(),
    Tube{ .radius_mm = 30.0, .before_mm = 5.0, .first_mm = wall_mm + 0.25, .blind = true, .ring_mm = 10.0 }.mesh() };
  double hand_mm_ = 0.0;
  double outside_mm_ = wall_mm;
};

/// The mouth holds the wire's place alone, and the node behind it is let go as it comes out: for the column that is a
/// clamp up to four tenths of a beam behind the mouth.
TEST(WireInTube, AWireThatPressesAWallBucklesAtEulersForceAndThenFollowsTheElastica)
{
  PressedColumn column;
  ASSERT_NEAR(column.theory_N(0.0), 0.18168, 1e-5);
  for (const double more_mm : { 0.2, 0.5, 1.0, 2.0 })
  {
    const double force_N = column.bent_N(more_mm);
    RecordProperty("at" + std::to_string(more_mm), std::to_string(force_N / column.theory_N(0.0)));
    EXPECT_LE(force_N, 1.002 * column.theory_N(0.0)) << more_mm;
    EXPECT_GE(force_N, 0.998 * column.theory_N(0.4 * column.beam_mm())) << more_mm;
  }
}

/// Of 1700 ticks, which lead the tip through the bend and on.
struct Seen
{
  double residual_mm = 0.0;
  double deepest_mm = 0.0;
  std::uint32_t work = 0;
  int pressed = 0;
  int crowded = 0; ///< ticks with more contacts than there is room for

  void see(const WireResult& result)
  {
    this->residual_mm = std::max(this->residual_mm, result.residual_u);
    this->deepest_mm = std::max(this->deepest_mm, result.deepest_u);
    this->work = std::max(this->work, result.work);
    this->pressed = std::max(this->pressed, result.pressCount);
    this->crowded += result.leftOut > 0 ? 1 : 0;
  }
};

constexpr int wholeWay = 1700; // ticks

TEST(WireInTube, ASessionsBudgetIsEnoughForEveryTickOf64BeamsWithFrictionAndChangesNoBit)
{
  const TriangleMesh vessel = bentTube().mesh();
  PushedWire wire(nitinolWire(length_mm, 64, 0.1), vessel), unbounded(nitinolWire(length_mm, 64, 0.1), vessel);
  wire.budget = ContactPlan().workBudget;
  Seen seen;
  for (int i = 0; i < wholeWay; ++i)
  {
    const WireResult& result = wire.tick(way_mm * i);
    seen.see(result);
    ASSERT_EQ(result.wrench_W.force, unbounded.tick(way_mm * i).wrench_W.force) << i;
  }
  RecordProperty("work", std::to_string(seen.work));
  RecordProperty("deepest", std::to_string(seen.deepest_mm));
  EXPECT_LT(seen.work, wire.budget);
  EXPECT_LE(seen.residual_mm, 1e-6 * 0.25);
  EXPECT_LE(seen.deepest_mm, 0.01);
  EXPECT_GT(seen.pressed, 12);
  EXPECT_GT(seen.crowded, 0) << "all room for contacts is used";
}

TEST(WireInTube, WhereTheBudgetIsUsedUpItsSkinStaysOutOfTheWallAllTheSame)
{
  for (const std::uint32_t budget : { 5000u, 20000u })
  {
    PushedWire wire(nitinolWire(length_mm, 64, 0.1), bentTube().mesh());
    wire.budget = budget;
    Seen seen;
    int told = 0;
    double most_N = 0.0;
    for (int i = 0; i < wholeWay; ++i)
    {
      const WireResult& result = wire.tick(way_mm * i);
      seen.see(result);
      told += result.capped ? 1 : 0;
      most_N = std::max(most_N, result.wrench_W.force.norm());
    }
    EXPECT_GT(told, wholeWay / 2);
    EXPECT_LE(seen.deepest_mm, 0.03) << budget;
    EXPECT_LE(most_N, 2.0) << "as strong as it is solved";
  }
}

WireResult atRest(PushedWire& wire)
{
  for (int i = 0; i <= 900; ++i)
  {
    static_cast<void>(wire.tick(way_mm * i));
  }
  WireResult result;
  for (int i = 0; i < 400; ++i)
  {
    result = wire.tick(way_mm * 900);
  }
  return result;
}

Vec3 wallOf_N(const WireResult& result)
{
  Vec3 wall_N = Vec3::Zero();
  for (int i = 0; i < result.pressCount; ++i)
  {
    wall_N += result.presses[i].force_M;
  }
  return wall_N;
}

TEST(WireInTube, WithFrictionForcesLieInTheirConesAndTheHandFeelsTheirSum)
{
  PushedWire wire(nitinolWire(length_mm, 64, 0.1), bentTube().mesh());
  const WireResult result = atRest(wire);
  for (int i = 0; i < result.pressCount; ++i)
  {
    const WirePress& press = result.presses[i];
    EXPECT_LE(press.axes_N.tail<2>().norm(), 0.1 * press.axes_N.x() * (1.0 + 1e-9));
    EXPECT_NEAR(press.axes_N.norm(), press.force_M.norm(), 1e-12);
  }
  EXPECT_NEAR(result.wrench_W.force.x(), wallOf_N(result).x(), 1e-12);
  EXPECT_LE(result.deepest_u, 1e-6);
}

TEST(WireInTube, AtRestItIsNotInTheWallAndTheHandFeelsWhatTheWallPresses)
{
  PushedWire wire(nitinolWire(length_mm, 64, 0.0), bentTube().mesh());
  const WireResult result = atRest(wire);
  const Vec3 wall_N = wallOf_N(result);
  EXPECT_GT(result.pressCount, 3);
  EXPECT_LT(wall_N.x(), -0.05);
  EXPECT_NEAR(result.wrench_W.force.x(), wall_N.x(), 1e-12);
  EXPECT_EQ(result.wrench_W.force.tail<2>().norm(), 0.0);
  EXPECT_LE(result.deepest_u, 1e-6);
  EXPECT_GE(nearestWall_mm(*wire.planned.plan, wire.ticks.state()), 0.25 - 1e-6);
}

TEST(WireInTube, NoJerkOfTheHandBringsItsAxisThroughTheWall)
{
  PushedWire wire(nitinolWire(100.0, 32, 0.1), bentTube().mesh());
  constexpr double middle_mm = 60.0;
  for (int i = 0; i < middle_mm / way_mm; ++i)
  {
    static_cast<void>(wire.tick(way_mm * i));
  }
  for (int i = 0; i < 100; ++i)
  {
    const double hand_mm = middle_mm + 20.0 * std::sin(0.9 * i) + 10.0 * std::sin(0.31 * i);
    const WireResult& result = wire.tick(hand_mm);
    ASSERT_TRUE(result.wrench_W.force.allFinite());
    const Vec3 tip_mm = result.tip_W;
    ASSERT_GT(nearestWall_mm(*wire.planned.plan, wire.ticks.state()), 0.0) << i;
    ASSERT_LT(std::abs(tip_mm.z()), 1.0) << i; // in the tube
  }
}

TEST(WireInTube, AHandThatJumpsIsSlowedToARadiusATickAndThatIsToldAndItsTicksStayCheap)
{
  constexpr double jump_mm = 120.0, radius_mm = 0.25;
  constexpr int slowed = static_cast<int>(jump_mm / radius_mm);
  PushedWire wire(nitinolWire(length_mm, 64, 0.1), bentTube().mesh());
  static_cast<void>(wire.tick(0.0));
  double before_mm = 0.0, deepest_mm = 0.0;
  int looked = 0, queries = 0;
  for (int i = 1; i <= slowed + 100; ++i)
  {
    const WireResult& result = wire.tick(jump_mm);
    ASSERT_EQ(result.capped || i >= slowed, true) << i;
    ASSERT_EQ(result.crowded, 0) << i;
    EXPECT_LE(result.pushed_u, radius_mm * i + 1e-9) << i;
    EXPECT_LE(result.pushed_u - before_mm, 2.0 * radius_mm) << i;
    before_mm = result.pushed_u;
    deepest_mm = std::max(deepest_mm, result.deepest_u);
    looked = std::max(looked, result.looked);
    queries = std::max(queries, result.queries);
  }
  const WireResult& last = wire.tick(jump_mm);
  RecordProperty("looked", std::to_string(looked) + " " + std::to_string(queries));
  EXPECT_FALSE(last.capped);
  EXPECT_NEAR(last.pushed_u, jump_mm + last.wrench_W.force.x() / wire.coupling_N_per_mm, 1e-9);
  EXPECT_GT(last.pushed_u, jump_mm - 1.0);
  EXPECT_LE(deepest_mm, 0.03);
  EXPECT_LE(looked, 4000) << "no more than where it slides";
  EXPECT_LE(queries, 20);
}

/// The bend begins before the first beam is out of the sheath.
TEST(WireInTube, ItComesOutOfTheSheathBeamByBeamWithoutAStep)
{
  const Tube tube{ .first_mm = 2.0, .angle_rad = 0.5 * std::numbers::pi, .last_mm = 5.0, .around = 24, .ring_mm = 0.5 };
  PushedWire wire(nitinolWire(60.0, 20, 0.0), tube.mesh());
  constexpr double small_mm = 0.01;
  double before_N = 0.0, most_N = 0.0, largest_N = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const double force_N = wire.tick(small_mm * i).wrench_W.force.x();
    most_N = std::max(most_N, std::abs(force_N - before_N));
    largest_N = std::max(largest_N, std::abs(force_N));
    before_N = force_N;
  }
  EXPECT_GT(largest_N, 0.1);
  EXPECT_LE(most_N, 2.0 * small_mm * wire.coupling_N_per_mm); // twice that of a wall
}

TEST(WireInTube, AHookThatIsStraightInTheSheathTakesItsShapeOutside)
{
  WireDescription hook = nitinolWire(60.0, 20, 0.0);
  hook.shape.tip = WireTip::Hook;
  hook.shape.tip_u = 30.0;
  PushedWire wire(hook, Tube{ .radius_mm = 60.0, .before_mm = 60.0, .first_mm = 80.0, .ring_mm = 10.0 }.mesh());
  for (int i = 0; i <= 500; ++i)
  {
    static_cast<void>(wire.tick(std::min(way_mm * i, 45.0)));
  }
  const std::vector<Vec3> rest = pointsOf(hook.shape).value;
  const WirePlaces& places_M = wire.ticks.state().places_M;
  EXPECT_NEAR((places_M[20].p - places_M[10].p).norm(), (rest[20] - rest[10]).norm(), 1e-6);
  EXPECT_NEAR((places_M[20].p - places_M[10].p).norm(), 60.0 / std::numbers::pi, 0.05); // the hook's two radii
}

TEST(WireInTube, ABlindEndIsAsStiffAsHandAndWireInARow)
{
  const Tube tube{ .first_mm = 30.0, .blind = true };
  PushedWire wire(nitinolWire(100.0, 32, 0.2), tube.mesh());
  wire.coupling_N_per_mm = 10.0;
  double force_N = 0.0;
  constexpr double beyond_mm = 0.05;
  const double end_mm = 30.0 - 0.25; // its round tip touches
  for (int i = 0; i <= 400; ++i)
  {
    force_N = -wire.tick(std::min(way_mm * i, end_mm + beyond_mm)).wrench_W.force.x();
  }
  const double stretch_N = wire.planned.plan->wire.beams[0].section.stretch_N;
  EXPECT_NEAR(force_N, beyond_mm / (1.0 / 10.0 + 100.0 / stretch_N), 1e-4 * force_N);
}

TEST(WireInTube, ItsBentTipGoesAroundWithTheHand)
{
  WireDescription bent = nitinolWire(60.0, 20, 0.0);
  bent.shape.tip = WireTip::Angled;
  bent.shape.tip_u = 6.0;
  PushedWire wire(bent, Tube{ .radius_mm = 20.0, .before_mm = 30.0, .first_mm = 60.0, .ring_mm = 5.0 }.mesh());
  wire.turning_Nmm_per_rad = 100.0;
  for (int i = 0; i <= 300; ++i)
  {
    static_cast<void>(wire.tick(way_mm * i));
  }
  const Vec3 before = wire.ticks.state().places_M[20].p;
  for (int i = 0; i <= 300; ++i)
  {
    static_cast<void>(wire.tick(way_mm * 300, 4.0 * i / 300)); // more than half a turn
  }
  for (int i = 0; i < 100; ++i)
  {
    static_cast<void>(wire.tick(way_mm * 300, 4.0));
  }
  const Vec3 after = wire.ticks.state().places_M[20].p;
  const Vec3 turned = Eigen::AngleAxisd(4.0, Vec3::UnitX()) * before;
  EXPECT_GT(before.tail<2>().norm(), 3.0);
  EXPECT_LE((after - turned).norm(), 1e-3);
}

/// The bend's friction holds the wire, so that the hand's turn twists the first beam.
TEST(WireInTube, TheHandsTurningSpringIsInBalanceWithTheTwistOfTheFirstBeam)
{
  PushedWire wire(nitinolWire(length_mm, 64, 0.3), bentTube().mesh());
  wire.turning_Nmm_per_rad = 0.5;
  WireResult result;
  for (int i = 0; i <= 1600; ++i)
  {
    const double turn_rad = std::clamp((i - 900) / 400.0, 0.0, 1.0);
    result = wire.tick(std::min(way_mm * i, way_mm * 900), turn_rad);
  }
  const WirePlaces& places_M = wire.ticks.state().places_M;
  const WireBeam& beam = wire.planned.plan->wire.beams[0];
  const double twist_rad = rotationVector(places_M[0].q.conjugate() * places_M[1].q).x();
  EXPECT_LT(result.wrench_W.torque.x(), -1e-3);
  EXPECT_NEAR(result.wrench_W.torque.x(), beam.section.twist_Nu2 / beam.length_u * twist_rad,
    1e-3 * std::abs(result.wrench_W.torque.x()));
}

TEST(WireInTube, ATickNeitherAllocatesNorLocks)
{
  PushedWire wire(nitinolWire(length_mm, 64, 0.1), bentTube().mesh());
  static_cast<void>(wire.tick(0.0));
  int pressed = 0;
  const AllocationGuard guard;
  for (int i = 1; i <= 700; ++i)
  {
    pressed = std::max(pressed, wire.tick(way_mm * i).pressCount);
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u);
  EXPECT_GT(pressed, 3);
}

TEST(WireInTube, PulledOutItIsLetGo)
{
  PushedWire wire(nitinolWire(60.0, 20, 0.1), Tube{}.mesh());
  static_cast<void>(wire.tick(0.0));
  for (int i = 0; i <= 500; ++i)
  {
    EXPECT_NEAR(wire.tick(-way_mm * i).wrench_W.force.x(), 0.0, 1e-9);
  }
  EXPECT_NEAR(wire.ticks.state().places_M[20].p.x(), -3.0, 1e-9); // a beam behind the mouth
}

TEST(WireInTube, FromAStateItGoesOnBitForBit)
{
  const TriangleMesh vessel = bentTube().mesh();
  PushedWire first(nitinolWire(length_mm, 40, 0.1), vessel), again(nitinolWire(length_mm, 40, 0.1), vessel);
  for (int i = 0; i <= 700; ++i)
  {
    static_cast<void>(first.tick(way_mm * i));
  }
  again.ticks.restore(first.ticks.state());
  for (int i = 0; i < 100; ++i)
  {
    const WireResult one = first.tick(70.0 - way_mm * i), other = again.tick(70.0 - way_mm * i);
    ASSERT_EQ(one.wrench_W.force, other.wrench_W.force);
    ASSERT_EQ(one.tip_W, other.tip_W);
    ASSERT_EQ(one.pressCount, other.pressCount);
    ASSERT_EQ(one.wall_N, other.wall_N);
  }
}

TEST(WireInTube, AUsedUpBudgetIsTold)
{
  PushedWire wire(nitinolWire(100.0, 32, 0.1), bentTube().mesh());
  WireInput input;
  input.plan = wire.planned.plan.get();
  input.coupling_N_per_u = 1.0;
  EXPECT_FALSE(wire.ticks.step(input).capped);
  input.budget = 1;
  EXPECT_TRUE(wire.ticks.step(input).capped);
  input.hand_W.p.x() = std::nan("");
  EXPECT_EQ(wire.ticks.step(input).wrench_W.force, Vec3(Vec3::Zero()));
}

std::string faultOf(const WireDescription& description, const TriangleMesh& vessel)
{
  const PlannedWire planned = planWire(description, vessel, 1);
  EXPECT_EQ(planned.plan, nullptr);
  return planned.check.faults.empty() ? "" : planned.check.faults.front();
}

TEST(WireInTube, WhatCannotBeIsOneSentence)
{
  using testing::HasSubstr;
  const TriangleMesh tube = Tube{}.mesh();
  const auto with = [&tube](auto change)
  {
    WireDescription wire = nitinolWire(60.0, 20, 0.1);
    change(wire);
    return faultOf(wire, tube);
  };
  EXPECT_THAT(with([](auto& w) { w.shape.length_u = 0.0; }), HasSubstr("length"));
  EXPECT_THAT(with([](auto& w) { w.shape.beams = 65; }), HasSubstr("1 to 64 beams, not 65"));
  EXPECT_THAT(with([](auto& w) { w.diameter_u = 0.0; }), HasSubstr("diameter"));
  EXPECT_THAT(with([](auto& w) { w.diameter_u = 2.5; }), HasSubstr("thicker than the vessel at the mouth"));
  EXPECT_THAT(with([](auto& w) { w.young_N_per_u2 = std::nan(""); }), HasSubstr("stiffness"));
  EXPECT_THAT(with([](auto& w) { w.friction = -0.1; }), HasSubstr("friction"));
  EXPECT_THAT(with([](auto& w) { w.direction_W.setZero(); }), HasSubstr("direction"));
  EXPECT_THAT(with(
                [](auto& w)
                {
                  w.shape.tip = WireTip::Hook;
                  w.shape.tip_u = 70.0;
                }),
    HasSubstr("tip"));
  EXPECT_THAT(faultOf(nitinolWire(60.0, 20, 0.1), TriangleMesh{}), HasSubstr("vessel"));
  const PlannedWire open = planWire(nitinolWire(60.0, 20, 0.1), tube, 1);
  ASSERT_NE(open.plan, nullptr);
  EXPECT_THAT(open.check.remarks.front(), HasSubstr("the vessel is open"));
  EXPECT_NEAR(open.check.clearance_u, std::cos(std::numbers::pi / 32.0) - 0.25, 1e-3);
}

} // namespace
} // namespace palpate::test
