// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a soft body along a path, without a device.
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/session/path/PathTouch.h"

namespace palpate::test
{
namespace
{

constexpr double spring_N_per_m = 1000.0;
constexpr double pathTick_s = 1e-3;

std::unique_ptr<PathTouch> touchOf(
  const SoftBodyInput& input, double rate_Hz, double radius_u = 0.0, double friction = 0.0)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = spring_N_per_m;
  parameters.contact.radius_u = radius_u;
  parameters.contact.friction = { friction, friction };
  auto touch = std::make_unique<PathTouch>(nullptr, parameters, pathTick_s);
  std::string refusal;
  auto maker = BodyMaker::make(input, "block", 0, refusal);
  EXPECT_EQ(refusal, "");
  touch->press(std::move(maker), rate_Hz);
  return touch;
}

/// The hand comes down until the ball is `depth_m` deep, in so many ticks, and stays for as many.
HapticState pressed(const std::unique_ptr<PathTouch>& touch, double depth_m, int ticks, double radius_u = 0.0)
{
  HapticState state;
  for (int i = 0; i <= 2 * ticks; ++i)
  {
    const double down = 0.001 - (0.001 + depth_m) * std::min(1.0, i / static_cast<double>(ticks));
    state = touch->next(pathTick_s * i, { topOfBlock() + Vec3(0, 0, radius_u + down), Quat::Identity() });
  }
  return state;
}

TEST(SoftPath, AtRestABodyGivesTheForceOfItsYieldAndTheSpringInSeries)
{
  const auto touch = touchOf(softBlock(ElasticModel::Linear), 0.0);
  constexpr double depth_m = 0.004;
  const HapticState state = pressed(touch, depth_m, 10);
  const double force_N = depth_m / (1.0 / spring_N_per_m + yieldOfTop());
  // The surface yields sideways too, by a hundredth: the ball touches beside the vertex.
  EXPECT_NEAR(state.force_W.z(), force_N, 1e-3 * force_N);
  EXPECT_LE(state.force_W.head<2>().norm(), 1e-9 * force_N) << "the top is flat, and there is no friction";
  EXPECT_NEAR(state.soft.stored_J, 0.5 * force_N * depth_m, 1e-3 * force_N * depth_m) << "of a linear spring";
  EXPECT_EQ(state.contacts, 1);
  EXPECT_NEAR(state.proxy_W.p.z(), 0.05 - depth_m + state.force_W.z() / spring_N_per_m, 1e-9);
}

TEST(SoftPath, PacketsOfALinearBodyChangeNothingHoweverLateTheyAre)
{
  const auto rest = touchOf(softBlock(ElasticModel::Linear), 0.0);
  const double force_N = pressed(rest, 0.004, 10).force_W.z();
  for (const double rate_Hz : { 10.0, 30.0, 1000.0 })
  {
    const auto late = touchOf(softBlock(ElasticModel::Linear), rate_Hz);
    EXPECT_NEAR(pressed(late, 0.004, 300).force_W.z(), force_N, 1e-9) << rate_Hz;
  }
}

/// Fixed at one side only: pressed in its middle it bends, which a linear body does otherwise than one that turns.
SoftBodyInput shelf(ElasticModel model)
{
  SoftBodyInput input = softBlock(model);
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  return input;
}

TEST(SoftPath, ABodyThatBendsComesToTheForceOfRestOncePacketsHaveArrived)
{
  const SoftBodyInput input = shelf(ElasticModel::NeoHookean);
  constexpr double deep_m = 0.03, ball_m = 0.01;
  const auto rest = touchOf(input, 0.0, ball_m);
  const auto late = touchOf(input, 30.0, ball_m);
  const auto flat = touchOf(shelf(ElasticModel::Linear), 30.0, ball_m);
  const auto press = [](const auto& touch, int ticks) { return pressed(touch, deep_m, ticks, ball_m).force_W.z(); };
  const double force_N = press(rest, 4);
  EXPECT_NEAR(press(late, 400), force_N, 1e-3 * force_N);
  EXPECT_GT(std::abs(press(flat, 400) - force_N), 0.02 * force_N) << "else a linear body would pass";
}

/// So many pascals, however few: the least that is refused is of metres, and none of this reads the unit otherwise.
SoftBodyInput hardlyThere(ElasticModel model, double young_Pa)
{
  constexpr double allowed_Pa = 10.0;
  SoftBodyInput input = softBlock(model);
  input.young_Pa = { allowed_Pa };
  input.unit_m = std::sqrt(young_Pa / allowed_Pa);
  return input;
}

/// No less than a flat punch as wide as the ball meets: on a half space, and a column of the layer below it beside.
double mostOfLayer_N(double young_Pa, double depth_m, double radius_u)
{
  constexpr double nu = 0.4, layer_m = 0.05;
  const double plane_Pa = young_Pa / (1.0 - nu * nu);
  const double column_Pa = young_Pa * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return depth_m * (2.0 * plane_Pa * radius_u + column_Pa * M_PI * radius_u * radius_u / layer_m);
}

TEST(SoftPath, ABodyThatIsNextToNothingLetsTheBallDownToWhatIsHeldAndNoFurther)
{
  constexpr double ball_m = 0.01;
  for (const auto& [model, rate_Hz] : { std::pair(ElasticModel::Linear, 0.0), std::pair(ElasticModel::Linear, 30.0),
         std::pair(ElasticModel::NeoHookean, 30.0) })
  {
    for (const double young_Pa : { 0.02, 10.0 })
    {
      const auto touch = touchOf(hardlyThere(model, young_Pa), rate_Hz, ball_m);
      for (int i = 0; i <= 400; ++i)
      {
        // Down through the block, to 15 mm below where its fixed side stops the ball, and up again.
        const double deep_m = 0.065 - 0.066 * std::abs(1.0 - i / 200.0);
        const Vec3 hand = topOfBlock() + Vec3(0.001, -0.001, ball_m - deep_m);
        const Vec3 force_N = touch->next(pathTick_s * i, { hand, Quat::Identity() }).force_W;
        const double base_N = spring_N_per_m * std::max(deep_m - 0.05, 0.0);
        const double most_N = mostOfLayer_N(young_Pa, std::max(deep_m, 0.0), ball_m);
        ASSERT_GE(force_N.z(), base_N * (1.0 - 1e-9)) << young_Pa << " Pa, " << deep_m << " m";
        ASSERT_LE(force_N.z(), std::max(base_N * (1.0 + 1e-9), most_N)) << young_Pa << " Pa, " << deep_m << " m";
        ASSERT_LE(force_N.head<2>().norm(), 0.1 * most_N);
      }
    }
  }
}

TEST(SoftPath, WhatIsHeldDoesNotKeepABallThatLeavesTheBody)
{
  constexpr double ball_m = 0.01;
  const auto touch = touchOf(hardlyThere(ElasticModel::Linear, 10.0), 30.0, ball_m);
  (void)pressed(touch, 0.06, 100, ball_m);
  double last_N = 0.0;
  for (int i = 1; i <= 100; ++i)
  {
    const Vec3 hand = topOfBlock() + Vec3(0.001 * i, 0.0, ball_m - 0.06);
    last_N = touch->next(pathTick_s * (200 + i), { hand, Quat::Identity() }).force_W.norm();
    if (i < 45)
    {
      EXPECT_NEAR(last_N, spring_N_per_m * 0.01, 1e-9) << "along the held side";
    }
  }
  EXPECT_EQ(last_N, 0.0) << "beside it";
}

/// Over the bumps of bumpyBlock() at 50 mm/s and, if asked for, down to the fixed nodes below them.
Vec3 overBumps(int tick, double radius_u, double deep_m)
{
  const double down = std::min(1.0, tick / 100.0);
  return { 0.02 + 5e-5 * tick, 0.05 + 0.01 * std::sin(0.01 * tick), 0.054 + radius_u - down * (0.004 + deep_m) };
}

TEST(SoftPath, InEveryTickOverBumpsTheForceIsTheSpringsBetweenProxyAndHand)
{
  for (const double radius_u : { 0.0, 0.005 })
  {
    for (const double friction : { 0.0, 0.3 })
    {
      for (const auto& [model, rate_Hz, ticks] : { std::tuple(ElasticModel::Linear, 0.0, 200),
             std::tuple(ElasticModel::Linear, 30.0, 1000), std::tuple(ElasticModel::NeoHookean, 30.0, 1000) })
      {
        const auto touch = touchOf(bumpyBlock(model), rate_Hz, radius_u, friction);
        int pressed = 0;
        for (int i = 0; i < ticks; ++i)
        {
          const Vec3 hand = overBumps(i, radius_u, 0.006);
          const HapticState state = touch->next(pathTick_s * i, { hand, Quat::Identity() });
          const Vec3 spring_N = spring_N_per_m * (state.proxy_W.p - hand);
          EXPECT_LE(
            (state.force_W - spring_N).norm(), roundingOfSpring_N(spring_N_per_m, hand.norm(), state.force_W.norm()))
            << i;
          pressed += state.soft.pressed;
        }
        EXPECT_GT(pressed, ticks / 2);
      }
    }
  }
}

TEST(SoftPath, WhereHeldFacesStopTheBallTheForceIsTheSpringsToo)
{
  for (const double radius_u : { 0.0, 0.005 })
  {
    for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
    {
      SoftBodyInput input = bumpyBlock(model);
      input.young_Pa = { 10.0 };
      const auto touch = touchOf(input, 30.0, radius_u, 0.0);
      int stopped = 0;
      for (int i = 0; i < 600; ++i)
      {
        const Vec3 hand = overBumps(i, radius_u, 0.055);
        const HapticState state = touch->next(pathTick_s * i, { hand, Quat::Identity() });
        const Vec3 spring_N = spring_N_per_m * (state.proxy_W.p - hand);
        EXPECT_LE(
          (state.force_W - spring_N).norm(), roundingOfSpring_N(spring_N_per_m, hand.norm(), state.force_W.norm()))
          << i;
        stopped += state.proxy_W.p.z() < radius_u + 1e-9; // the fixed side is z = 0
      }
      EXPECT_GT(stopped, 400);
    }
  }
}

TEST(SoftPath, AWallBesideTheBodyIsFeltAsWithoutIt)
{
  const auto forceOn = [](bool withBody)
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = spring_N_per_m;
    Surface wall;
    wall.name = "wall";
    wall.tree = std::make_shared<const SurfaceTree>(
      TriangleMesh{ { Vec3(1, -1, 0), Vec3(3, -1, 0), Vec3(2, 1, 0) }, { { 0, 1, 2 } } });
    PathTouch touch(std::make_shared<const Scene>(1, std::vector<Surface>{ wall }), parameters, pathTick_s);
    std::string refusal;
    if (withBody)
    {
      touch.press(BodyMaker::make(softBlock(ElasticModel::NeoHookean), "block", 0, refusal), 30.0);
    }
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 100; ++i)
    {
      const Vec3 hand(2.0 + 0.001 * i, 0.0, 0.01 - 0.0003 * i);
      const HapticState state = touch.next(pathTick_s * i, { hand, Quat::Identity() });
      sum += state.force_W * (i + 1);
      EXPECT_FALSE(state.soft.pressed);
    }
    return sum;
  };
  EXPECT_LE((forceOn(true) - forceOn(false)).norm(), 1e-9 * forceOn(false).norm());
  EXPECT_GT(forceOn(true).norm(), 1.0);
}

TEST(SoftPath, WhatIsNoBodyIsRefusedInWords)
{
  const auto refusalOf = [](const auto& change)
  {
    SoftBodyInput input = softBlock(ElasticModel::Linear);
    change(input);
    std::string refusal;
    EXPECT_EQ(BodyMaker::make(input, "block", 0, refusal), nullptr);
    return refusal;
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const double young_Pa : { 0.0, -1.0, 0.02, 9.9, none, 1e12 })
  {
    EXPECT_NE(refusalOf([=](SoftBodyInput& i) { i.young_Pa = { young_Pa }; }), "") << young_Pa;
  }
  EXPECT_NE(refusalOf([](SoftBodyInput& i) { i.poisson = 0.5; }), "");
  EXPECT_NE(refusalOf([](SoftBodyInput& i) { i.fixed.assign(i.fixed.size(), false); }), "");
  EXPECT_NE(refusalOf([](SoftBodyInput& i) { i.mostBytes = 1000; }), "");
}

} // namespace
} // namespace palpate::test
