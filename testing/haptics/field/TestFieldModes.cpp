// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/Extrema.h"
#include "testing/haptics/field/FieldHand.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

TEST(FieldModes, DragIsAForceOfItsStrengthAgainstTheMotionWhateverItsSpeed)
{
  const FieldBlock brick = brickOf({ scalar(height) });
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
  const FieldBlock brick =
    brickOf({ scalar([](const Vec3& i) { return 2.0 * (i.x() - 15.0) / 16.0; }, FieldBlockRole::Resistance) });
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
  const FieldBlock brick = brickOf(
    { scalar(height), scalar([](const Vec3& i) { return i.z() + (i.x() > 20 ? 0.5 : 0.0); }, FieldBlockRole::Other) });
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
  const FieldBlock brick = brickOf({ scalar(height) }, { { 10, 10, 10 }, { 20, 10, 10 } });
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
  // A path of another shape between the same places takes as much work: the potential is the same at both.
  EXPECT_NEAR(hand.work, 0.0, 1e-6);
}

TEST(FieldModes, SnapPullsAcrossALineAndLetsTheHandSlideAlongIt)
{
  const FieldBlock brick = brickOf({ scalar(height) }, {}, { { Vec3(5, 10, 10), Vec3(25, 10, 10) } });
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
  const FieldBlock brick = brickOf({ { FieldBlockRole::Vector, "v", sampledVectors(cube_n, vortex) } });
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
  Random random(testSeed(1651));
  const auto swirl = [](const Vec3& i) { return Vec3(15.5 - i.y(), i.x() - 15.5, 3.0); };
  const FieldBlock brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }),
    { FieldBlockRole::Vector, "v", sampledVectors(cube_n, swirl) },
    scalar([](const Vec3& i) { return i.z(); }, FieldBlockRole::Other) });
  for (std::size_t way = 0; way < testCount(12); ++way)
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
    return FieldBlock(1, { cube_n, Vec3::Ones(), { corner } },
      { { FieldBlockRole::Scalar, "f",
        sampledValues(cube_n,
          [&](const Vec3& i) { return std::hypot(i.z() + corner.z(), 0.25 * (i.x() + corner.x())) + shift; }) } });
  };
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = 16.3;
  const FieldBlock first = make({ 0, 0, 0 }, 0.0), beside = make({ 3, -2, 1 }, 0.0), moved = make({ 3, -2, 1 }, -1.0);
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
  Random random(testSeed(1652));
  const FieldBlock brick = brickOf({ scalar([](const Vec3& i) { return (i - middle).norm(); }),
    { FieldBlockRole::Vector, "v", sampledVectors(cube_n, [](const Vec3& i) { return i; }) } });
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = 8.0;
  plan.follow_N = plan.drag_N = plan.push_N = 0.2;
  plan.detent = { 0.2, 0.0, 1.0, 1.0, true };
  FieldState state;
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i)
  {
    (void)moveFieldProxy(brick, plan, k, middle + random.inCube(20.0), state);
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

} // namespace
} // namespace palpate::test
