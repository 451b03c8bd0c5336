// SPDX-License-Identifier: GPL-3.0-or-later
// The guide to a plane: its force, limit, ramp and energy.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/Guide.h"
#include "testing/haptics/force/SamplingPeriod.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::T;

TEST(Guide, IsASpringToThePlaneUpToItsLimitFromBothSides)
{
  GuidePlan plan;
  plan.stiffness_N_per_m = 200.0;
  plan.largest_N = 2.0;
  for (const double height_m : { 0.0, 0.001, 0.0099, 0.02, 5.0 })
  {
    const double expected_N = std::min(200.0 * height_m, 2.0);
    EXPECT_DOUBLE_EQ(guideForce(plan, 1.0, height_m, 0.0, T), -expected_N);
    EXPECT_DOUBLE_EQ(guideForce(plan, 1.0, -height_m, 0.0, T), expected_N);
    EXPECT_DOUBLE_EQ(guideForce(plan, 0.25, height_m, 0.0, T), -0.25 * expected_N);
  }
}

TEST(Guide, NeverPushesAwayFromThePlaneAndNeverBeyondItsLimitHoweverFastTheHandIs)
{
  const GuidePlan plan;
  test::Random random(test::testSeed(7));
  for (std::size_t i = 0; i < test::testCount(10000); ++i)
  {
    const double height_m = random.uniform(-0.05, 0.05);
    const double force_N = guideForce(plan, random.uniform(0, 1), height_m, random.uniform(-3, 3), T);
    ASSERT_LE(force_N * height_m, 0.0);
    ASSERT_LE(std::fabs(force_N), plan.largest_N);
  }
}

TEST(Guide, ComesAndGoesLinearlyInItsRampTime)
{
  double share = 0.0;
  for (int i = 1; i <= 500; ++i)
  {
    share = rampedShare(share, true, 0.5, T);
    ASSERT_NEAR(share, i / 500.0, 1e-12);
  }
  EXPECT_EQ(rampedShare(share, true, 0.5, T), 1.0);
  EXPECT_NEAR(rampedShare(share, false, 0.5, T), 1.0 - 1.0 / 500, 1e-12);
  EXPECT_EQ(rampedShare(0.3, true, 0.0, T), 1.0);
  EXPECT_EQ(rampedShare(0.3, false, 0.0, T), 0.0);
}

// With d_k the heights of a closed path and steps D_k = d_{k+1} - d_k the held force of the spring gives K/2 sum D_k^2,
// and the damping K T takes K sum D_k D_{k-1}: all energy of the hold, and as much again but for the part of the hand's
// acceleration, K/2 sum (D_k - D_{k-1})^2.
TEST(Guide, AClosedWayTakesFromTheHandWhatTheHoldOfTheForceWouldGiveIt)
{
  GuidePlan plan;
  plan.largest_N = 1e9;
  test::Random random(test::testSeed(11));
  std::vector<double> d_m;
  constexpr int period = 400;
  const double phase = random.uniform(0, 6);
  for (int i = 0; i < period; ++i)
  {
    d_m.push_back(0.02 + 0.005 * std::sin(2 * M_PI * i / period + phase) + 0.002 * std::cos(6 * M_PI * i / period));
  }
  double work_J = 0.0, expected_J = 0.0, hold_J = 0.0, bent_J = 0.0;
  for (int i = 0; i < period; ++i)
  {
    const double before = d_m[(i + period - 1) % period], now = d_m[i], after = d_m[(i + 1) % period];
    work_J += guideForce(plan, 1.0, now, (now - before) / T, T) * (after - now);
    const double step = after - now, stepBefore = now - before;
    hold_J += 0.5 * plan.stiffness_N_per_m * step * step;
    bent_J += 0.5 * plan.stiffness_N_per_m * (step - stepBefore) * (step - stepBefore);
    expected_J += plan.stiffness_N_per_m * (0.5 * step * step - step * stepBefore);
  }
  EXPECT_NEAR(work_J, expected_J, 1e-15);
  EXPECT_NEAR(work_J, bent_J - hold_J, 1e-15) << "sum D_k^2 is sum D_{k-1}^2 on a closed way";
  EXPECT_LT(work_J, -0.99 * hold_J);
}

// Nobody holds the device: from 2 cm above the plane it comes down to it and stays, and is never faster than all the
// energy of the guide would make it.
TEST(Guide, AFreeDeviceComesToThePlaneAndStays)
{
  for (const char* const name : { "simulated-touch", "simulated-generic", "simulated-falcon", "simulated-omega" })
  {
    const DeviceModel& model = *deviceModel(name);
    HandPath path;
    path.points_D = { Vec3(0, 0, 0.02) };
    SimulatedDevice device(model, *handModel("none"), path);
    ASSERT_EQ(device.open(), "");
    const GuidePlan plan;
    double share = 0.0, before_m = 0.02, fastest = 0.0;
    DeviceSample sample;
    for (int i = 1; i <= 8000; ++i)
    {
      static_cast<void>(device.read(T * i, sample));
      const double height_m = sample.pose_D.p.z();
      share = rampedShare(share, true, plan.ramp_s, T);
      DeviceCommand command;
      command.wrench_D.force.z() = guideForce(plan, share, height_m, (height_m - before_m) / T, T);
      device.write(command);
      before_m = height_m;
      fastest = std::max(fastest, device.speed_D().norm());
    }
    // Friction holds a device where the guide is weaker than it; the measurement is a step off at most. Swings are
    // damped by the device: by e^(-b t / 2 m) since the guide has all its force.
    const double left_m = 0.02 * std::exp(-0.5 * model.damping_Ns_per_m / model.mass_kg * (8.0 - plan.ramp_s));
    const double rest_m = model.friction_N / plan.stiffness_N_per_m + model.encoderStep_m + left_m;
    EXPECT_LE(std::fabs(device.position_D().z()), rest_m) << name;
    EXPECT_LE(device.speed_D().norm(), 1e-3) << name;
    const double most_J = plan.largest_N * 0.02;
    EXPECT_LE(0.5 * model.mass_kg * fastest * fastest, most_J) << name;
  }
}

} // namespace
} // namespace palpate
