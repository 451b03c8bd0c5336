// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/force/SampledWall.h"
#include "haptics/force/StabilityLimits.h"

namespace palpate
{
namespace
{

SampledWall wallOf(double m, double b, double B, int delay, double T = 1e-3)
{
  SampledWall wall;
  wall.mass_kg = m;
  wall.damping_Ns_per_m = b;
  wall.virtualDamping_Ns_per_m = B;
  wall.delay_ticks = delay;
  wall.period_s = T;
  return wall;
}

TEST(SampledWall, ALightlyDampedWallHoldsWhatTheFormulaOfGilEtAlSays)
{
  // K < (b + B) / (T/2 + td), exact as b T / m goes to 0.
  for (const int delay : { 0, 1, 2 })
  {
    for (const double b : { 1e-3, 1e-2 })
    {
      const double formula = b / (1e-3 * (0.5 + delay));
      EXPECT_NEAR(criticalStiffness(wallOf(0.1, b, 0.0, delay)) / formula, 1.0, 1e-2);
    }
  }
}

TEST(SampledWall, BelowTheLimitTheLoopDecaysAndAboveItGrows)
{
  for (const double B : { 1.0, 5.0, 20.0 })
  {
    const SampledWall wall = wallOf(0.1, 0.0, B, 0);
    const double limit = criticalStiffness(wall);
    EXPECT_LT(spectralRadius(wall, 0.999 * limit), 1.0);
    EXPECT_GT(spectralRadius(wall, 1.001 * limit), 1.0);
  }
  EXPECT_EQ(criticalStiffness(wallOf(0.1, 0.0, 0.0, 0)), 0.0); // a held spring alone is never stable
}

TEST(SampledWall, AFirstOrderDeviceHasItsTextbookLimit)
{
  // Without mass to speak of the device is b x' = u: x+ = x - K T / b x, stable up to K = 2 b / T.
  const double b = 1.0, T = 1e-3;
  EXPECT_NEAR(criticalStiffness(wallOf(1e-6, b, 0.0, 0, T)) / (2 * b / T), 1.0, 1e-2);
}

DeviceInfo deviceOf(double m, double b)
{
  DeviceInfo device;
  device.mass_kg = { m, true };
  device.damping_Ns_per_m = { b, true };
  return device;
}

TEST(StabilityLimits, TheDevicesOwnLimitDecidesWhereItIsTheSmallest)
{
  DeviceInfo device = deviceOf(0.1, 1.0);
  LoopSettings loop;
  loop.passivity.enabled = true;
  device.maxStiffness_N_per_m = { 700.0, true };
  const StabilityLimits limits = stabilityLimits(device, loop);
  EXPECT_EQ(limits.decides, StiffnessLimit::Device);
  EXPECT_EQ(limits.largest_N_per_m, 700.0);
  EXPECT_NE(describe(limits, device, loop).find("700 N/m"), std::string::npos);
}

TEST(StabilityLimits, PassiveAndQuantisedBoundsAreTheirFormulas)
{
  DeviceInfo device = deviceOf(0.1, 1.0);
  device.friction_N = { 0.3, true };
  device.resolution_m = { 60e-6, true };
  LoopSettings loop{ 2e-3, 0.25, {} };
  loop.passivity.delay_ticks = 1.0;
  const StabilityLimits limits = stabilityLimits(device, loop);
  EXPECT_DOUBLE_EQ(limits.passive_N_per_m, (1.0 - 0.25) / (1.5 * 2e-3));
  EXPECT_DOUBLE_EQ(limits.quantised_N_per_m, 2 * 0.3 / 60e-6);
}

TEST(StabilityLimits, ASlowerLoopAndALongerDelayAllowLess)
{
  const DeviceInfo device = deviceOf(0.1, 1.0);
  double before = StabilityLimits::unlimited;
  for (const double period_s : { 2.5e-4, 1e-3, 4e-3, 1.6e-2 })
  {
    LoopSettings loop{ period_s, 0.0, {} };
    loop.passivity.enabled = true;
    const double prompt = stabilityLimits(device, loop).largest_N_per_m;
    EXPECT_LT(prompt, before);
    before = prompt;
    loop.passivity.delay_ticks = 2.0;
    EXPECT_LT(stabilityLimits(device, loop).largest_N_per_m, prompt);
  }
}

TEST(StabilityLimits, OfAToolThatTurnsAreThoseOfItsInertiaWhateverItsLever)
{
  DeviceInfo device;
  device.rendersForce = device.rendersTorque = true;
  device.mass_kg = { 1.0, true };
  device.damping_Ns_per_m = { 100.0, true };
  device.turnInertia_kg_m2 = { 1e-4, true };
  device.turnDamping_Nms = { 1e-3, true };
  for (const double lever_m : { 0.01, 0.05, 0.2 })
  {
    LoopSettings loop;
    loop.lever_m = lever_m;
    loop.passivity.enabled = false;
    // A wall of N m/rad, kg m2 and N m s: of the handle in a light hand of 0.5 N m/rad, 5e-3 N m s, 5e-5 kg m2.
    SampledWall turning = wallOf(1.5e-4, 6e-3, 0.0, 0);
    turning.handStiffness_N_per_m = 0.5;
    const StabilityLimits limits = stabilityLimits(device, loop);
    EXPECT_NEAR(limits.turning_N_per_m * lever_m * lever_m / criticalStiffness(turning), 1.0, 1e-4) << lever_m;
    if (limits.turning_N_per_m < limits.stable_N_per_m)
    {
      EXPECT_EQ(limits.decides, StiffnessLimit::Turning);
      EXPECT_DOUBLE_EQ(limits.largest_N_per_m, 0.8 * limits.turning_N_per_m);
      EXPECT_NE(describe(limits, device, loop).find("N m/rad"), std::string::npos);
    }
  }
  LoopSettings ball;
  EXPECT_EQ(stabilityLimits(device, ball).turning_N_per_m, StabilityLimits::unlimited);
  LoopSettings longest;
  longest.lever_m = 0.2;
  EXPECT_EQ(stabilityLimits(device, longest).decides, StiffnessLimit::Turning);
  device.rendersTorque = false;
  EXPECT_EQ(stabilityLimits(device, longest).turning_N_per_m, StabilityLimits::unlimited) << "it turns nobody";
}

TEST(StabilityLimits, NothingKnownAndNoHandMeanNoLimit)
{
  DeviceInfo device;
  EXPECT_EQ(stabilityLimits(device, {}).largest_N_per_m, StabilityLimits::unlimited);
  device = deviceOf(0.1, 1.0);
  device.rendersForce = false;
  EXPECT_EQ(stabilityLimits(device, {}).decides, StiffnessLimit::None);
  EXPECT_NE(describe(stabilityLimits(device, {}), device, {}).find("renders no force"), std::string::npos);
}

} // namespace
} // namespace palpate
