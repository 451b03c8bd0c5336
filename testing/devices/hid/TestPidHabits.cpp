// SPDX-License-Identifier: GPL-3.0-or-later
// The engine through a link, against every combination of the firmwares' differences.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using test::ConditionOrder;
using test::PidHabits;
using test::VirtualPidDevice;

constexpr int rampUp_ms = 40;

test::PidLayout layoutWith(const PidHabits& habits)
{
  test::PidLayout layout = test::plainLayout();
  layout.habits = habits;
  layout.slots = 8;
  return layout;
}

struct HabitRig
{
  explicit HabitRig(const PidHabits& habits) : port(bus->plug(layoutWith(habits))), options(test::virtualOptions(*bus))
  {
    this->options.output.rampUp_ms = rampUp_ms;
    this->device.emplace("pid", this->bus, this->port.entry, this->options);
    EXPECT_EQ(this->device->open(), "") << habits.text();
    this->run(10);
  }

  VirtualPidDevice& stick() { return *this->port.device; }

  void run(int duration_ms)
  {
    for (int ms = 0; ms < duration_ms; ++ms)
    {
      this->put();
      static_cast<void>(this->device->read(0.0, this->sample));
      this->device->write(this->command);
      this->pass();
    }
  }
  void pass()
  {
    static_cast<void>(this->device->link().readPass(0));
    if (!this->device->link().writePass())
    {
      this->bus->advance(1);
    }
  }
  /// A hand that does not yield.
  void put()
  {
    this->stick().position = { this->at.x(), -this->at.y() };
    this->stick().velocity = { this->speed.x(), -this->speed.y() };
  }
  /// In D's test::directions [shares].
  Vec3 felt()
  {
    this->put();
    const auto force = this->stick().force();
    return { force[0], -force[1], 0.0 };
  }

  std::shared_ptr<test::FakeHidBus> bus = std::make_shared<test::FakeHidBus>();
  test::FakePort& port;
  PidDeviceOptions options;
  std::optional<PidDevice> device;
  DeviceCommand command;
  DeviceSample sample;
  Vec3 at = Vec3::Zero(), speed = Vec3::Zero();
};

/// The force given for a force asked for: the engine takes angles as where a force comes from, and a self-test finds
/// the rest.
Vec3 through(const PidHabits& habits, const Vec3& asked)
{
  const double sign = habits.pointsTo ? -1.0 : 1.0;
  return { sign * asked.x(), habits.oneMotor ? 0.0 : sign * asked.y(), 0.0 };
}

/// The force of a condition: each axis for itself, whatever an angle means.
Vec3 held(const PidHabits& habits, const Vec3& asked)
{
  return habits.deadConditions ? Vec3(0, 0, 0) : Vec3(asked.x(), habits.oneMotor ? 0.0 : asked.y(), 0.0);
}

TEST(PidHabits, ConstantForcesAreRightToTwoPercentOnEachAxis)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    for (const Vec3& direction : test::directions)
    {
      rig.command.wrench_D.force = 2.0 * direction;
      rig.run(12);
      const Vec3 asked = 2.0 / rig.options.output.scale.maxForce_N * direction;
      ASSERT_LT((rig.felt() - through(habits, asked)).norm(), 0.02 * asked.norm()) << habits.text();
    }
    ASSERT_EQ(rig.stick().badReports, 0) << habits.text();
  }
}

// Believed walls push back from both sides; with dead conditions nothing does, and so a hand finds out.
TEST(PidHabits, HeldWallsAndDampersRestoreWhateverTheOrderOfReports)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    rig.command = test::corridors(rig.options.output.scale, 0.3);
    rig.command.viscosity_Ns_per_m = rig.options.output.scale.damperViscosity_Ns_per_m;
    rig.run(rampUp_ms + 80);
    for (const Vec3& direction : test::directions)
    {
      rig.at = 0.35 * direction;
      rig.speed = Vec3::Zero();
      ASSERT_LT((rig.felt() - held(habits, -0.5 * direction)).norm(), 0.01) << habits.text();
      rig.at = Vec3::Zero();
      rig.speed = 0.1 * direction;
      const double braked = 0.1 * VirtualPidDevice::damperMetric * VirtualPidDevice::springGain;
      ASSERT_LT((rig.felt() - held(habits, -braked * direction)).norm(), 0.01) << habits.text();
    }
  }
}

// Refused ones are forces: they come from the host, with the sign of its forces.
TEST(PidHabits, RefusedWallsAreTheHostsAndARefusedDamperDoesNothing)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    rig.device->trust({});
    rig.command = test::corridors(rig.options.output.scale, 0.3);
    rig.command.viscosity_Ns_per_m = rig.options.output.scale.damperViscosity_Ns_per_m;
    for (const Vec3& direction : test::directions)
    {
      rig.at = 0.35 * direction;
      rig.speed = 0.1 * direction;
      rig.run(12);
      ASSERT_LT((rig.felt() - through(habits, -0.5 * direction)).norm(), 0.02) << habits.text();
    }
  }
}

TEST(PidHabits, ForceEndsWithTheServoAndIsBackWithin20Ms)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    rig.run(40);
    for (int ms = 0; ms < 50; ++ms)
    {
      rig.pass();
      ASSERT_TRUE(ms < 25 || rig.felt() == Vec3::Zero()) << habits.text() << ms;
    }
    rig.run(20);
    const Vec3 asked(2.0 / rig.options.output.scale.maxForce_N, 0.0, 0.0);
    ASSERT_LT((rig.felt() - through(habits, asked)).norm(), 0.02 * asked.norm()) << habits.text();
  }
}

TEST(PidHabits, ADeadProgramLeavesNoForceAfterAQuarterSecondNorBehindTheTrigger)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    rig.command = test::corridors(rig.options.output.scale, 0.3);
    rig.command.wrench_D.force = { 2.0, 2.0, 0.0 };
    rig.run(60);
    rig.bus->advance(250);
    rig.at = { 0.5, 0.5, 0.0 };
    ASSERT_EQ(rig.felt(), Vec3::Zero()) << habits.text();
    rig.stick().buttons = 0xFF;
    for (int ms = 0; ms < 20; ++ms)
    {
      rig.bus->advance(1);
      ASSERT_EQ(rig.felt(), Vec3::Zero()) << habits.text();
    }
  }
}

// Its own spring to the centre is back then.
TEST(PidHabits, ClosingLeavesNothingButWhatTheDeviceDoesWhenItIsPluggedIn)
{
  for (const PidHabits& habits : test::allHabits())
  {
    HabitRig rig(habits);
    ASSERT_FALSE(rig.stick().centring()) << habits.text();
    rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    rig.run(30);
    rig.device->close();
    ASSERT_EQ(rig.felt(), Vec3::Zero()) << habits.text();
    ASSERT_EQ(rig.stick().centring(), habits.wakesCentred) << habits.text();
    ASSERT_EQ(rig.stick().effectsUsed(), 0) << habits.text();
  }
}

} // namespace
} // namespace palpate
