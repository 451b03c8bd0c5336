// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/Extrema.h"
#include "haptics/field/FieldProxy.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double k = 1.0; ///< [N/u]; with a spacing of a millimetre work is in mJ
const GridIndex cube_n{ 32, 32, 32 };
const Vec3 middle(15.5, 15.5, 15.5);

Brick brickOf(std::vector<BrickArray> arrays, std::vector<Vec3> places_W = {}, std::vector<BrickLine> lines_W = {})
{
  return Brick(1, BrickGrid{ cube_n }, std::move(arrays), std::move(places_W), std::move(lines_W));
}

template<class Function>
BrickArray scalar(const Function& function, BrickRole role = BrickRole::Scalar)
{
  return { role, "f", test::sampledValues(cube_n, function) };
}

const auto height = [](const Vec3& i) { return i.z(); };

/// A hand that moves and the work that the field does on it, by the trapezoid of both ends of each step.
struct Hand
{
  const Brick& brick;
  FieldPlan plan;
  FieldState state = {};
  Vec3 p = middle, force = Vec3::Zero();
  double work = 0.0;
  FieldResult last = {};

  void to(const Vec3& next)
  {
    this->last = moveFieldProxy(this->brick, this->plan, k, next, this->state);
    const Vec3 now = k * this->last.pull_W + this->last.push_W;
    this->work += 0.5 * (this->force + now).dot(next - this->p);
    this->force = now;
    this->p = next;
  }
  void start(const Vec3& at)
  {
    this->p = at;
    this->to(at);
    this->work = 0.0;
  }
};

TEST(FieldModes, ASmoothDetentHasItsStrengthWhereTheSlopeIsTheUsualOneAndTakesNoWorkBack)
{
  const Brick brick = brickOf({ scalar(height) });
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

TEST(FieldModes, ASmoothDetentDependsOnThePlaceAloneAlsoWhereTheFieldBends)
{
  const Brick brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }) });
  FieldPlan plan;
  plan.detent = { 0.15, 0.0, 2.0, 1.0, false };
  test::Random random(test::testSeed(1650));
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

TEST(FieldModes, SmoothLevelsTakeNoWorkOverClosedWaysWhateverStrengthIsAskedOfThemAlsoWhereTheyBend)
{
  const auto ball = [](const Vec3& i) { return (i - middle).norm(); };
  const auto waves = [](const Vec3& i) { return i.x() + 1.5 * std::sin(0.35 * i.y()) * std::cos(0.3 * i.z()); };
  for (const std::function<double(const Vec3&)>& function :
    { std::function<double(const Vec3&)>(ball), std::function<double(const Vec3&)>(waves) })
  {
    for (const double strength_N : { 0.1, 0.3, 1.0, 5.0 })
    {
      const Brick brick = brickOf({ scalar(function) });
      FieldPlan plan;
      plan.detent = { strength_N, 0.0, 3.0, 1.0, false };
      Hand hand{ brick, plan };
      const auto at = [](double turn)
      { return Vec3(middle + Vec3(9.5 + 4.0 * std::cos(turn), 2.0 * std::sin(turn), 1.5 * std::sin(2.0 * turn))); };
      hand.start(at(0.0));
      const int steps = 8000;
      double largest_N = 0.0;
      Vec3 before = Vec3::Zero();
      for (int i = 0; i <= 2 * steps; ++i)
      {
        const double turn = 2.0 * std::numbers::pi * i / steps;
        hand.to(at(turn));
        if (i > steps)
        {
          EXPECT_LT((hand.force - before).norm(), 0.02) << "no jump at a turn of " << turn;
        }
        before = hand.force;
        largest_N = std::max(largest_N, hand.force.norm());
        hand.work = i == steps ? 0.0 : hand.work;
      }
      EXPECT_LT(std::fabs(hand.work), 1e-4) << strength_N;
      const double most_N = mostSmooth_N(plan.detent, k, brick.steepest_per_u());
      EXPECT_GT(largest_N, 0.5 * std::min(strength_N, most_N)) << "they are felt";
      EXPECT_GT(most_N, 0.1) << "and may be strong";
    }
  }
}

TEST(FieldModes, ClicksLoseTheEnergyOfTheSpringAtEachLevelThatLetsGoOnBentLevelsToo)
{
  const Brick brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }) });
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

