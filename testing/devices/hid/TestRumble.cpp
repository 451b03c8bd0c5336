// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/hid/Rumble.h"
#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

constexpr std::int64_t ms_ns = 1000000;
constexpr RumbleOptions defaults;

DeviceCommand pushing(const Vec3& force_D)
{
  DeviceCommand command;
  command.wrench_D.force = force_D;
  return command;
}

/// A hand that slides at a velocity [m/s] under a force [N], a millisecond at a time.
struct Stroke
{
  Vibration run(int duration_ms, const Vec3& force_D, const Vec3& velocity_D)
  {
    for (int i = 0; i < duration_ms; ++i)
    {
      ++this->now_ms;
      this->p_D += 1e-3 * velocity_D;
      this->last = this->rumble.next(this->now_ms * ms_ns, pushing(force_D), this->p_D);
    }
    return this->last;
  }

  Rumble rumble{ defaults };
  int now_ms = 0;
  Vec3 p_D = Vec3::Zero();
  Vibration last;
};

TEST(Rumble, ContactIsAPulseOfFortyMillisecondsAndAHandAtRestFeelsNothingAfterIt)
{
  Stroke stroke;
  EXPECT_EQ(stroke.run(100, Vec3::Zero(), Vec3::Zero()).share, 0.0);
  EXPECT_EQ(stroke.run(1, Vec3::UnitZ(), Vec3::Zero()).share, defaults.largestShare);
  EXPECT_EQ(stroke.run(39, Vec3::UnitZ(), Vec3::Zero()).share, defaults.largestShare);
  EXPECT_EQ(stroke.run(1, Vec3::UnitZ(), Vec3::Zero()).share, 0.0);
  EXPECT_EQ(stroke.run(1000, Vec3::UnitZ(), Vec3::Zero()).share, 0.0);
}

TEST(Rumble, SlidingShakesWithTheForceAndTheSpeedAcrossItOnly)
{
  Stroke stroke;
  const double pressed = 1.0 / defaults.maxForce_N;
  static_cast<void>(stroke.run(100, Vec3::UnitZ(), Vec3::Zero()));
  EXPECT_NEAR(stroke.run(100, Vec3::UnitZ(), { 0.05, 0.0, 0.0 }).share, 0.5 * pressed, 1e-12);
  EXPECT_NEAR(stroke.run(100, 2.0 * Vec3::UnitZ(), { 0.05, 0.0, 0.0 }).share, pressed, 1e-12);
  EXPECT_NEAR(stroke.run(100, Vec3::UnitZ(), { 0.3, 0.0, 0.0 }).share, pressed, 1e-12); // no faster than full
  EXPECT_NEAR(stroke.run(100, Vec3::UnitZ(), { 0.0, 0.0, 0.05 }).share, 0.0, 1e-12);    // along the force
  EXPECT_NEAR(stroke.run(100, 9.0 * Vec3::UnitZ(), { 0.3, 0.0, 0.0 }).share, defaults.largestShare, 1e-12);
}

TEST(Rumble, InFreeAirNothingShakes)
{
  Stroke stroke;
  EXPECT_EQ(stroke.run(100, Vec3::Zero(), { 0.3, 0.0, 0.0 }).share, 0.0);
  static_cast<void>(stroke.run(10, Vec3::UnitZ(), Vec3::Zero()));
  EXPECT_EQ(stroke.run(1, Vec3::Zero(), Vec3::Zero()).share, 0.0); // in the middle of the pulse
}

TEST(Rumble, AForceThatFlickersAboutTheLimitIsOneContact)
{
  Stroke stroke;
  int strong = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double share = i % 2 == 0 ? 0.021 : 0.011; // the limits are 0.02 and 0.01
    strong += stroke.run(1, share * defaults.maxForce_N * Vec3::UnitZ(), Vec3::Zero()).share > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(strong, 40);
}

