// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/session/DeviceAdaptation.h"

namespace palpate
{
namespace
{

constexpr double period_s = 1e-3;

DeviceInfo dampedDevice()
{
  DeviceInfo device;
  device.mass_kg = { 0.1, true };
  device.damping_Ns_per_m = { 2.0, true };
  return device;
}

double passiveAt(const HapticParameters& parameters, double T_s)
{
  return judgeLoop(parameters, dampedDevice(), T_s).limits.passive_N_per_m;
}

TEST(JudgedLoop, IsOfThePeriodAndTheDampingThatItIsRunWith)
{
  // b / (T/2 + delay) - B, the delay being whole periods (Colgate & Schenkel 1997).
  HapticParameters parameters;
  parameters.damping_Ns_per_m = 0.0;
  EXPECT_NEAR(passiveAt(parameters, period_s) / passiveAt(parameters, 2 * period_s), 2.0, 1e-12);
  HapticParameters damped = parameters;
  damped.damping_Ns_per_m = 0.5;
  const double periods = 2.0 / passiveAt(parameters, period_s) / period_s; // T/2 + delay, in periods
  EXPECT_NEAR(passiveAt(damped, period_s), (2.0 - 0.5) / (periods * period_s), 1e-9);
}

TEST(JudgedLoop, SaysTheStiffnessThatItFound)
{
  DeviceInfo device = dampedDevice();
  device.maxStiffness_N_per_m = { 321.0, true };
  HapticParameters parameters;
  parameters.passivity.enabled = true;
  const JudgedLoop judged = judgeLoop(parameters, device, period_s);
  EXPECT_EQ(judged.limits.largest_N_per_m, 321.0);
  EXPECT_NE(judged.sentence.find("321 N/m"), std::string::npos) << judged.sentence;
  EXPECT_EQ(adaptToDevice(parameters, device, judged.limits).stiffnessLimit_N_per_m, 321.0);
}

TEST(JudgedLoop, LimitsNothingWhereAPersonSwitchedTheLimitOff)
{
  DeviceInfo device = dampedDevice();
  device.maxStiffness_N_per_m = { 321.0, true };
  HapticParameters parameters;
  parameters.limitStiffness = false;
  const StabilityLimits limits = judgeLoop(parameters, device, period_s).limits;
  EXPECT_TRUE(std::isinf(adaptToDevice(parameters, device, limits).stiffnessLimit_N_per_m));
}

} // namespace
} // namespace palpate
