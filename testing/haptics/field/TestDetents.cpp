// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/haptics/field/FieldHand.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

TEST(Detents, ASmoothDetentHasItsStrengthWhereTheSlopeIsTheUsualOneAndTakesNoWorkBack)
{
  const FieldBlock brick = brickOf({ scalar(height) });
  FieldPlan plan;
  // 32 A / D^2 = 32 s / (3.0792 D) is the largest bend: below 0.9 k the proxy never snaps.
  plan.detent = { 0.15, 0.0, 2.0, 1.0, false };
  Hand hand{ brick, plan };
  hand.start({ 15, 15, 10.0 });
  EXPECT_NEAR(hand.force.norm(), 0.0, 1e-12) << "a level is a hollow";
  double strongest = 0.0;
  const int steps = 4000;
  for (int i = 1; i <= 2 * steps; ++i)
  {
    hand.to({ 15, 15, 10.0 + 5.0 * (i <= steps ? i : 2 * steps - i) / steps });
    strongest = std::max(strongest, hand.force.norm());
  }
  EXPECT_NEAR(hand.work, 0.0, 1e-12);
  EXPECT_NEAR(strongest, 0.15, 1e-5);
}

TEST(Detents, ASmoothDetentDependsOnThePlaceAloneAlsoWhereTheFieldBends)
{
  const FieldBlock brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }) });
  FieldPlan plan;
  plan.detent = { 0.15, 0.0, 2.0, 1.0, false };
  Random random(testSeed(1650));
  Hand one{ brick, plan }, other{ brick, plan };
  one.start(middle + Vec3(6, 0, 0));
  other.start(middle + Vec3(0, -6, 0));
  const Vec3 meeting = middle + Vec3(5, 5, 1);
  for (int i = 1; i <= 2000; ++i)
  {
    one.to(middle + Vec3(6, 0, 0) + (meeting - middle - Vec3(6, 0, 0)) * i / 2000);
    other.to(middle + Vec3(0, -6, 0) + (meeting - middle - Vec3(0, -6, 0)) * i / 2000);
  }
  EXPECT_GT(one.force.norm(), 0.01);
  EXPECT_LT((one.force - other.force).norm(), 1e-10);
}

TEST(Detents, ClicksLoseTheEnergyOfTheSpringAtEachLevelThatLetsGoOnBentLevelsToo)
{
  const FieldBlock brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }) });
  for (const double strength_N : { 0.2, 0.5 })
  {
    FieldPlan plan;
    plan.detent = { strength_N, 0.0, 3.0, 1.0, true };
    Hand hand{ brick, plan };
    const Vec3 n = Vec3(1.0, 0.3, 0.2).normalized();
    const auto at = [&](double r) { return Vec3(middle + r * n); };
    hand.start(at(5.0));
    hand.work = 0.0;
    // Past the levels of 6, 9 and 12 by more than they stretch the spring, and back past 12, 9 and 6.
    const int steps = 40000;
    for (int i = 0; i <= 2 * steps; ++i)
    {
      hand.to(at(i <= steps ? 5.0 + 8.0 * i / steps : 13.0 - 8.0 * (i - steps) / steps));
    }
    EXPECT_NEAR(
      -hand.work, 6.0 * strength_N * strength_N / (2.0 * k), 0.01 * 6.0 * strength_N * strength_N / (2.0 * k));
  }
}

