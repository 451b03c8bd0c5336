// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/ReplayDevice.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/LinearPlant.h"
#include "testing/support/AllocationGuard.h"

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

SimulatedDevice genericHand(const HandPath& path, const SimulationOptions& options = {})
{
  return { *deviceModel("simulated-generic"), *handModel("stylus"), path, options };
}

HandPath straightPath(bool loops)
{
  return { { Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.1, 0.1, 0) }, 0.1, loops };
}

TEST(SimulatedDevice, IsLedAlongItsPathAtItsSpeedAndBackAgain)
{
  SimulatedDevice hand = genericHand(straightPath(true));
  ASSERT_EQ(hand.open(), "");
  EXPECT_NEAR((hand.target(0.5) - Vec3(0.05, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((hand.target(1.5) - Vec3(0.1, 0.05, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((hand.target(2.5) - Vec3(0.1, 0.05, 0)).norm(), 0.0, 1e-14); // on the way back
  EXPECT_NEAR((hand.target(4.5) - Vec3(0.05, 0, 0)).norm(), 0.0, 1e-14);   // second round
}

TEST(SimulatedDevice, StopsAtTheEndOfAPathThatDoesNotLoop)
{
  SimulatedDevice hand = genericHand(straightPath(false));
  ASSERT_EQ(hand.open(), "");
  EXPECT_NEAR((hand.target(100.0) - Vec3(0.1, 0.1, 0)).norm(), 0.0, 1e-15);
}

// Pushed by a constant force the hand rests where its spring balances it: x = F / k beside its target.
TEST(SimulatedDevice, YieldsToAForceByForceOverHandStiffness)
{
  HandPath still;
  still.points_D = { Vec3(0.02, 0, 0) };
  SimulatedDevice hand = genericHand(still);
  ASSERT_EQ(hand.open(), "");
  DeviceSample sample;
  DeviceCommand command;
  command.wrench_D.force = { 0, 0, 1.5 };
  for (int n = 1; n <= 5000; ++n)
  {
    ASSERT_EQ(hand.read(n * period_s, sample), DeviceStatus::Ok);
    hand.write(command);
  }
  EXPECT_NEAR(sample.pose_D.p.z(), 1.5 / handModel("stylus")->stiffness_N_per_m, 1e-12);
  EXPECT_NEAR(sample.pose_D.p.x(), 0.02, 1e-12);
}

TEST(SimulatedDevice, AMissedTickAdvancesItByTwoPeriods)
{
  SimulatedDevice steady = genericHand(straightPath(true)), jumping = genericHand(straightPath(true));
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

TEST(SimulatedDevice, WithoutAUsableStrokeSaysWhatIsMissing)
{
  EXPECT_NE(genericHand({}).open().find("at least one point"), std::string::npos);
  HandPath bad = straightPath(true);
  bad.speed_m_per_s = 0.0;
  EXPECT_NE(genericHand(bad).open().find("speed"), std::string::npos);
}

/// A device nobody holds, at the origin, with a start velocity and a constant push.
SimulatedDevice freeDevice(const DeviceModel& model, const SimulationOptions& options, const Vec3& start = Vec3::Zero())
{
  return { model, *handModel("none"), { { start } }, options };
}

/// Reads up to a time and returns the last sample.
DeviceSample readUpTo(SimulatedDevice& device, double time_s, double period)
{
  DeviceSample sample;
  for (int n = 1; n <= static_cast<int>(time_s / period + 0.5); ++n)
  {
    EXPECT_EQ(device.read(n * period, sample), DeviceStatus::Ok);
  }
  return sample;
}

TEST(SimulatedDevice, EveryModelPushedWithoutFrictionFollowsItsClosedForm)
{
  for (DeviceModel model : deviceModels())
  {
    model.friction_N = model.encoderStep_m = 0.0;
    model.travel_m = DeviceModel::unlimited;
    SimulationOptions options;
    options.push_D = { 0.05, 0, 0 };
    options.velocity_D = { 0.1, 0, 0 };
    SimulatedDevice device = freeDevice(model, options);
    ASSERT_EQ(device.open(), "");
    const double t = 0.4, m = model.mass_kg, b = model.damping_Ns_per_m;
    const double x = readUpTo(device, t, options.period_s).pose_D.p.x();
    const double vi = b > 0.0 ? 0.05 / b : 0.0, e = std::exp(-b * t / m);
    const double expected = b > 0.0 ? vi * t + (0.1 - vi) * m / b * (1 - e) : 0.1 * t + 0.5 * 0.05 / m * t * t;
    EXPECT_NEAR(x, expected, 1e-11) << model.name;
  }
}

TEST(SimulatedDevice, FrictionAloneStopsAMassAfterItsWayAndNeverTurnsItRound)
{
  DeviceModel model = *deviceModel("simulated-ideal");
  model.friction_N = 0.2;
  for (const double period : { 1.0 / 20, 1e-3, 1.0 / 8000 })
  {
    SimulationOptions options;
    options.period_s = period;
    options.velocity_D = { 0.3, 0, 0 };
    SimulatedDevice device = freeDevice(model, options);
    ASSERT_EQ(device.open(), "");
    const double way = model.mass_kg * 0.3 * 0.3 / (2 * model.friction_N);
    const double x = readUpTo(device, 1.0, period).pose_D.p.x();
    EXPECT_NEAR(x, way, 1e-9) << period; // the stop is found to 2^-20 ms
    EXPECT_EQ(readUpTo(device, 2.0, period).pose_D.p.x(), x);
    EXPECT_EQ(device.speed_D().x(), 0.0);
  }
}

TEST(SimulatedDevice, FrictionHoldsWhatPullsLessForEverAndLetsGoWhatPullsMore)
{
  DeviceModel model = *deviceModel("simulated-ideal");
  model.friction_N = 0.3;
  for (const double push : { 0.299, 0.3, 0.35 })
  {
    SimulationOptions options;
    options.push_D = { push, 0, 0 };
    SimulatedDevice device = freeDevice(model, options);
    ASSERT_EQ(device.open(), "");
    const double t = 0.5, x = readUpTo(device, t, options.period_s).pose_D.p.x();
    const double expected = push > 0.3 ? 0.5 * (push - 0.3) / model.mass_kg * t * t : 0.0;
    EXPECT_NEAR(x, expected, 1e-9) << push;
  }
}

TEST(SimulatedDevice, OnTheHandsSpringFrictionLeavesItWithinItsDeadBand)
{
  DeviceModel model = *deviceModel("simulated-ideal");
  model.friction_N = 0.25;
  SimulationOptions options;
  options.velocity_D = { 0.5, 0, 0 };
  SimulatedDevice device(model, *handModel("stylus"), { { Vec3::Zero() } }, options);
  ASSERT_EQ(device.open(), "");
  const double x = readUpTo(device, 3.0, options.period_s).pose_D.p.x();
  EXPECT_LE(std::abs(x), model.friction_N / handModel("stylus")->stiffness_N_per_m);
  EXPECT_EQ(device.speed_D().x(), 0.0);
}

TEST(SimulatedDevice, ShowsWholeEncoderStepsBelowWhereItIs)
{
  DeviceModel model = *deviceModel("simulated-touch");
  model.friction_N = 0.0;
  SimulationOptions options;
  options.velocity_D = { 0.1, -0.2, 0.05 };
  SimulatedDevice device = freeDevice(model, options);
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  for (int n = 1; n <= 200; ++n)
  {
    static_cast<void>(device.read(n * period_s, sample));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double steps = sample.pose_D.p[axis] / model.encoderStep_m;
      EXPECT_NEAR(steps, std::round(steps), 1e-9);
      const double behind = device.position_D()[axis] - sample.pose_D.p[axis];
      EXPECT_GE(behind, -1e-15);
      EXPECT_LT(behind, model.encoderStep_m);
    }
    EXPECT_EQ(sample.velocity_D.linear, Vec3::Zero()); // an encoder shows none
  }
}

TEST(SimulatedDevice, WithoutTorqueIgnoresATorqueAndAPoseTarget)
{
  for (const DeviceModel& model : deviceModels())
  {
    SimulatedDevice plain = freeDevice(model, {}), told = freeDevice(model, {});
    ASSERT_EQ(plain.open() + told.open(), "");
    EXPECT_EQ(plain.info().rendersTorque, model.turns()) << model.name;
    DeviceCommand command;
    command.wrench_D.force = { 0.1, 0, 0 };
    DeviceCommand more = command;
    more.wrench_D.torque = { 0, 0, model.turns() ? 0.0 : 1.0 };
    more.target = { { Vec3(1, 1, 1), Quat(0, 1, 0, 0) }, 1000.0 };
    DeviceSample sample, other;
    for (int n = 0; n <= 40; ++n)
    {
      ASSERT_EQ(plain.read(n * period_s, sample), told.read(n * period_s, other));
      EXPECT_EQ(sample.pose_D.p, other.pose_D.p) << model.name;
      EXPECT_EQ(sample.pose_D.q.coeffs(), other.pose_D.q.coeffs()) << model.name;
      plain.write(command);
      told.write(more);
    }
  }
}

TEST(SimulatedDevice, ACommandTakesEffectItsDelayLate)
{
  for (const int delay : { 0, 1, 3, 16 })
  {
    SimulationOptions options;
    options.delay_ticks = delay;
    SimulatedDevice device = freeDevice(*deviceModel("simulated-ideal"), options);
    ASSERT_EQ(device.open(), "");
    DeviceSample sample;
    DeviceCommand command;
    command.wrench_D.force = { 1.0, 0, 0 };
    for (int n = 0; n <= 40; ++n)
    {
      static_cast<void>(device.read(n * period_s, sample));
      device.write(command);
      // Written at 0, felt from the period after `delay` others on.
      const double t = std::max(0, n - delay) * period_s;
      EXPECT_NEAR(sample.pose_D.p.x(), 0.5 * 10.0 * t * t, 1e-15) << delay << ", tick " << n;
    }
  }
}

TEST(SimulatedDevice, GivesNoMoreThanItsLargestForceInAnyDirection)
{
  DeviceModel model = *deviceModel("simulated-touch");
  model.friction_N = model.damping_Ns_per_m = model.encoderStep_m = 0.0;
  SimulatedDevice device = freeDevice(model, {});
  ASSERT_EQ(device.open(), "");
  DeviceCommand command;
  command.wrench_D.force = { 30, -40, 0 };
  device.write(command);
  DeviceSample sample;
  static_cast<void>(device.read(period_s, sample));
  const Vec3 force = model.mass_kg * sample.velocity_D.linear / period_s;
  EXPECT_NEAR(force.norm(), 3.3, 1e-12);
  EXPECT_NEAR(force.normalized().dot(Vec3(0.6, -0.8, 0)), 1.0, 1e-12);
}

TEST(SimulatedDevice, TheJoystickStaysInItsPlaneAndStopsAtItsTravel)
{
  SimulationOptions options;
  options.push_D = { 3.0, -3.0, 3.0 };
  const DeviceModel& model = *deviceModel("simulated-joystick");
  SimulatedDevice device = freeDevice(model, options);
  ASSERT_EQ(device.open(), "");
  EXPECT_EQ(device.info().deviceClass, DeviceClass::Joystick2D);
  static_cast<void>(readUpTo(device, 2.0, options.period_s));
  EXPECT_EQ(device.position_D(), Vec3(0.05, -0.05, 0.0));
  EXPECT_EQ(device.speed_D(), Vec3(0, 0, 0));
}

TEST(SimulatedDevice, AForceOutOfTheJoysticksPlaneTakesNothingFromItsLargestForce)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.friction_N = model.damping_Ns_per_m = model.encoderStep_m = 0.0;
  SimulatedDevice device = freeDevice(model, {});
  ASSERT_EQ(device.open(), "");
  DeviceCommand command;
  command.wrench_D.force = { 3.0, 4.0, 100.0 }; // 5 N in the plane, all it can
  device.write(command);
  DeviceSample sample;
  static_cast<void>(device.read(period_s, sample));
  const Vec3 force = model.mass_kg * sample.velocity_D.linear / period_s;
  EXPECT_NEAR((force - Vec3(3.0, 4.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(DeviceModels, SayWhichNumbersAreListedAndWhichAssumed)
{
  for (const DeviceModel& model : deviceModels())
  {
    const DeviceInfo info = infoOf(model);
    const bool invented = model.id == "D0" || model.id == "D1";
    EXPECT_EQ(info.mass_kg.known, invented) << model.name;
    EXPECT_EQ(info.friction_N.known, invented) << model.name;
    EXPECT_EQ(info.resolution_m.known, invented) << model.name;
    const bool joystick = model.id == "D6" || model.id == "D8";
    EXPECT_EQ(info.maxForce_N.known, !joystick) << model.name;
    EXPECT_EQ(info.maxStiffness_N_per_m.known, !joystick) << model.name;
    EXPECT_EQ(info.maxDamping_Ns_per_m.known, invented || std::isfinite(model.maxDamping_Ns_per_m)) << model.name;
  }
}

TEST(SimulatedDevice, TheJoystickHoldsAWallThatItsHostCouldNotAtAnyHostRate)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.friction_N = model.encoderStep_m = 0.0;
  const double K = 200.0, push = 1.0;
  for (const double rate : { 20.0, 125.0, 1000.0 })
  {
    SimulationOptions options;
    options.period_s = 1.0 / rate;
    options.push_D = { -push, 0, 0 };
    SimulatedDevice held = freeDevice(model, options), spring = freeDevice(model, options);
    ASSERT_EQ(held.open() + spring.open(), "");
    DeviceCommand wall;
    wall.wallCount = 1;
    wall.walls[0] = { Vec3::UnitX(), 0.0, K };
    DeviceSample sample;
    double swing = 0.0;
    for (int n = 1; n <= static_cast<int>(3.0 * rate); ++n)
    {
      static_cast<void>(held.read(n * options.period_s, sample));
      held.write(wall);
      static_cast<void>(spring.read(n * options.period_s, sample));
      DeviceCommand force;
      force.wrench_D.force.x() = std::max(0.0, -K * sample.pose_D.p.x());
      spring.write(force);
      swing = n > 2.5 * rate ? std::max(swing, std::abs(sample.pose_D.p.x() + push / K)) : swing;
    }
    EXPECT_NEAR(held.position_D().x(), -push / K, 1e-6) << rate; // at rest where the spring balances the push
    // The same spring closed by the host holds only up to 2 b / T: 20 N/m at 20 Hz, 125 N/m at 125 Hz.
    EXPECT_EQ(swing > 1e-3, K > 2 * model.damping_Ns_per_m * rate) << rate;
  }
}

TEST(SimulatedDevice, AnyPeriodGivesTheSameMotionUnderAConstantForce)
{
  DeviceModel model = *deviceModel("simulated-falcon");
  model.encoderStep_m = 0.0;
  double first = 0.0;
  for (const double rate : { 20.0, 100.0, 1000.0, 8000.0 })
  {
    SimulationOptions options;
    options.period_s = 1.0 / rate;
    options.push_D = { 1.0, 0, 0 };
    options.velocity_D = { -0.2, 0, 0 };
    SimulatedDevice device = freeDevice(model, options);
    ASSERT_EQ(device.open(), "");
    const double x = readUpTo(device, 0.5, options.period_s).pose_D.p.x();
    first = rate == 20.0 ? x : first;
    EXPECT_NEAR(x, first, 1e-9) << rate;
  }
}

TEST(SimulatedDevice, ReadsAndWritesWithoutAllocating)
{
  SimulatedDevice device(*deviceModel("simulated-falcon"), *handModel("firm"), straightPath(true), {});
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  DeviceCommand command;
  command.wrench_D.force = { 0, 0, 2 };
  const test::AllocationGuard guard;
  for (int n = 1; n <= 1000; ++n)
  {
    static_cast<void>(device.read(n * period_s, sample));
    device.write(command);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(SimulatedDevice, RefusesADelayItCannotHold)
{
  SimulationOptions options;
  options.delay_ticks = 17;
  EXPECT_NE(genericHand(straightPath(true), options).open().find("0 to 16 ticks"), std::string::npos);
}

TEST(DeviceFactory, AnUnknownHandIsAnsweredWithTheKnownOnes)
{
  DeviceOptions options;
  options.hand = "third";
  const MadeDevice made = makeDevice("simulated-touch", options);
  EXPECT_EQ(made.device, nullptr);
  for (const HandModel& known : handModels())
  {
    EXPECT_NE(made.problem.find(known.name), std::string::npos) << known.name;
  }
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
