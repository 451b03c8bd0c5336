// SPDX-License-Identifier: GPL-3.0-or-later
// Protection of a hand that a device pushes by itself: how hard walls and leads may push, and how fast that may grow.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/haptics/session/HoldingTick.h"

namespace palpate
{
namespace
{

using test::corridor;
using test::K;
using test::sceneOf;
using test::slant;
using Tick = test::HoldingTick;

// A hand rests p = 2 mm behind a wall of K / 10 when K comes back, as after a time of late ticks: K p / 10 + r T k.
TEST(DeviceWallLimits, AWallThatPressesGetsStifferNoFasterThanAForceMayRise)
{
  constexpr double p_m = 0.002, rise_N_per_s = 150.0, dt_s = 1e-3;
  Tick tick{ sceneOf(slant(0.0)) };
  tick.parameters.stiffness_N_per_m = K / 10;
  static_cast<void>(tick.at(0.0, p_m));
  EXPECT_NEAR(tick.at(0.0, -p_m).state.force_D.y(), K / 10 * p_m, 1e-12);
  tick.parameters.safety.maxRise_N_per_s = rise_N_per_s;
  tick.parameters.stiffness_N_per_m = K;
  for (int k = 1; k <= 5; ++k)
  {
    const double force_N = tick.at(0.0, -p_m, dt_s).state.force_D.y();
    EXPECT_NEAR(force_N, std::min(K * p_m, K / 10 * p_m + rise_N_per_s * dt_s * k), 1e-12) << k;
  }
}

TEST(DeviceWallLimits, ALeadPushesNoHarderThanAnythingMay)
{
  Tick tick{ sceneOf(corridor(0.01)) };
  tick.parameters.game.on = true;
  tick.parameters.game.start_W = { 0.03, 0.0, 0.0 };
  tick.parameters.game.exitReach_u = 1e-3;
  tick.parameters.safety.maxForce_N = 0.25 * tick.parameters.game.largest_N;
  double strongest_N = 0.0;
  for (int i = 0; i < 1000; ++i) // a hand that is not moved by it
  {
    const TickOutput now = tick.at(0.0, 0.0);
    ASSERT_EQ(now.state.game, GamePhase::Leads);
    strongest_N = std::max(strongest_N, now.state.force_D.norm());
  }
  EXPECT_GT(strongest_N, 0.5 * tick.parameters.safety.maxForce_N);
  EXPECT_LE(strongest_N, tick.parameters.safety.maxForce_N);
}

// K times the reach of the draw is the largest force of the plan, in any direction of the start.
TEST(DeviceWallLimits, AlongAnAxisAndBetweenAxesALeadPushesWithAllThatItsPlanSays)
{
  for (const double angle : { 0.0, 0.3, std::numbers::pi / 4, std::numbers::pi / 2 })
  {
    Tick tick{ sceneOf(corridor(0.01)) };
    tick.parameters.game.on = true;
    tick.parameters.game.start_W = { 0.03 * std::cos(angle), 0.03 * std::sin(angle), 0.0 };
    tick.parameters.game.exitReach_u = 1e-3;
    HapticState state;
    for (int i = 0; i < 1000; ++i) // a hand that is not moved by it
    {
      state = tick.at(0.0, 0.0).state;
    }
    ASSERT_EQ(state.game, GamePhase::Leads);
    EXPECT_NEAR(state.force_D.norm(), tick.parameters.game.largest_N, 1e-9) << angle;
  }
}

// A hand in a hurry: the damper alone would say 8 N s/m times its speed.
TEST(DeviceWallLimits, WhatIsToldOfALeadIsNoMoreThanAnythingMayPush)
{
  Tick tick{ sceneOf(corridor(0.01)) };
  tick.parameters.game.on = true;
  tick.parameters.game.start_W = { 0.03, 0.0, 0.0 };
  tick.parameters.game.exitReach_u = 1e-3;
  tick.parameters.safety.maxForce_N = 2.0;
  double strongest_N = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    strongest_N = std::max(strongest_N, tick.at(-0.8e-3 * i, 0.0).state.force_D.norm());
  }
  EXPECT_LE(strongest_N, tick.parameters.safety.maxForce_N);
  EXPECT_GT(strongest_N, 0.9 * tick.parameters.safety.maxForce_N);
}

// A floor under a hand that is pressed to its limit F, and a wall beside it: each of two may push with F / sqrt(2), one
// alone with F. Past the end of the reach of the wall beside it the force goes up by the largest rise of a tick.
TEST(DeviceWallLimits, AWallThatIsPressedToItsLimitGetsTheShareOfAnotherNoFasterThanAForceMayRise)
{
  constexpr double most_N = 3.0, rise_N_per_s = 150.0, dt_s = 1e-3, deep_m = 0.02;
  Tick tick{ sceneOf(CurveSet{ { { -0.1, 0 }, { 0.1, 0 }, { 0.005, 0 }, { 0.005, 0.05 } }, { { 0, 1 }, { 2, 3 } } }) };
  tick.parameters.safety.maxForce_N = most_N;
  for (int i = 0; i <= 40; ++i)
  {
    static_cast<void>(tick.at(0.0, 0.001 - i * 1e-3 * (deep_m + 0.001) / 0.04, dt_s));
  }
  EXPECT_NEAR(tick.at(0.0, -deep_m, dt_s).state.force_D.y(), most_N / std::numbers::sqrt2, 1e-12);
  tick.parameters.safety.maxRise_N_per_s = rise_N_per_s;
  double force_N = most_N / std::numbers::sqrt2;
  for (int i = 0; i < 40; ++i)
  {
    const double next_N = tick.at(-0.02, -deep_m, dt_s).state.force_D.y();
    EXPECT_LE(next_N - force_N, rise_N_per_s * dt_s + 1e-12) << i;
    force_N = next_N;
  }
  EXPECT_NEAR(force_N, most_N, 1e-12);
}

// Energy that such a device gives beyond its commands cannot be metered; the hand that it throws is seen by its speed.
TEST(DeviceWallLimits, AHandThatIsThrownFromHeldWallsFasterThanAHandCanBeIsLetGo)
{
  constexpr double fastest_m_per_s = 2.0, p_m = 0.02, dt_s = 1e-3;
  Tick tick{ sceneOf(slant(0.0)) };
  tick.parameters.safety.hand.speed_m_per_s = fastest_m_per_s;
  static_cast<void>(tick.at(0.0, p_m));
  for (int i = 0; i < 100; ++i)
  {
    ASSERT_EQ(tick.at(0.0, -p_m).state.fault, Fault::None) << i; // the jump was in free air
  }
  double y_m = -p_m;
  TickOutput out;
  do
  {
    y_m += 1.01 * fastest_m_per_s * dt_s;
    ASSERT_LT(y_m, 0.0) << "while the wall still pushes";
    out = tick.at(0.0, y_m);
  } while (out.state.fault == Fault::None);
  EXPECT_EQ(out.state.fault, Fault::VelocityCut);
  EXPECT_EQ(tick.at(0.0, -p_m).command.wallCount, 0);
}

TEST(DeviceWallLimits, ASampleThatIsNoNumberForgetsNeitherTheGameNorTheButtons)
{
  Tick tick{ sceneOf(corridor(0.01)) };
  tick.parameters.game.on = true;
  tick.parameters.game.start_W = Vec3::Zero();
  tick.parameters.game.exit_W = { 0.03, 0.0, 0.0 };
  tick.parameters.game.exitReach_u = 1e-3;
  tick.parameters.safety.deadMan.buttons = 1;
  HapticState before;
  for (int i = 0; i < 500; ++i)
  {
    before = tick.at(0.0, 0.0, 1e-3, 3).state;
  }
  ASSERT_EQ(before.game, GamePhase::Explores);
  ASSERT_GT(before.gameTime_s, 0.0);
  const HapticState bad = tick.at(std::numeric_limits<double>::quiet_NaN(), 0.0, 1e-3, 2).state;
  EXPECT_TRUE(bad.held);
  EXPECT_EQ(bad.buttons, 2U);
  EXPECT_TRUE(bad.letGo);
  EXPECT_EQ(bad.game, GamePhase::Explores);
  EXPECT_EQ(bad.gameTime_s, before.gameTime_s);
  EXPECT_EQ(bad.force_D, Vec3(Vec3::Zero()));
}

} // namespace
} // namespace palpate