TEST(Detents, AClickThatIsPressedAndLeftAgainLosesNothingSoCrossingsAloneDoNotCountTheLoss)
{
  const FieldBlock brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }) });
  for (const double strength_N : { 0.2, 0.5 })
  {
    FieldPlan plan;
    plan.detent = { strength_N, 0.0, 1.5, 1.0, true };
    Hand hand{ brick, plan };
    const Vec3 n = Vec3(1.0, 0.3, 0.2).normalized();
    // From 5 over the levels of 6, 7.5, 9 and 10.5 to beyond that of 12, but by less than stretches the spring to its
    // strength, and back: ten crossings, of which eight let go. By crossings it would be a fifth more.
    const double end = 12.0 + 0.5 * strength_N / k;
    hand.start(middle + 5.0 * n);
    const int steps = 40000;
    for (int i = 0; i <= 2 * steps; ++i)
    {
      const double share = static_cast<double>(i <= steps ? i : 2 * steps - i) / steps;
      hand.to(middle + (5.0 + (end - 5.0) * share) * n);
    }
    const double each_mJ = strength_N * strength_N / (2.0 * k);
    EXPECT_NEAR(-hand.work, 8.0 * each_mJ, 0.01 * 8.0 * each_mJ);
  }
}

TEST(Detents, AClickAtAnySpeedTakesTheEnergyOfItsSpringAndItsStrengthOverTheWayOfOneTickByAnySumOfForces)
{
  // The pull rises with the hand from 0 to the strength s. The pull is sampled once a tick, and the tick in which the
  // hand passes has s as well. Over all phases of a level among the ticks, the sum of the rising part is its integral
  // s^2 / 2k, whichever end of a tick the force is taken from, and s times the displacement of a tick is added.
  const FieldBlock brick = brickOf({ scalar(height) });
  for (const double strength_N : { 0.2, 0.5 })
  {
    for (const double way : { 0.01, 0.05, 0.3 }) // in a tick: 10 to 300 mm/s
    {
      FieldPlan plan;
      plan.detent = { strength_N, 0.0, std::numbers::sqrt2, 1.0, true }; // phases do not repeat
      FieldState state;
      double atBegin = 0.0, atEnd = 0.0, last_N = 0.0;
      constexpr int strokes = 200;
      constexpr double from = 4.5, length = 21.9; // to .9 beyond the last level: it lets go there
      const int steps = static_cast<int>(std::lround(length / way));
      for (int i = 0; i <= 2 * strokes * steps; ++i)
      {
        const int at = i % (2 * steps);
        const double z = from + 1e-3 * (i / (2 * steps)) + way * std::min(at, 2 * steps - at);
        const double moved = at == 0 ? 0.0 : at <= steps ? way : -way;
        const double force_N = k * moveFieldProxy(brick, plan, k, { 15, 15, z }, state).pull_W.z();
        atBegin -= last_N * moved;
        atEnd -= force_N * moved;
        last_N = force_N;
      }
      const double levels = std::floor((from + length) / std::numbers::sqrt2) - std::floor(from / std::numbers::sqrt2);
      const double truth = 2.0 * strokes * levels * (strength_N * strength_N / (2.0 * k) + strength_N * way);
      EXPECT_NEAR(atBegin, truth, 0.03 * truth) << way;
      EXPECT_NEAR(atEnd, truth, 0.03 * truth) << way;
    }
  }
}

TEST(Detents, TheEnergyOfADetentHasTheDerivativesItSays)
{
  const DetentPlan plan{ 0.7, 0.3, 1.7, 2.0, false };
  for (double f = -3.0; f < 3.0; f += 0.0137)
  {
    const double d = 1e-5;
    const DetentEnergy low = detentEnergy(plan, f - d), at = detentEnergy(plan, f), high = detentEnergy(plan, f + d);
    EXPECT_NEAR(at.slope, (high.energy - low.energy) / (2.0 * d), 1e-8);
    EXPECT_NEAR(at.bend, (high.slope - low.slope) / (2.0 * d), 2e-4) << f;
    EXPECT_GE(at.energy, -1e-15);
  }
}