TEST(FieldModes, TheEnergyOfADetentHasTheDerivativesItSays)
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

TEST(FieldModes, AClickLosesTheSquareOfItsStrengthOverTwiceTheStiffnessACrossing)
{
  const Brick brick = brickOf({ scalar(height) });
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

TEST(FieldModes, ChosenLevelsAreHollowsAndBetweenThemIsNoForce)
{
  const DetentPlan plan = chosenLevels(0.15, false), equal{ 0.15, 12.0, 2.0, 1.0, false };
  for (double f = 9.0; f < 23.0; f += 0.0137)
  {
    const double away = std::min({ std::fabs(f - 12.0), std::fabs(f - 15.0), std::fabs(f - 20.0) });
    const DetentEnergy at = detentEnergy(plan, f), truth = detentEnergy(equal, 12.0 + away);
    EXPECT_NEAR(std::fabs(at.slope), away < 1.0 ? std::fabs(truth.slope) : 0.0, 1e-12) << f;
    EXPECT_NEAR(at.energy, away < 1.0 ? truth.energy : detentEnergy(equal, 13.0).energy, 1e-12) << f;
  }
  const Brick brick = brickOf({ scalar(height) });
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

TEST(FieldModes, AClickAtChosenLevelsHoldsAtEachAndNowhereElse)
{
  const Brick brick = brickOf({ scalar(height) });
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

TEST(FieldModes, DragIsAForceOfItsStrengthAgainstTheMotionWhateverItsSpeed)
{
  const Brick brick = brickOf({ scalar(height) });
  FieldPlan plan;
  plan.drag_N = 0.3;
  Hand hand{ brick, plan };
  hand.start(middle);
  double path = 0.0;
  for (int i = 1; i <= 3000; ++i)
  {
    const double turn = 0.01 * i;
    const Vec3 next = middle + Vec3(8.0 * std::sin(turn), 6.0 * std::sin(1.3 * turn), 5.0 * std::sin(0.7 * turn));
    path += (next - hand.p).norm();
    hand.to(next);
    EXPECT_LE(hand.force.norm(), 0.3 + 1e-12);
  }
  EXPECT_LT(hand.work, -0.5 * 0.3 * path) << "it takes";
  EXPECT_GE(hand.work, -0.3 * path);
}

TEST(FieldModes, DragIsAsStrongAsTheResistanceAtTheHandSays)
{
  const Brick brick =
    brickOf({ scalar([](const Vec3& i) { return 2.0 * (i.x() - 15.0) / 16.0; }, BrickRole::Resistance) });
  FieldPlan plan;
  plan.drag_N = 0.4;
  Hand hand{ brick, plan };
  for (const double x : { 12.0, 19.0, 30.0 })
  {
    hand.start({ x, 10, 10 });
    for (int i = 0; i <= 100; ++i)
    {
      hand.to({ x, 10 + 0.1 * i, 10 });
    }
    EXPECT_NEAR(hand.force.norm(), 0.4 * std::clamp((x - 15.0) / 8.0, 0.0, 1.0), 1e-7);
  }
  // Turned round, less resists more.
  hand.plan.dragNone = 1.0;
  hand.plan.dragFull = 0.0;
  hand.start({ 17.0, 10, 10 });
  for (int i = 0; i <= 100; ++i)
  {
    hand.to({ 17.0, 10 + 0.1 * i, 10 });
  }
  EXPECT_NEAR(hand.force.norm(), 0.4 * 0.75, 1e-7);
}

TEST(FieldModes, CompareDragsWhereTwoScalarsDifferAndOnlyThere)
{
  const Brick brick = brickOf(
    { scalar(height), scalar([](const Vec3& i) { return i.z() + (i.x() > 20 ? 0.5 : 0.0); }, BrickRole::Other) });
  FieldPlan plan;
  plan.compare_N = 0.4;
  plan.compareFull = 1.0;
  Hand hand{ brick, plan };
  for (const double x : { 10.0, 25.0 })
  {
    hand.start({ x, 10, 10 });
    for (int i = 0; i <= 100; ++i)
    {
      hand.to({ x, 10 + 0.1 * i, 10 });
    }
    EXPECT_NEAR(hand.force.norm(), x > 20.0 ? 0.5 * 0.4 : 0.0, 1e-12);
  }
}

TEST(FieldModes, SnapPullsToTheNearestPlaceByAForceWithAPotential)
{
  const Brick brick = brickOf({ scalar(height) }, { { 10, 10, 10 }, { 20, 10, 10 } });
  FieldPlan plan;
  plan.snap_N = 0.5;
  plan.snapReach_u = 4.0;
  Hand hand{ brick, plan };
  hand.start({ 10, 10, 10 });
  const int steps = 4000;
  for (int i = 1; i <= steps; ++i)
  {
    const double away = 10.0 * i / steps;
    hand.to({ 10 + away, 10, 10 });
    const double left = std::min(away, 10.0 - away);
    const double truth = left < 4.0 ? std::min(k * left, 0.5 * (1.0 - left / 4.0)) : 0.0;
    EXPECT_NEAR(hand.force.norm(), truth, 1e-12);
    EXPECT_LE(hand.force.x() * (5.0 - away), 0.0) << "towards the nearer one";
  }
  // A way of another shape between the same places takes as much work: the potential is the same at both.
  EXPECT_NEAR(hand.work, 0.0, 1e-6);
}

TEST(FieldModes, SnapPullsAcrossALineAndLetsTheHandSlideAlongIt)
{
  const Brick brick = brickOf({ scalar(height) }, {}, { { Vec3(5, 10, 10), Vec3(25, 10, 10) } });
  FieldPlan plan;
  plan.snap_N = 0.5;
  plan.snapReach_u = 4.0;
  Hand hand{ brick, plan };
  hand.start({ 6, 11, 10 });
  const double held = std::min(k * 1.0, 0.5 * (1.0 - 1.0 / 4.0));
  for (int i = 1; i <= 1000; ++i)
  {
    hand.to({ 6 + 18.0 * i / 1000, 11, 10 });
    EXPECT_LT((hand.force - Vec3(0, -held, 0)).norm(), 1e-9);
  }
  hand.to({ 28, 10, 10 });
  EXPECT_LT((hand.force - Vec3(-0.5 * (1.0 - 3.0 / 4.0), 0, 0)).norm(), 1e-9) << "beyond its end it is a point";
}

TEST(FieldModes, PushDoesTwoPiTimesRadiusTimesStrengthATurnAndStopsOutside)
{
  const auto vortex = [](const Vec3& i) { return Vec3(15.5 - i.y(), i.x() - 15.5, 0.0); };
  const Brick brick = brickOf({ { BrickRole::Vector, "v", test::sampledVectors(cube_n, vortex) } });
  FieldPlan plan;
  plan.push_N = 0.25;
  Hand hand{ brick, plan };
  const auto at = [](double turn) { return Vec3(15.5 + 8.0 * std::cos(turn), 15.5 + 8.0 * std::sin(turn), 15); };
  hand.start(at(0.0));
  const int steps = 10000;
  for (int i = 1; i <= steps; ++i)
  {
    hand.to(at(2.0 * std::numbers::pi * i / steps));
  }
  EXPECT_NEAR(hand.work, 2.0 * std::numbers::pi * 8.0 * 0.25, 1e-5);
  hand.to({ 40, 40, 40 });
  EXPECT_EQ(hand.force, Vec3(Vec3::Zero()));
}

TEST(FieldModes, SeveralAtOnceGiveNoEnergyOverClosedWays)
{
  test::Random random(test::testSeed(1651));
  const auto swirl = [](const Vec3& i) { return Vec3(15.5 - i.y(), i.x() - 15.5, 3.0); };
  const Brick brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }),
    { BrickRole::Vector, "v", test::sampledVectors(cube_n, swirl) },
    scalar([](const Vec3& i) { return i.z(); }, BrickRole::Other) });
  for (std::size_t way = 0; way < test::testCount(12); ++way)
  {
    FieldPlan plan;
    plan.isosurface = way % 2 == 0;
    plan.isovalue = 9.0;
    plan.drag_N = way % 3 == 0 ? 0.1 : 0.0;
    plan.compare_N = way % 5 == 0 ? 0.1 : 0.0;
    plan.compareFull = 20.0;
    plan.follow_N = way % 4 != 1 ? 0.3 : 0.0;
    plan.detent = { way % 4 < 2 ? 0.1 : 0.0, 0.0, 2.0, 1.0, false };
    Hand hand{ brick, plan };
    const Vec3 phase = random.inCube(3.0), size_u = Vec3(7, 7, 7) + random.inCube(2.0);
    const auto at = [&](double turn)
    {
      return Vec3(middle + size_u.cwiseProduct(Vec3(std::sin(turn + phase.x()), std::sin(2.0 * turn + phase.y()),
                             std::cos(turn + phase.z()))));
    };
    hand.start(at(0.0));
    const int steps = 20000;
    double stored = 0.0;
    for (int i = 0; i <= 2 * steps; ++i)
    {
      hand.to(at(2.0 * std::numbers::pi * i / steps));
      if (i == steps)
      {
        hand.work = 0.0;
        stored = 0.5 * k * hand.last.stretch2_u2;
      }
    }
    EXPECT_LE(hand.work + 0.5 * k * hand.last.stretch2_u2 - stored, 1e-4) << way;
  }
}

