// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "testing/support/Admittance.h"
#include "testing/support/AllocationGuard.h"

namespace palpate
{
namespace
{

using test::inAir;
using test::nudge;

TEST(AdmittanceDevice, ShakesAgainstAThingAsStiffAsTheFormulaSays)
{
  // Row 86. By exact eigenvalues of the same loop: 1697 and 521 N/m.
  for (const auto& [lag_s, formula, exact] : { std::tuple{ 0.005, 1717.0, 1697.0 }, std::tuple{ 0.02, 526.0, 521.0 } })
  {
    AdmittancePlan plan;
    plan.lag_s = lag_s;
    EXPECT_NEAR(stiffestHold(plan), formula, 0.5);
    const double found = test::stiffestHoldFound(plan, formula);
    EXPECT_NEAR(found, formula, 0.03 * formula);
    EXPECT_NEAR(found, exact, 0.005 * exact);
  }
}

TEST(AdmittanceDevice, IsBrakedInAirByItsVirtualDampingAlone)
{
  AdmittancePlan plan;
  HandPath path;
  path.points_D = { Vec3::Zero(), Vec3(1.0, 0.0, 0.0) };
  path.speed_m_per_s = 0.1;
  AdmittanceDevice device(plan, *handModel("stylus"), path);
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  const test::AllocationGuard guard;
  for (int tick = 0; tick < 8000; ++tick)
  {
    ASSERT_EQ(device.read(tick * 1e-3, sample), DeviceStatus::Ok);
    device.write(inAir(sample));
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_NEAR(device.handForce_D().x(), plan.damping_Ns_per_m * 0.1, 1e-6);
  EXPECT_EQ(sample.sensed_D.force, device.handForce_D());
}

TEST(AdmittanceDevice, IsAsStillAsItsSensorLetsItBe)
{
  AdmittancePlan plan;
  plan.noise_N = 0.3;
  HandPath still;
  still.points_D = { Vec3(0.01, 0.02, 0.03) };
  const HandModel& hand = *handModel("stylus");
  AdmittanceDevice device(plan, hand, still);
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  double most = 0.0, way = 0.0;
  for (int tick = 1; tick <= 5000; ++tick)
  {
    ASSERT_EQ(device.read(tick * 1e-3, sample), DeviceStatus::Ok);
    device.write(inAir(sample));
    const double noise = (sample.sensed_D.force - device.handForce_D()).cwiseAbs().maxCoeff();
    EXPECT_LE(noise, plan.noise_N);
    most = std::max(most, noise);
    way = std::max(way, (device.handle_D() - still.points_D[0]).norm());
  }
  EXPECT_GT(most, 0.95 * plan.noise_N);
  // White noise of variance n^2 / 3 at 1 / T: sigma^2 = n^2 T / 3 / (2 c k), with the damping c that the lag leaves.
  const double k = hand.stiffness_N_per_m;
  const double c = plan.damping_Ns_per_m + hand.damping_Ns_per_m - k * (plan.lag_s + plan.period_s);
  const double sigma = plan.noise_N * std::sqrt(plan.period_s / (6.0 * c * k));
  EXPECT_GT(way, 2.0 * sigma);
  EXPECT_LT(way, 6.0 * sigma);
}

TEST(AdmittanceDevice, IsOneThatTheFactoryMakes)
{
  DeviceOptions options;
  options.stroke = nudge();
  const MadeDevice made = makeDevice("simulated-admittance", options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_EQ(made.device->info().causality, Causality::Admittance);
  EXPECT_EQ(made.device->open(), "");
  AdmittanceDevice nobody(AdmittancePlan(), HandModel{}, HandPath{});
  EXPECT_THAT(nobody.open(), testing::HasSubstr("no path"));
}

} // namespace
} // namespace palpate
