// SPDX-License-Identifier: GPL-3.0-or-later
// Along the shaft, docs/theory.md, "Constraints between bodies": punctured, pushed in, turned round, pulled out.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

constexpr double punctureAt = 1.5, friction = 0.4, stroke = 0.02, rod = 0.1;
constexpr double series = 1.0 / kc + 1.0 / tissue;

class Needle : public testing::Test
{
protected:
  Needle()
  {
    this->rig.grip = { kc, 0.5 };
    this->rig.addSoft("tissue", springWall("tissue", Vec3(0.0, 0.0, rod), -Vec3::UnitZ(), 0.02, 1.0 / tissue));
    MechanismConstraint& law = this->rig.join(ConstraintKind::Puncture, "tissue", Vec3::Zero(), Vec3::Zero());
    law.strength_N = punctureAt;
    law.dryFriction_N = friction;
    (void)this->rig.step(Vec3(0.0, 0.0, -1e-3));
  }

  const MechanismResult& at(double x) { return this->rig.step(Vec3(0.0, 0.0, x)); }

  MechanismRig rig{ rod };
};

TEST_F(Needle, AStrokeIsPuncturedTurnsRoundAndTakesTheWorkOfTheLaw)
{
  constexpr int steps = 20000;
  const double step = stroke / steps;
  double work = 0.0, before = 0.0, punctured = -1.0, held = 0.0, reversal = -1.0, last = 0.0;
  for (int i = 0; i <= 2 * steps; ++i)
  {
    const double x = i <= steps ? i * step : (2 * steps - i) * step;
    const MechanismResult& r = this->at(x);
    EXPECT_LE(r.residual_u, 1e-15);
    const double force = -r.exact_W.force.z();
    work += 0.5 * (before + force) * (x - last);
    if (r.eventCount > 0 && r.events[0].change == ConstraintChange::Punctured)
    {
      punctured = x;
      work += 0.5 * (punctureAt + force - before - force) * (x - last); // up to the puncture it rose
      EXPECT_NEAR(r.events[0].force_N, punctureAt, 1e-3 * punctureAt);
      EXPECT_NEAR(force, friction, 1e-12);
    }
    held = punctured >= 0.0 && i <= steps ? std::max(held, std::abs(force - friction)) : held;
    if (reversal < 0.0 && i > steps && force <= -friction + 1e-12)
    {
      reversal = stroke - x;
    }
    before = force;
    last = x;
  }
  EXPECT_NEAR(punctured, punctureAt * series, 1e-3 * punctureAt * series);
  EXPECT_LE(held, 1e-12);
  EXPECT_NEAR(reversal, 2.0 * friction * series, 1e-3 * 2.0 * friction * series);
  const double c = series;
  const double formula =
    punctureAt * punctureAt * c / 2.0 + friction * (stroke - punctureAt * c) + friction * (stroke - 2.0 * friction * c);
  EXPECT_NEAR(formula, 16.615e-3, 1e-6);
  EXPECT_NEAR(work, formula, 1e-3 * formula);
}

TEST_F(Needle, NoMoreOfTheRodGoesInThanThereIs)
{
  const double through = rod + 0.01; // of the tip beyond the surface
  double x = 0.0;
  for (; x < through; x += 1e-4)
  {
    (void)this->at(x);
  }
  const MechanismResult& r = this->at(through);
  EXPECT_EQ(r.laws[0].phase, ConstraintPhase::Inside);
  EXPECT_NEAR(r.laws[0].inside_u, rod, 1e-12);
  // The hand is beyond by the yield of its spring and the wall's under the force.
  EXPECT_NEAR(-r.exact_W.force.z(), (through - rod) / series, 1e-9);
  (void)this->at(rod - 0.01);
  EXPECT_NEAR(this->at(rod - 0.02).exact_W.force.z(), friction, 1e-12) << "and the hub lets go";
}

TEST_F(Needle, TheForceStepOfThePunctureIsSpreadForTheHand)
{
  double before = 0.0;
  for (double x = 0.0; x < 0.008; x += 1e-5)
  {
    const double force = -this->at(x).wrench_W.force.z();
    EXPECT_LE(std::abs(force - before), ToolBlend::largestStep_N + 0.05) << x;
    before = force;
  }
  EXPECT_NEAR(before, friction, 0.01);
}

TEST_F(Needle, PulledOutItLeavesItsHoleAndTheNextEntryIsPuncturedAnew)
{
  for (double x = 0.0; x < 0.01; x += 1e-4)
  {
    (void)this->at(x);
  }
  EXPECT_EQ(this->at(0.01).laws[0].phase, ConstraintPhase::Inside);
  EXPECT_NEAR(this->at(0.01).laws[0].inside_u, 0.01 - friction * series, 1e-9);
  int withdrawn = 0;
  double most = 0.0;
  for (double x = 0.01; x > -0.005; x -= 1e-4)
  {
    const MechanismResult& r = this->at(x);
    most = std::max(most, r.exact_W.force.z());
    withdrawn += r.eventCount > 0 && r.events[0].change == ConstraintChange::Withdrawn;
  }
  EXPECT_NEAR(most, friction, 1e-12); // it is held back
  EXPECT_EQ(withdrawn, 1);
  EXPECT_EQ(this->at(-0.005).exact_W.force.norm(), 0.0);
  int punctured = 0;
  double strongest = 0.0;
  for (double x = -0.005; x < 0.008; x += 1e-4)
  {
    const MechanismResult& r = this->at(x);
    punctured += r.eventCount;
    strongest = r.eventCount > 0 ? r.events[0].force_N : strongest;
  }
  EXPECT_EQ(punctured, 1);
  EXPECT_GT(strongest, punctureAt);
}