TEST(Detents, AClickLosesTheSquareOfItsStrengthOverTwiceTheStiffnessACrossing)
{
  const FieldBlock brick = brickOf({ scalar(height) });
  for (const double direction : { 1.0, -1.0 })
  {
    FieldPlan plan;
    plan.detent = { 0.5, 0.25, 2.0, 1.0, true };
    Hand hand{ brick, plan };
    const double from = direction > 0.0 ? 9.1 : 21.9;
    hand.start({ 15, 15, from });
    double strongest = 0.0;
    for (int i = 1; i <= 128000; ++i) // 12.8 mm: levels at 10.25, 12.25 .. 20.25
    {
      hand.to({ 15, 15, from + direction * 1e-4 * i });
      strongest = std::max(strongest, hand.force.norm());
    }
    EXPECT_EQ(hand.force.norm(), 0.0);
    EXPECT_NEAR(hand.work, -6.0 * 0.5 * 0.5 / (2.0 * k), 1e-3 * 6.0 * 0.125);
    EXPECT_NEAR(strongest, 0.5, 1e-12);
  }
}

/// Levels at 12, 15 and 20; hollows 2 wide.
DetentPlan chosenLevels(double strength_N, bool click)
{
  DetentPlan plan{ strength_N, 0.0, 2.0, 1.0, click };
  EXPECT_EQ(setLevels(plan, "15, 20;12"), "");
  return plan;
}

TEST(Detents, ChosenLevelsAreHollowsAndBetweenThemIsNoForce)
{
  const DetentPlan plan = chosenLevels(0.15, false), equal{ 0.15, 12.0, 2.0, 1.0, false };
  for (double f = 9.0; f < 23.0; f += 0.0137)
  {
    const double away = std::min({ std::fabs(f - 12.0), std::fabs(f - 15.0), std::fabs(f - 20.0) });
    const DetentEnergy at = detentEnergy(plan, f), truth = detentEnergy(equal, 12.0 + away);
    EXPECT_NEAR(std::fabs(at.slope), away < 1.0 ? std::fabs(truth.slope) : 0.0, 1e-12) << f;
    EXPECT_NEAR(at.energy, away < 1.0 ? truth.energy : detentEnergy(equal, 13.0).energy, 1e-12) << f;
  }
  const FieldBlock brick = brickOf({ scalar(height) });
  FieldPlan felt;
  felt.detent = plan;
  Hand hand{ brick, felt };
  hand.start({ 15, 15, 10.0 });
  double strongest = 0.0;
  for (int i = 1; i <= 4000; ++i)
  {
    hand.to({ 15, 15, 10.0 + 12.0 * i / 4000 });
    strongest = std::max(strongest, hand.force.norm());
  }
  // The trapezoid is wrong by h^2 / 12 of each jump of the force's slope: at the edge of a hollow of bend e it jumps by
  // k e / (k + e), twice a hollow.
  const double bend = detentEnergy(plan, 13.0 - 1e-9).bend, h = 12.0 / 4000;
  EXPECT_NEAR(hand.work, 0.0, 6.0 * h * h / 12.0 * -k * bend / (k + bend)) << "from a top between hollows to another";
  EXPECT_NEAR(strongest, 0.15, 1e-5);
}

TEST(Detents, AClickAtChosenLevelsHoldsAtEachAndNowhereElse)
{
  const FieldBlock brick = brickOf({ scalar(height) });
  for (const double direction : { 1.0, -1.0 })
  {
    FieldPlan plan;
    plan.detent = chosenLevels(0.5, true);
    Hand hand{ brick, plan };
    const double from = direction > 0.0 ? 9.10005 : 24.90005; // never on a level
    hand.start({ 15, 15, from });
    for (int i = 1; i <= 158000; ++i)
    {
      const double z = from + direction * 1e-4 * i;
      hand.to({ 15, 15, z });
      double held = 0.0; // by the level that the hand is beyond, up to its strength
      for (const double level : { 12.0, 15.0, 20.0 })
      {
        const double beyond = direction * (z - level);
        held = beyond > 0.0 && beyond < 0.5 - 1e-3 ? k * beyond : held;
      }
      if (held > 0.0)
      {
        ASSERT_NEAR(hand.force.z(), -direction * held, 1e-9) << z;
      }
    }
    EXPECT_NEAR(hand.work, -3.0 * 0.5 * 0.5 / (2.0 * k), 1e-3) << "three crossings";
  }
}

} // namespace
} // namespace palpate::test
