// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "haptics/session/HapticSession.h"
#include "testing/support/Admittance.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"

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

TEST(AdmittanceDevice, InASessionHoldsItsHandleAtTheSurfaceThatTheHandPressesInto)
{
  constexpr double half_m = 0.02, deep_m = 0.004;
  HandPath path; // into the side of a box, to stay there
  path.points_D = { Vec3(1.5 * half_m, 1e-3, 2e-3), Vec3(half_m - deep_m, 1e-3, 2e-3) };
  path.loops = false;
  const HandModel& hand = *handModel("stylus");
  auto owned = std::make_unique<AdmittanceDevice>(AdmittancePlan(), hand, path);
  AdmittanceDevice& device = *owned;
  HapticSession session;
  session.setScene(test::sceneOf(test::makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m))));
  HapticParameters parameters = session.parameters();
  parameters.map = {};
  ASSERT_EQ(session.setParameters(parameters), "");
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::move(owned), options), "");
  ASSERT_EQ(session.step(10000), 10000);
  EXPECT_EQ(session.state().fault, Fault::None);
  // At rest nothing accelerates the virtual mass: the hand's pull and the force of the session are in balance.
  const double pull_N = hand.stiffness_N_per_m * deep_m;
  EXPECT_NEAR(device.handle_D().x(), half_m, 0.005 * deep_m) << "the proxy's place";
  EXPECT_NEAR(device.handForce_D().x(), -pull_N, 0.005 * pull_N);
  EXPECT_NEAR(session.state().force_W.x(), pull_N, 0.005 * pull_N);
  const Vec3 rest_D = device.handle_D();
  double away_m = 0.0;
  for (int tick = 0; tick < 1000; ++tick)
  {
    ASSERT_EQ(session.step(1), 1);
    away_m = std::max(away_m, (device.handle_D() - rest_D).norm());
  }
  EXPECT_LT(away_m, 1e-6) << "it is at rest";
  EXPECT_EQ(session.stop(), "");
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