TEST(Rumble, ASignalOfTheCommandIsAShakeOnce)
{
  Rumble rumble(defaults);
  DeviceCommand command;
  const auto shaken = [&](Signal signal, int from_ms, int duration_ms = 500)
  {
    command.signal = signal;
    int count = 0;
    for (int i = 0; i < duration_ms; ++i)
    {
      count += rumble.next((from_ms + i) * ms_ns, command, Vec3::Zero()).share > 0.0 ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(shaken(Signal::Oscillation, 0), 200);
  EXPECT_EQ(shaken(Signal::None, 1000), 0);
  EXPECT_EQ(shaken(Signal::Oscillation, 2000), 200);
  EXPECT_EQ(shaken(Signal::None, 3000), 0);
  EXPECT_EQ(shaken(Signal::Oscillation, 4000, 50), 50);
  EXPECT_EQ(shaken(Signal::None, 4050), 0) << "who lets go is not shaken after that";
}

/// The strongest vibration of a pad within so many milliseconds, while its stick is led along x [shares a second].
double strongest(test::PidRig& rig, int duration_ms, double speed)
{
  double most = 0.0;
  for (int i = 0; i < duration_ms; ++i)
  {
    rig.stick().position[0] += 1e-3 * speed;
    rig.stick().velocity = {};
    const double at = rig.stick().position[0];
    rig.run(1);
    rig.stick().position[0] = at; // the pad's motor moves no stick
    most = std::max(most, std::fabs(rig.stick().force()[0]));
  }
  return most;
}

TEST(Rumble, APadFeelsContactAsAPulseAndSlidingAsVibrationThatIsArmedAgainAndAgain)
{
  test::PidRig rig(test::rumbleLayout());
  ASSERT_EQ(rig.device.open(), "");
  EXPECT_EQ(rig.device.info().deviceClass, DeviceClass::Vibration0D);
  EXPECT_EQ(rig.stick().effectsUsed(), 1);
  rig.stick().position[0] = -0.9;
  EXPECT_EQ(strongest(rig, 100, 0.0), 0.0);
  rig.command = pushing({ 0.0, 0.0, 2.0 });
  EXPECT_NEAR(strongest(rig, 40, 0.0), 0.6, 0.01); // a quarter of a period of 40 ms is on a millisecond
  EXPECT_GT(rig.device.linkReport().outputs, 0U);
  static_cast<void>(strongest(rig, 100, 0.0));
  EXPECT_EQ(rig.stick().effectsPlaying(), 0); // at rest it is still
  // Half travels of 50 mm a second, full at 0.1 m/s: half. Sampled at tenths of a period, whose largest sine is that of
  // 72 degrees.
  const double share = 0.5 * 2.0 / rig.scale().maxForce_N * std::sin(0.4 * std::numbers::pi);
  // The speed is that of 16 ms or more, of which a report of 1 ms more or less may have come; a change by less than 1 %
  // of the largest force is not sent.
  const double off = share / 16.0 + 0.01;
  EXPECT_NEAR(strongest(rig, 100, 1.0), share, off);
  const std::uint64_t restarts = rig.device.linkReport().restarts;
  EXPECT_NEAR(strongest(rig, 400, 1.0), share, off); // longer than the effect lasts by itself
  EXPECT_NEAR(static_cast<double>(rig.device.linkReport().restarts - restarts), 4.0, 1.0); // every 100 ms
  EXPECT_EQ(rig.stick().badReports, 0);
  EXPECT_EQ(rig.stick().constantForces, 0);
}

TEST(Rumble, APadThatNobodyTellsAnythingAnyMoreIsStill)
{
  test::PidRig silent(test::rumbleLayout());
  ASSERT_EQ(silent.device.open(), "");
  silent.command = pushing({ 0.0, 0.0, 2.0 });
  EXPECT_GT(strongest(silent, 20, 1.0), 0.0);
  for (int ms = 0; ms < 60; ++ms)
  {
    silent.pass();
  }
  EXPECT_EQ(silent.stick().effectsPlaying(), 0);
  test::PidRig dead(test::rumbleLayout());
  ASSERT_EQ(dead.device.open(), "");
  dead.command = pushing({ 0.0, 0.0, 2.0 });
  EXPECT_GT(strongest(dead, 20, 1.0), 0.0);
  dead.bus->advance(250);
  EXPECT_EQ(dead.stick().effectsPlaying(), 0);
}

TEST(Rumble, APadWithoutPeriodicEffectsBuzzesWithConstantOnes)
{
  test::PidRig rig(test::buzzerLayout());
  ASSERT_EQ(rig.device.open(), "");
  rig.command = pushing({ 0.0, 0.0, 2.0 });
  EXPECT_NEAR(strongest(rig, 40, 0.0), 0.6, 0.01);
  static_cast<void>(strongest(rig, 100, 0.0));
  EXPECT_EQ(rig.stick().force()[0], 0.0);
  EXPECT_EQ(rig.stick().badReports, 0);
}

} // namespace
} // namespace palpate
