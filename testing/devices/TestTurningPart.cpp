// SPDX-License-Identifier: GPL-3.0-or-later
// The handle of a simulated device that turns in a hand.
#include <cmath>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/AllocationGuard.h"

namespace palpate
{
namespace
{

constexpr double step_s = 1e-3;

TurningModel plain(double inertia, double damping)
{
  TurningModel model;
  model.inertia_kg_m2 = inertia;
  model.damping_Nms = damping;
  return model;
}

TEST(TurningPart, UnderATorqueTurnsAboutItByTheFormulaOfADampedWheel)
{
  // w = T / b (1 - exp(-b t / J)), and the turn is its integral.
  constexpr double J = 1e-4, b = 1e-3, torque_Nm = 0.02;
  const Vec3 axis = Vec3(1, 2, 2) / 3.0;
  TurningPart part(plain(J, b), TurningModel{}, step_s);
  part.begin(Quat::Identity());
  for (int i = 1; i <= 100; ++i)
  {
    part.step(Quat::Identity(), Quat::Identity(), torque_Nm * axis);
    const double t = i * step_s, decay = std::exp(-b * t / J);
    EXPECT_NEAR((part.rate_D() - torque_Nm / b * (1 - decay) * axis).norm(), 0.0, 1e-9);
    const double turned = torque_Nm / b * (t - J / b * (1 - decay));
    EXPECT_NEAR(turnFromTo(turnBy(turned * axis), part.turn_D()).norm(), 0.0, 1e-9);
  }
}

TEST(TurningPart, GoesWhereItsHandIsLedAndIsHeldBackByATorqueOverTheHandsStiffness)
{
  const Quat led = turnBy(Vec3(0.3, -0.5, 0.2));
  for (const HandModel& hand : handModels())
  {
    if (hand.turning.stiffness_Nm_per_rad > 0.0)
    {
      const double k = hand.turning.stiffness_Nm_per_rad;
      TurningPart part(plain(1e-4, 1e-3), hand.turning, step_s);
      part.begin(Quat::Identity());
      const Vec3 torque_Nm(0.02, 0.01, -0.03);
      for (int i = 0; i < 3000; ++i)
      {
        part.step(led, led, torque_Nm);
      }
      EXPECT_LE((turnFromTo(led, part.turn_D()) - torque_Nm / k).norm(), 1e-9) << hand.name;
    }
  }
}

TEST(TurningPart, StaysUnderATorqueBelowItsFrictionAndGivesNoMoreThanItsMotorsDo)
{
  TurningModel device = plain(1e-4, 1e-3);
  device.friction_Nm = 5e-3;
  device.maxTorque_Nm = 0.1;
  TurningPart part(device, TurningModel{}, step_s);
  part.begin(Quat::Identity());
  part.step(Quat::Identity(), Quat::Identity(), Vec3(4.9e-3, 0, 0));
  EXPECT_EQ(part.rate_D(), Vec3(0, 0, 0));
  part.step(Quat::Identity(), Quat::Identity(), Vec3(10.0, 0, 0));
  TurningPart limited(device, TurningModel{}, step_s);
  limited.begin(Quat::Identity());
  limited.step(Quat::Identity(), Quat::Identity(), Vec3(0.1, 0, 0));
  EXPECT_EQ(part.rate_D(), limited.rate_D());
}

TEST(TurningPart, OfADeviceShowsWholeStepsAndNoRateAndOnlyWhereItTurns)
{
  const DeviceModel& model = *deviceModel("simulated-6d");
  SimulatedDevice device(
    model, *handModel("firm"), HandPath{ { Vec3::Zero(), Vec3(0.01, 0, 0) }, 0.05, false, Vec3(0, 0, 0.7) });
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  {
    const test::AllocationGuard guard;
    for (int i = 1; i <= 1000; ++i)
    {
      static_cast<void>(device.read(i * step_s, sample));
    }
    EXPECT_EQ(guard.allocations() + guard.locks(), 0u);
  }
  const double steps = rotationVector(sample.pose_D.q).z() / model.turning.step_rad;
  EXPECT_NEAR(steps, std::round(steps), 1e-6);
  EXPECT_NEAR(rotationVector(sample.pose_D.q).z(), 0.7, model.turning.friction_Nm / 2.0 + model.turning.step_rad)
    << "where the hand's spring of 2 N m/rad and friction leave it";
  EXPECT_EQ(sample.velocity_D.angular, Vec3(0, 0, 0));
  EXPECT_TRUE(device.info().rendersTorque);
  EXPECT_EQ(device.info().abilities.sensedAxes, 6);
  SimulatedDevice point(*deviceModel("simulated-premium"), *handModel("firm"), HandPath{ { Vec3::Zero() } });
  ASSERT_EQ(point.open(), "");
  static_cast<void>(point.read(step_s, sample));
  EXPECT_EQ(sample.pose_D.q.coeffs(), Quat::Identity().coeffs());
  EXPECT_FALSE(point.info().rendersTorque);
}

} // namespace
} // namespace palpate