TEST(FieldModes, AnotherBrickOfTheSamePointsIsNoStepAndOneWhoseSurfaceIsElsewhereIsALimitedOne)
{
  const auto make = [](const GridIndex& begin, double shift)
  {
    const Vec3 corner(begin[0], begin[1], begin[2]);
    return Brick(1, { cube_n, Vec3::Ones(), { corner } },
      { { BrickRole::Scalar, "f",
        test::sampledValues(cube_n,
          [&](const Vec3& i) { return std::hypot(i.z() + corner.z(), 0.25 * (i.x() + corner.x())) + shift; }) } });
  };
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = 16.3;
  const Brick first = make({ 0, 0, 0 }, 0.0), beside = make({ 3, -2, 1 }, 0.0), moved = make({ 3, -2, 1 }, -1.0);
  FieldState state;
  (void)moveFieldProxy(first, plan, k, { 15, 15, 20 }, state);
  const Vec3 p(15, 15, 14);
  (void)moveFieldProxy(first, plan, k, p, state);
  const Vec3 before = moveFieldProxy(first, plan, k, p, state).pull_W;
  ASSERT_GT(before.norm(), 1.0);
  EXPECT_LT((moveFieldProxy(beside, plan, k, p, state).pull_W - before).norm(), 1e-7);
  Vec3 last = moveFieldProxy(beside, plan, k, p, state).pull_W;
  int ticks = 0;
  for (double change = 1.0; change > 1e-9; ++ticks)
  {
    const Vec3 now = moveFieldProxy(moved, plan, k, p, state).pull_W;
    change = (now - last).norm();
    EXPECT_LE(change, 0.1);
    last = now;
    ASSERT_LT(ticks, 1000);
  }
  EXPECT_GT(last.norm(), before.norm() + 0.9) << "the surface has come nearer to where the value was 17.3";
  EXPECT_EQ(state.surface.side, 1.0);
}

