// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestFindings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate
{
namespace
{

constexpr double weakest = 1.0 / 3.0; // of the strongest motor's response
constexpr double shortest = 0.5;      // of the range that was assumed
constexpr const char* axisNames = "xyz";

const PushAnswer& along(const std::array<std::array<PushAnswer, 3>, 2>& answers, int direction, int axis)
{
  return answers[static_cast<std::size_t>(direction)][static_cast<std::size_t>(axis)];
}

int movedMost(const SelfTestPlan& plan, const MotorAnswers& answers)
{
  int most = 0;
  double most_m = -1.0;
  for (int axis = 0; axis < plan.axes; ++axis)
  {
    const double apart_m = std::fabs(along(answers.free, 0, axis).moved_m - along(answers.free, 1, axis).moved_m);
    if (apart_m > most_m)
    {
      most = axis;
      most_m = apart_m;
    }
  }
  return most;
}

/// Both ways alike, not before the force, and nothing else with it.
bool isClear(const SelfTestPlan& plan, const MotorAnswers& answers, int axis, double least_m)
{
  constexpr double alike = 4.0, aside = 0.5, before = 0.25;
  const double up_m = along(answers.free, 0, axis).moved_m, down_m = along(answers.free, 1, axis).moved_m;
  const double smaller_m = std::min(std::fabs(up_m), std::fabs(down_m));
  const double larger_m = std::max(std::fabs(up_m), std::fabs(down_m));
  if ((up_m > 0.0) == (down_m > 0.0) || smaller_m < least_m || larger_m > alike * smaller_m)
  {
    return false;
  }
  for (int direction = 0; direction < 2; ++direction)
  {
    const double way_m = std::fabs(along(answers.free, direction, axis).moved_m);
    if (along(answers.free, direction, axis).early_m > std::max(least_m, before * way_m))
    {
      return false;
    }
    for (int other = 0; other < plan.axes; ++other)
    {
      if (other != axis && std::fabs(along(answers.free, direction, other).moved_m) > aside * way_m + least_m)
      {
        return false;
      }
    }
  }
  return true;
}

double meanResponse(const std::array<std::array<PushAnswer, 3>, 2>& answers, int axis)
{
  return 0.5 * std::fabs(along(answers, 0, axis).response_m_per_N + along(answers, 1, axis).response_m_per_N);
}

/// A resting hand of stiffness K gives way by s / K per N that is asked for, and by s / (K + k) with the device's
/// spring k beside it: two equations for the strength s and for K.
double strengthOf(const SelfTestPlan& plan, const MotorAnswers& answers, int axis)
{
  constexpr double steps = 5.0, leastDifference = 0.1;
  const double free = meanResponse(answers.free, axis), held = meanResponse(answers.held, axis);
  const double way_m =
    std::min(std::fabs(along(answers.held, 0, axis).moved_m), std::fabs(along(answers.held, 1, axis).moved_m));
  if (!plan.holdsWalls || way_m < steps * plan.resolution_m || !(free - held > leastDifference * free) || !(held > 0.0))
  {
    return 0.0;
  }
  return plan.spring_N_per_m * free * held / (free - held);
}

std::string text(const char* format, double value)
{
  std::array<char, 64> line{};
  std::snprintf(line.data(), line.size(), format, value);
  return line.data();
}

std::string endName(const SelfTestPlan& plan, const SelfTestState& state)
{
  if (state.axis == 0)
  {
    return state.up ? "to the right" : "to the left";
  }
  if (state.axis == 1 && plan.axes == 2)
  {
    return state.up ? "away from you" : "towards you";
  }
  if (state.axis == 1)
  {
    return state.up ? "up" : "down";
  }
  return state.up ? "towards you" : "away from you";
}

const char* because(SelfTestReason reason)
{
  switch (reason)
  {
    case SelfTestReason::None:
      return "";
    case SelfTestReason::NeverStill:
      return "the hand moves by itself: let it rest on the device, and try again";
    case SelfTestReason::NotMoved:
      return "it was not moved to the end that was asked for, or that axis is not measured";
    case SelfTestReason::NotAlongAxis:
      return "two ends of one axis did not lie along one axis of the device: move it straight from end to end";
    case SelfTestReason::NotInMiddle:
      return "it was not brought back to the middle";
    case SelfTestReason::PushUnclear:
      return "the hand did something else than the pushes: let it rest, hold the device loosely, and try again";
    case SelfTestReason::NoMotion:
      return "a motor moves nothing";
    case SelfTestReason::TooFar:
      return "a gentle push moved it too far: rest a hand on it; if one did, the device may push the wrong way";
    case SelfTestReason::TooFast:
      return "it moved faster than a gentle push can: rest a hand on it";
    case SelfTestReason::NotFinite:
      return "the device gave a position that is no number";
    case SelfTestReason::Lost:
      return "the device does not answer any more: is it plugged in?";
    case SelfTestReason::Late:
      return "the computer was too busy to push gently: close other programs, and try again";
    case SelfTestReason::LetGo:
      return "what must be held was let go";
    case SelfTestReason::Stopped:
      return "it was stopped";
    case SelfTestReason::Silent:
      return "the device has not said where the hand is: move it until it does, and try again";
  }
  return "";
}

std::string axisLine(const SelfTestPlan& plan, const SelfTestState& state, int axis)
{
  const AxisFinding found = findAxis(plan, state, axis);
  const double range_m = found.high_m - found.low_m;
  std::string line = std::string(1, axisNames[axis]) + ": " + text("%.3g mm", 1e3 * range_m);
  if (plan.resolution_m > 0.0)
  {
    line += text(", %.0f steps", range_m / plan.resolution_m);
  }
  if (range_m < shortest * 2.0 * plan.radius_m)
  {
    line += text(", less than half of the %.3g mm it was said to have", 2e3 * plan.radius_m);
  }
  if (found.sensor != axis)
  {
    line += std::string(", measured by the driver's ") + axisNames[found.sensor];
  }
  return line + (found.sign < 0 ? ", counted the other way" : "");
}

std::string motorLine(const SelfTestPlan& plan, const SelfTestState& state, int motor, double strongest)
{
  const MotorFinding found = findMotor(plan, state, motor);
  std::string line = std::string("motor ") + axisNames[motor] + ": ";
  if (found.motion != MotorMotion::Clear)
  {
    return line + text("moves nothing when it is asked for %.2g N", plan.push_N);
  }
  line += std::string("moves the driver's ") + axisNames[found.sensor] +
          text(" by %.2g mm per N", 1e3 * found.response_m_per_N);
  line += found.sign < 0 ? ", the other way" : "";
  line += found.response_m_per_N < weakest * strongest ? ", weak beside the strongest" : "";
  return line + (found.strength > 0.0 ? text(", %.2f of what its own spring gives", found.strength) : "");
}

} // namespace

double leastMotion_m(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  return std::max({ 3.0 * plan.resolution_m, 2.0 * state.noise_m, 1e-4 * plan.radius_m });
}

AxisFinding findAxis(const SelfTestPlan& plan, const SelfTestState& state, int axis) noexcept
{
  constexpr double straight = 2.0; // how much more along one axis than along any other
  const auto at = static_cast<std::size_t>(axis);
  const Vec3 way_D = state.high_D[at] - state.low_D[at];
  AxisFinding found;
  for (int i = 1; i < plan.axes; ++i)
  {
    found.sensor = std::fabs(way_D[i]) > std::fabs(way_D[found.sensor]) ? i : found.sensor;
  }
  found.found = way_D[found.sensor] != 0.0;
  for (int i = 0; i < plan.axes; ++i)
  {
    found.found = found.found && (i == found.sensor || std::fabs(way_D[found.sensor]) > straight * std::fabs(way_D[i]));
  }
  found.sign = way_D[found.sensor] < 0.0 ? -1 : 1;
  found.low_m = std::min(state.low_D[at][found.sensor], state.high_D[at][found.sensor]);
  found.high_m = std::max(state.low_D[at][found.sensor], state.high_D[at][found.sensor]);
  return found;
}

MotorFinding findMotor(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept
{
  const MotorAnswers& answers = state.motors[static_cast<std::size_t>(motor)];
  const double least_m = leastMotion_m(plan, state);
  MotorFinding found;
  found.sensor = movedMost(plan, answers);
  const double up_m = along(answers.free, 0, found.sensor).moved_m;
  if (std::max(std::fabs(up_m), std::fabs(along(answers.free, 1, found.sensor).moved_m)) < least_m)
  {
    found.motion = MotorMotion::None;
    return found;
  }
  if (isClear(plan, answers, found.sensor, least_m))
  {
    found.motion = MotorMotion::Clear;
    found.sign = up_m < 0.0 ? -1 : 1;
    found.response_m_per_N = meanResponse(answers.free, found.sensor);
    found.strength = strengthOf(plan, answers, found.sensor);
  }
  return found;
}

std::optional<Calibration> calibrationFrom(
  const SelfTestPlan& plan, const SelfTestState& state, const DeviceInfo& device, const std::string& date)
{
  if (state.verdict != SelfTestVerdict::Passed)
  {
    return std::nullopt;
  }
  Calibration calibration{ device.name, device.serial, date, plan.axes, {} };
  for (int i = 0; i < plan.axes; ++i)
  {
    const AxisFinding axis = findAxis(plan, state, i);
    AxisCalibration& kept = calibration.axes[static_cast<std::size_t>(i)];
    kept = { axis.sensor, axis.sign, axis.low_m, axis.high_m, 0, 1, 0.0, 0.0 };
    for (int motor = 0; motor < plan.axes; ++motor)
    {
      const MotorFinding found = findMotor(plan, state, motor);
      if (found.sensor == axis.sensor)
      {
        kept.motor = motor;
        kept.motorSign = found.sign * axis.sign;
        kept.response_m_per_N = found.response_m_per_N;
        kept.strength = found.strength;
      }
    }
  }
  return calibration;
}

std::string askOf(const SelfTestPlan& plan, const SelfTestState& state)
{
  if (state.waiting_s > 0.0 && state.stage != SelfTestStage::Done)
  {
    return "It has not said yet where the hand is: move it.";
  }
  switch (state.stage)
  {
    case SelfTestStage::Still:
      return "Hold the handle still.";
    case SelfTestStage::End:
      return (plan.wheel ? "Turn it all the way " : "Move the handle all the way ") + endName(plan, state) +
             " and hold it there.";
    case SelfTestStage::Middle:
      return "Bring it to the middle and rest a relaxed hand on it.";
    case SelfTestStage::Settle:
    case SelfTestStage::Brace:
    case SelfTestStage::Push:
      return "Let your hand rest on it, relaxed: it is pushed gently, to and fro.";
    case SelfTestStage::Done:
      break;
  }
  return {};
}

std::string resultOf(const SelfTestPlan& plan, const SelfTestState& state)
{
  switch (state.verdict)
  {
    case SelfTestVerdict::None:
      return {};
    case SelfTestVerdict::Inconclusive:
      return std::string("Nothing was found out: ") + because(state.reason) + '.';
    case SelfTestVerdict::Aborted:
      return std::string("The check ended without force: ") + because(state.reason) + '.';
    case SelfTestVerdict::Passed:
    case SelfTestVerdict::Faulty:
      break;
  }
  double strongest = 0.0;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    strongest = std::max(strongest, findMotor(plan, state, motor).response_m_per_N);
  }
  std::string lines = state.verdict == SelfTestVerdict::Passed
                        ? "The device works."
                        : std::string("The device is faulty: ") + because(state.reason) + '.';
  lines += text(" At rest its position wanders by %.3g mm.", 1e3 * state.noise_m);
  for (int axis = 0; axis < plan.axes; ++axis)
  {
    lines += '\n' + axisLine(plan, state, axis) + "; " + motorLine(plan, state, axis, strongest);
  }
  return lines;
}

} // namespace palpate
