// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "haptics/force/LinearPlant.h"
#include "haptics/force/PassivityController.h"
#include "haptics/force/VirtualCoupling.h"
#include "testing/haptics/force/SamplingPeriod.h"

namespace palpate
{
namespace
{

using test::T;

/// A spring wall below z = 0 whose force is held over each period, with the energy meter and the controller.
class DeviceWall
{
public:
  DeviceWall(double stiffness, PassivityPlan plan) : stiffness_(stiffness), plan_(plan) {}

  /// Force [N] along z for a hand at height z that came from the last one at constant speed.
  double force(double z_m)
  {
    const double step_m = this->first_ ? 0.0 : z_m - this->z_m_;
    this->first_ = false;
    SpringTick tick;
    tick.stretch_m = std::max(0.0, -z_m);
    tick.inward_m_per_s = -step_m / T;
    tick.stiffness_N_per_m = this->stiffness_;
    tick.work_J = this->force_ * step_m;
    tick.dt_s = T;
    measureEnergy(tick, this->meter);
    this->added_Ns_per_m = stabilisingDamping(this->plan_, tick, this->meter);
    this->z_m_ = z_m;
    const Vec3 stretch(0, 0, tick.stretch_m), velocity(0, 0, step_m / T);
    return this->force_ = coupleDevice(stretch, velocity, this->stiffness_, this->added_Ns_per_m).z();
  }

  EnergyMeter meter;
  double added_Ns_per_m = 0.0;

private:
  double stiffness_;
  PassivityPlan plan_;
  double z_m_ = 0.0, force_ = 0.0;
  bool first_ = true;
};

/// Presses from the surface to a depth and back to the surface at constant speed; visits every tick.
void press(DeviceWall& wall, double speed, double depth, double phase, const std::function<void(double z)>& visit = {})
{
  const double half_s = depth / speed;
  for (double t = (phase - 1.0) * T; t < 2 * half_s + 2 * T; t += T)
  {
    const double z = std::min(0.0, std::abs(depth - speed * t) - depth);
    wall.force(z);
    if (visit)
    {
      visit(z);
    }
  }
}

TEST(EnergyMeter, MeasuresTheLeakOfAHeldSpringAsTheFormulaSays)
{
  const double K = 1000.0, v = 0.1, depth = 5e-3;
  double sum = 0.0;
  const int phases = 100;
  for (int i = 0; i < phases; ++i)
  {
    DeviceWall wall(K, {});
    press(wall, v, depth, (i + 0.5) / phases);
    sum += wall.meter.delivered_J;
  }
  const double leak = K * v * T * (depth - v * T / 2); // mean over the phase of sampling
  EXPECT_NEAR(sum / phases, leak, 1e-3 * leak);
}

TEST(EnergyMeter, ForgetsAContactWhenItEndsAndGivesNoCreditForWhatWasTaken)
{
  DeviceWall wall(1000.0, {});
  press(wall, 0.1, 2e-3, 0.5, [&wall](double z) { EXPECT_LE(wall.meter.absorbed_J, 0.5 * 1000.0 * z * z + 1e-18); });
  EXPECT_EQ(wall.meter.absorbed_J, 0.0);
  EXPECT_EQ(wall.meter.excess_J, 0.0);
  EXPECT_FALSE(wall.meter.touching);
}

TEST(EnergyMeter, AForceThatWasNotTheSpringsOwnStartsTheComparisonAnew)
{
  EnergyMeter meter;
  SpringTick tick;
  tick.stiffness_N_per_m = 1000.0;
  tick.stretch_m = 2e-3;
  tick.work_J = 0.5; // far more than the spring could give
  tick.restart = true;
  measureEnergy(tick, meter);
  EXPECT_EQ(meter.delivered_J, 0.5);
  EXPECT_EQ(meter.excess_J, 0.0);
  EXPECT_EQ(meter.absorbed_J, 0.5 * 1000.0 * 2e-3 * 2e-3);
}

TEST(PassivityController, APressAndReleaseDeliversNothingAtAnyPhaseAndSpeed)
{
  PassivityPlan plan;
  plan.enabled = true;
  for (const double v : { 0.01, 0.1, 0.5 })
  {
    for (int i = 0; i < 20; ++i)
    {
      DeviceWall wall(2000.0, plan);
      press(wall, v, 4e-3, i / 20.0);
      EXPECT_LE(wall.meter.delivered_J, 0.0) << v << " m/s, phase " << i / 20.0;
    }
  }
}

TEST(PassivityController, AddsNothingInFreeSpaceAndNothingWhenItIsOff)
{
  PassivityPlan on;
  on.enabled = true;
  DeviceWall free(1000.0, on), off(1000.0, {});
  for (int k = 0; k < 100; ++k)
  {
    EXPECT_EQ(free.force(1e-6 + 1e-4 * (k % 7)), 0.0);
    off.force(-1e-3 - 1e-4 * (k % 7));
    EXPECT_EQ(off.added_Ns_per_m, 0.0);
  }
}

TEST(PassivityController, ItsDampingIsBoundedAtEverySpeedAndEnergy)
{
  PassivityPlan plan;
  plan.enabled = true;
  plan.delay_ticks = 1.0;
  SpringTick tick;
  tick.stiffness_N_per_m = 800.0;
  tick.stretch_m = 1e-3;
  EnergyMeter meter;
  meter.touching = true;
  const double unit = 800.0 * T, ahead = (0.5 + 1.0 + plan.reserve) * unit;
  for (const double excess : { 0.0, 1e-12, 1e-3, 10.0 })
  {
    for (const double v : { 0.0, 1e-300, 1e-9, 0.05, 3.0 })
    {
      meter.excess_J = excess;
      tick.inward_m_per_s = v;
      const double b = stabilisingDamping(plan, tick, meter);
      ASSERT_TRUE(std::isfinite(b));
      EXPECT_GE(b, ahead);
      EXPECT_LE(b, ahead + plan.repay * unit);
    }
  }
}

TEST(PassivityController, AMassNeverComesBackWithMoreThanItBrought)
{
  PassivityPlan plan;
  plan.enabled = true;
  const double m = 0.1, v0 = 0.2;
  for (const double K : { 500.0, 2000.0, 10000.0 })
  {
    for (int i = 0; i < 40; ++i)
    {
      const LinearPlant plant(m, 0.0, 0.0, T);
      DeviceWall wall(K, plan);
      Vec3 x(0, 0, v0 * T * i / 40.0), v(0, 0, -v0);
      do
      {
        const double force = wall.force(x.z());
        plant.step(x, v, { 0, 0, force });
      } while (x.z() < 0.0 || v.z() < 0.0);
      EXPECT_LE(v.z(), v0) << K << " N/m, phase " << i / 40.0;
    }
  }
}

} // namespace
} // namespace palpate
