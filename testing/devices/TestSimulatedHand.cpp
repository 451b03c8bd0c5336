// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "devices/ReplayDevice.h"
#include "haptics/force/LinearPlant.h"
#include "devices/simulated/SimulatedHand.h"

namespace palpate
{
namespace
{

constexpr double period_s = 1e-3;

// D0: x+ = x + v T + u T^2 / 2m, v+ = v + u T / m (uniform acceleration).
TEST(LinearPlant, WithoutDampingFollowsUniformAccelerationExactly)
{
  constexpr double mass_kg = 0.1, force_N = 0.7;
  const LinearPlant plant(mass_kg, 0.0, 0.0, period_s);
  Vec3 x = Vec3::Zero(), v(0.2, 0, 0);
  for (int n = 1; n <= 1000; ++n)
  {
    plant.step(x, v, Vec3(force_N, 0, 0));
    const double t = n * period_s, a = force_N / mass_kg;
    ASSERT_NEAR(x.x(), 0.2 * t + 0.5 * a * t * t, 1e-12);
    ASSERT_NEAR(v.x(), 0.2 + a * t, 1e-12);
  }
}

// D1: v(t) = vi + (v0 - vi) exp(-b t / m), vi = u / b; x by integration.
TEST(LinearPlant, WithDampingFollowsItsExponentialExactly)
{
  constexpr double mass_kg = 0.1, damping = 1.0, force_N = 0.7, v0 = 0.2;
  const LinearPlant plant(mass_kg, damping, 0.0, period_s);
  Vec3 x = Vec3::Zero(), v(v0, 0, 0);
  for (int n = 1; n <= 1000; ++n)
  {
    plant.step(x, v, Vec3(force_N, 0, 0));
    const double t = n * period_s, vi = force_N / damping, e = std::exp(-damping * t / mass_kg);
    ASSERT_NEAR(v.x(), vi + (v0 - vi) * e, 1e-13);
    ASSERT_NEAR(x.x(), vi * t + (v0 - vi) * (mass_kg / damping) * (1 - e), 1e-13);
  }
}

// m x'' + b x' + k x = 0 from x0 at rest: x0 e^{-s t} (cos w t + s / w sin w t), s = b / 2m, w^2 = k / m - s^2.
TEST(LinearPlant, OnASpringFollowsTheDampedOscillationExactly)
{
  constexpr double mass_kg = 0.2, damping = 6.0, stiffness = 500.0, x0 = 0.01;
  const LinearPlant plant(mass_kg, damping, stiffness, period_s);
  const double s = damping / (2 * mass_kg), w = std::sqrt(stiffness / mass_kg - s * s);
  Vec3 x(x0, 0, 0), v = Vec3::Zero();
  for (int n = 1; n <= 1000; ++n)
  {
    plant.step(x, v, Vec3::Zero());
    const double t = n * period_s;
    ASSERT_NEAR(x.x(), x0 * std::exp(-s * t) * (std::cos(w * t) + s / w * std::sin(w * t)), 1e-14);
  }
}

HandPath straightPath(bool loops)
{
  return { { Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.1, 0.1, 0) }, 0.1, loops };
}

TEST(SimulatedHand, IsLedAlongItsPathAtItsSpeedAndBackAgain)
{
  SimulatedHand hand(genericHand(), straightPath(true));
  ASSERT_EQ(hand.open(), "");
  EXPECT_NEAR((hand.target(0.5) - Vec3(0.05, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((hand.target(1.5) - Vec3(0.1, 0.05, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((hand.target(2.5) - Vec3(0.1, 0.05, 0)).norm(), 0.0, 1e-14); // on the way back
  EXPECT_NEAR((hand.target(4.5) - Vec3(0.05, 0, 0)).norm(), 0.0, 1e-14);   // second round
}

TEST(SimulatedHand, StopsAtTheEndOfAPathThatDoesNotLoop)
{
  SimulatedHand hand(genericHand(), straightPath(false));
  ASSERT_EQ(hand.open(), "");
  EXPECT_NEAR((hand.target(100.0) - Vec3(0.1, 0.1, 0)).norm(), 0.0, 1e-15);
}

// Pushed by a constant force the hand rests where its spring balances it: x = F / k beside its target.
TEST(SimulatedHand, YieldsToAForceByForceOverHandStiffness)
{
  HandPath still;
  still.points_D = { Vec3(0.02, 0, 0) };
  SimulatedHand hand(genericHand(), still);
  ASSERT_EQ(hand.open(), "");
  DeviceSample sample;
  DeviceCommand command;
  command.wrench_D.force = { 0, 0, 1.5 };
  for (int n = 1; n <= 5000; ++n)
  {
    ASSERT_EQ(hand.read(n * period_s, sample), DeviceStatus::Ok);
    hand.write(command);
  }
  EXPECT_NEAR(sample.pose_D.p.z(), 1.5 / genericHand().handStiffness_N_per_m, 1e-12);
  EXPECT_NEAR(sample.pose_D.p.x(), 0.02, 1e-12);
}

TEST(SimulatedHand, AMissedTickAdvancesItByTwoPeriods)
{
  SimulatedHand steady(genericHand(), straightPath(true)), jumping(genericHand(), straightPath(true));
  ASSERT_EQ(steady.open() + jumping.open(), "");
  DeviceSample a, b;
  for (int n = 1; n <= 100; ++n)
  {
    static_cast<void>(steady.read(n * period_s, a));
    if (n % 2 == 0)
    {
      static_cast<void>(jumping.read(n * period_s, b));
      ASSERT_EQ((a.pose_D.p - b.pose_D.p).norm(), 0.0);
    }
  }
}

TEST(SimulatedHand, WithoutAUsableStrokeSaysWhatIsMissing)
{
  EXPECT_NE(SimulatedHand(idealHand(), {}).open().find("at least one point"), std::string::npos);
  HandPath bad = straightPath(true);
  bad.speed_m_per_s = 0.0;
  EXPECT_NE(SimulatedHand(idealHand(), bad).open().find("speed"), std::string::npos);
}

TEST(FedDevice, GivesTheLatestPoseWithTheTicksTime)
{
  FedDevice device;
  DeviceSample fed, read;
  fed.pose_D.p = { 1, 2, 3 };
  fed.time_s = 99.0;
  device.feed(fed);
  EXPECT_EQ(device.read(0.5, read), DeviceStatus::Ok);
  EXPECT_EQ(read.pose_D.p, Vec3(1, 2, 3));
  EXPECT_EQ(read.time_s, 0.5);
}

TEST(ReplayDevice, GivesItsSamplesOnceAndEnds)
{
  std::vector<DeviceSample> samples(2);
  samples[1].pose_D.p = { 0, 0, 1 };
  ReplayDevice device(samples);
  ASSERT_EQ(device.open(), "");
  DeviceSample read;
  EXPECT_EQ(device.read(0.001, read), DeviceStatus::Ok);
  EXPECT_EQ(device.read(0.002, read), DeviceStatus::Ok);
  EXPECT_EQ(read.pose_D.p.z(), 1.0);
  EXPECT_EQ(device.read(0.003, read), DeviceStatus::Ended);
}

TEST(DeviceFactory, MakesEveryDeviceItKnowsByName)
{
  for (const KnownDevice& known : knownDevices())
  {
    const MadeDevice made = makeDevice(known.name, {});
    ASSERT_NE(made.device, nullptr) << made.problem;
    EXPECT_EQ(made.device->info().name, known.name);
  }
}

TEST(DeviceFactory, AnUnknownNameIsAnsweredWithTheKnownOnes)
{
  const MadeDevice made = makeDevice("phantom", {});
  EXPECT_EQ(made.device, nullptr);
  EXPECT_NE(made.problem.find("phantom"), std::string::npos);
  for (const KnownDevice& known : knownDevices())
  {
    EXPECT_NE(made.problem.find(known.name), std::string::npos);
  }
}

} // namespace
} // namespace palpate