TEST_F(Needle, TheTipFollowsTheSurfaceThatItIsPressedOnto)
{
  for (double x = 0.0; x < 0.001; x += 1e-4)
  {
    (void)this->at(x);
  }
  for (double y = 0.0; y < 0.008; y += 1e-4)
  {
    const MechanismResult& r = this->rig.step(Vec3(0.0, y, 1e-3));
    EXPECT_NEAR(r.wrench_W.force.z(), -1e-3 / series, 1e-12) << y;
    EXPECT_NEAR(r.wrench_W.force.y(), 0.0, 1e-12) << y;
    ASSERT_EQ(r.pressCount, 1);
    EXPECT_NEAR(r.presses[0].at.x_W.y(), y, 1.1e-4) << y; // of the tick before
  }
}

TEST_F(Needle, PulledSidewaysItTearsOutAtWhatTheHoleHolds)
{
  const double tear_N = 0.5, step = 1e-4;
  this->rig.mechanism.laws[0].tear_N = tear_N;
  this->rig.plan();
  for (double x = -1e-3; x < 0.01; x += 1e-4)
  {
    (void)this->at(x);
  }
  double across_N = 0.0;
  bool torn = false;
  for (double y = 0.0; y < 0.03 && !torn; y += step)
  {
    const MechanismResult r = this->rig.step(Vec3(0.0, y, 0.01));
    torn = r.eventCount > 0;
    if (!torn)
    {
      const Vec3 shaft = r.pose_W[0].q * Vec3::UnitZ();
      across_N = (r.laws[0].force_W - shaft.dot(r.laws[0].force_W) * shaft).norm();
      EXPECT_LE(across_N, tear_N);
      EXPECT_LE(std::abs(shaft.dot(r.laws[0].force_W)), friction + 1e-12);
      continue;
    }
    EXPECT_EQ(r.events[0].change, ConstraintChange::TornOut);
    EXPECT_GT(r.events[0].force_N, tear_N);
    EXPECT_LT(r.events[0].force_N, std::hypot(tear_N + kc * step, friction)) << "and what it rubs at most";
    EXPECT_EQ(r.exact_W.force.norm(), 0.0);
  }
  EXPECT_TRUE(torn);
  EXPECT_GT(across_N, tear_N - kc * step) << "of a step of the hand";
}

TEST_F(Needle, AnotherPacketUnderTheSameForceIsAnOffsetThatFades)
{
  this->rig.mechanism.laws[0].strength_N = MechanismConstraint::unlimited;
  this->rig.plan();
  auto first = springWall("tissue", Vec3(0.0, 0.0, rod), -Vec3::UnitZ(), 0.02, 1.0 / tissue, 2);
  auto second = springWall("tissue", Vec3(0.0, 0.0, rod - 5e-4), -Vec3::UnitZ(), 0.02, 1.5 / tissue, 3);
  const_cast<PressedBody&>(*first).period_s = const_cast<PressedBody&>(*second).period_s = 0.04;
  this->rig.pressed[0] = first.get();
  (void)this->at(-1e-3);
  const double before = this->at(2e-3).exact_W.force.z();
  EXPECT_NEAR(before, -2e-3 / series, 1e-12);
  this->rig.pressed[0] = second.get();
  double last = before;
  for (int i = 0; i < 400; ++i)
  {
    const double now = this->at(2e-3).exact_W.force.z();
    EXPECT_LE(std::abs(now - last), 0.06);
    last = now;
  }
  EXPECT_NEAR(last, -2.5e-3 / (1.0 / kc + 1.5 / tissue), 1e-6);
}

/// A rod that a hand leads in and sideways.
Pose wayOf(int tick)
{
  return { Vec3(1e-3 * std::sin(0.01 * tick), 0.0, -0.005 + 4e-5 * tick), Quat::Identity() };
}

TEST(NeedleRecording, GoesOnBitForBitFromTheStateOfAnyTick)
{
  MechanismRig whole(rod);
  MechanismRig part(rod);
  for (MechanismRig* rig : { &whole, &part })
  {
    rig->addSoft("wall", springWall("wall", Vec3(0.0, 0.0, rod), -Vec3::UnitZ(), 0.05, 1.0 / 800.0));
    MechanismConstraint& law = rig->join(ConstraintKind::Puncture, "wall", Vec3::Zero(), Vec3::Zero());
    law.strength_N = 1.5;
    law.dryFriction_N = 0.4;
    rig->plan();
  }
  constexpr int from = 260, ticks = 600;
  for (int tick = 0; tick < ticks; ++tick)
  {
    if (tick == from)
    {
      part.tick.restore(whole.tick.state());
    }
    const Vec3 all = whole.step(wayOf(tick)).wrench_W.force;
    if (tick >= from)
    {
      EXPECT_EQ(part.step(wayOf(tick)).wrench_W.force, all) << tick;
    }
  }
}

} // namespace
} // namespace palpate::test