TEST(FieldModes, FindsTheExtremaOfAGridByTheirClearness)
{
  const auto two = [](const Vec3& i)
  {
    return 2.0 * std::exp(-(i - Vec3(8, 9, 10)).squaredNorm() / 8.0) -
           std::exp(-(i - Vec3(22, 20, 21)).squaredNorm() / 8.0);
  };
  const std::vector<Extremum> found = findExtrema(brickOf({ scalar(two) }), 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].p_W, Vec3(8, 9, 10));
  EXPECT_TRUE(found[0].highest);
  EXPECT_EQ(found[1].p_W, Vec3(22, 20, 21));
  EXPECT_FALSE(found[1].highest);
  EXPECT_TRUE(findExtrema(brickOf({ scalar([](const Vec3&) { return 1.0; }) }), 9).empty()) << "constant";
}

TEST(FieldModes, AllocateNothing)
{
  test::Random random(test::testSeed(1652));
  const Brick brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }),
    { BrickRole::Vector, "v", test::sampledVectors(cube_n, [](const Vec3& i) { return i; }) } });
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = 8.0;
  plan.follow_N = plan.drag_N = plan.push_N = 0.2;
  plan.detent = { 0.2, 0.0, 1.0, 1.0, true };
  FieldState state;
  const test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i)
  {
    (void)moveFieldProxy(brick, plan, k, middle + random.inCube(20.0), state);
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

} // namespace
} // namespace palpate
