// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "testing/devices/calibration/MiswiredDevice.h"

namespace palpate::test
{

inline constexpr double period_s = 1e-3;
inline constexpr int longest_ticks = 200'000;

/// Who holds the device: goes where it is asked to at the pace of a hand, or does something of its own.
using Person = std::function<Vec3(const Vec3& asked_D, double time_s, const SelfTestState& state)>;

inline Vec3 obliging(const Vec3& asked_D, double, const SelfTestState&)
{
  return asked_D;
}

struct SelfTested
{
  SelfTestPlan plan;
  SelfTestState state;
  DeviceInfo device;
  double largest_N = 0.0;
  double longestPush_s = 0.0;
  Vec3 atEnd_N = Vec3::Zero(); ///< the command with the verdict

  [[nodiscard]] Calibration calibration() const
  {
    return calibrationFrom(this->plan, this->state, this->device, "2026-01-31").value_or(Calibration{});
  }
  [[nodiscard]] std::string text() const { return resultOf(this->plan, this->state); }
};

/// Changes the device's own description before the test is planned.
struct Says
{
  bool wheel = false;
  double effectsEndAfter_s = 0.0;
  bool knowsAxes = false;
};

inline SelfTested run(const DeviceModel& model, const std::string& hand, const Wiring& wiring,
  const Person& person = obliging,
  const std::function<void(int tick, DeviceSample& sample, SelfTestState& state)>& meddle = {}, const Says& says = {})
{
  constexpr double pace_m_per_s = 0.1;
  MiswiredDevice device(model, *handModel(hand), wiring);
  EXPECT_EQ(device.open(), "");
  DeviceInfo info = device.info();
  info.effectsEndAfter_s = says.effectsEndAfter_s;
  info.knowsAxes = says.knowsAxes;
  SelfTested outcome{ SelfTestPlan::forDevice(info, {}, says.wheel), {}, info };
  Vec3 hand_D = Vec3::Zero();
  double push_s = 0.0;
  for (int tick = 1; tick < longest_ticks && outcome.state.verdict == SelfTestVerdict::None; ++tick)
  {
    const Vec3 way_D = person(askedPlace_D(outcome.plan, outcome.state), tick * period_s, outcome.state) - hand_D;
    hand_D += way_D * std::min(1.0, pace_m_per_s * period_s / std::max(way_D.norm(), 1e-12));
    device.lead(hand_D);
    DeviceSample sample;
    const DeviceStatus status = device.read(tick * period_s, sample);
    if (meddle)
    {
      meddle(tick, sample, outcome.state);
    }
    const DeviceCommand command = stepSelfTest(outcome.plan, sample, status, period_s, outcome.state);
    device.write(command);
    const double force_N = command.wrench_D.force.norm();
    outcome.largest_N = std::max(outcome.largest_N, force_N);
    push_s = force_N > 0.0 ? push_s + period_s : 0.0;
    outcome.longestPush_s = std::max(outcome.longestPush_s, push_s);
    outcome.atEnd_N = command.wrench_D.force;
  }
  return outcome;
}

/// How far, as a share, the slope of a push is off at most that is seen in steps. Least squares take the part of the
/// path s above its first quarter: a step's rounding takes step^3 / 12 from the s^3 / 12 of the sum of squares, the
/// part of a step at either end step^2 s / 16. Friction shortens the path.
inline double roundingError(const PushPair& pushes, std::size_t axis, double step_m)
{
  const double way_m = 0.75 * std::min(std::fabs(pushes[0][axis].moved_m), std::fabs(pushes[1][axis].moved_m));
  return 2.5 * (step_m / way_m) * (step_m / way_m);
}

/// How far, as a share, a strength k f h / (f - h) is off at most: the slopes f = 1 / K and h = 1 / (K + k) of a hand
/// of stiffness K without and with a spring k have errors of their own, each of which counts by its logarithmic
/// derivative.
inline double strengthError(const SelfTested& found, std::size_t axis, double step_m, double hand_N_per_m)
{
  const MotorAnswers& seen = found.state.motors[axis];
  const double ratio = hand_N_per_m / wallStiffness_N_per_m(found.plan, found.state, static_cast<int>(axis));
  return ratio * roundingError(seen.free[0], axis, step_m) + (1.0 + ratio) * roundingError(seen.walls[0], axis, step_m);
}

inline const DeviceModel& joystick()
{
  return *deviceModel("simulated-joystick");
}

inline Mat3 swapped()
{
  Mat3 m;
  m << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  return m;
}

/// A joystick fine enough that the result shows its walls, not its steps or its friction.
inline DeviceModel fineJoystick()
{
  DeviceModel fine = joystick();
  fine.friction_N = 0.0;
  fine.encoderStep_m = 1e-6;
  return fine;
}

} // namespace palpate::test
