// SPDX-License-Identifier: GPL-3.0-or-later
// Loose bodies on springs and pins move as their inertia says.
#include <gtest/gtest.h>

#include "LooseScenes.h"

namespace palpate::test
{
namespace
{

TEST(DirectCoupling, HoldsFarBeyondTheStiffnessAtWhichAnExplicitStepDoesNot)
{
  constexpr double own_N_per_m = 2e4;
  const double mass_kg = Coupled(1e3, own_N_per_m).mass_kg();
  const double limit_N_per_m = 4.0 * mass_kg / (tickOfPath_s * tickOfPath_s) - own_N_per_m;
  EXPECT_FALSE(explodes(mass_kg, 0.98 * limit_N_per_m, own_N_per_m));
  EXPECT_TRUE(explodes(mass_kg, 1.02 * limit_N_per_m, own_N_per_m));
  for (const double times : { 0.5, 1.02, 10.0, 100.0 })
  {
    const double hand_N_per_m = times * limit_N_per_m;
    Coupled coupled(hand_N_per_m, own_N_per_m);
    constexpr double hand_m = 1e-3;
    const double rests_m = hand_N_per_m * hand_m / (hand_N_per_m + own_N_per_m);
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_LE(std::abs(coupled.next(hand_m) - rests_m), 1.001 * rests_m) << times << " at " << i;
    }
    for (int i = 0; i < 3000; ++i)
    {
      (void)coupled.next(hand_m);
    }
    EXPECT_NEAR(coupled.next(hand_m), rests_m, 1e-6 * rests_m) << times;
  }
}

TEST(Loose, SwingsAsAPendulumDoesTheNearerTheShorterTheTick)
{
  constexpr double until_s = 0.16; // before the lowest place
  const double truth_rad = pendulum_rad(until_s);
  double before = 0.0;
  for (const double tick_s : { 1e-3, 5e-4, 2.5e-4 })
  {
    const Swung end = swung(tick_s, until_s);
    EXPECT_NEAR(end.away_m, Swung::arm_m, 1e-3 * Swung::arm_m);
    const double off_rad = std::abs(end.angle_rad - truth_rad);
    EXPECT_LE(off_rad, 10.0 * tick_s);
    EXPECT_GT(off_rad, 0.0);
    if (before > 0.0)
    {
      EXPECT_NEAR(before / off_rad, 2.0, 0.2) << tick_s;
    }
    before = off_rad;
  }
}

} // namespace
} // namespace palpate::test
