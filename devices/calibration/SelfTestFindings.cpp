// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestFindings.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// The driver's axis along which both directions are furthest apart.
int movedMost(const SelfTestPlan& plan, const PushPair& answers)
{
  int most = 0;
  double most_m = 0.0;
  for (int axis = 0; axis < plan.axes; ++axis)
  {
    const double apart_m = std::fabs(along(answers, 0, axis).moved_m - along(answers, 1, axis).moved_m);
    if (apart_m > most_m)
    {
      most = axis;
      most_m = apart_m;
    }
  }
  return most;
}

/// Both ways, and about as far.
bool isAlike(double up_m, double down_m, double least_m)
{
  constexpr double alike = 4.0;
  const double smaller_m = std::min(std::fabs(up_m), std::fabs(down_m));
  const double larger_m = std::max(std::fabs(up_m), std::fabs(down_m));
  return (up_m > 0.0) != (down_m > 0.0) && smaller_m >= least_m && larger_m <= alike * smaller_m;
}

/// Findings of one pair of pushes.
MotorMotion motionOf(const SelfTestPlan& plan, const PushPair& answers, int axis, double least_m)
{
  constexpr double aside = 0.5, before = 0.25;
  const double up_m = along(answers, 0, axis).moved_m, down_m = along(answers, 1, axis).moved_m;
  if (!isAlike(up_m, down_m, least_m))
  {
    return MotorMotion::Unclear;
  }
  for (const std::size_t direction : { 0U, 1U })
  {
    const PushAnswer& answer = along(answers, direction, axis);
    if (answer.early_m > std::max(least_m, before * std::fabs(answer.moved_m)))
    {
      return MotorMotion::Unclear;
    }
    for (int other = 0; other < plan.axes; ++other)
    {
      const double other_m = std::fabs(along(answers, direction, other).moved_m);
      if (other != axis && other_m > aside * std::fabs(answer.moved_m) + least_m)
      {
        const double there_m = along(answers, 0, other).moved_m, back_m = along(answers, 1, other).moved_m;
        return isAlike(there_m, back_m, least_m) ? MotorMotion::Mixed : MotorMotion::Unclear;
      }
    }
  }
  return MotorMotion::Clear;
}

double mostMoved(const SelfTestPlan& plan, const PushAnswer* answers)
{
  double most_m = 0.0;
  for (int axis = 0; axis < plan.axes; ++axis)
  {
    most_m = std::max(most_m, std::fabs(answers[axis].most_m));
  }
  return most_m;
}

/// How many of the pushes moved anything worth speaking of beside the others, ever.
int pushesThatMoved(const SelfTestPlan& plan, const MotorAnswers& answers, int repetitions, double least_m)
{
  constexpr double worthMentioning = 0.2;
  std::array<double, 4> ways_m{};
  for (int i = 0; i < 2 * repetitions; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    ways_m[at] = mostMoved(plan, answers.free[at / 2][at % 2].data());
  }
  const double enough_m = std::max(least_m, worthMentioning * *std::max_element(ways_m.begin(), ways_m.end()));
  return static_cast<int>(
    std::count_if(ways_m.begin(), ways_m.end(), [enough_m](double way_m) { return way_m >= enough_m; }));
}

/// The hand was hardly there yet when the force was gone again.
bool isLate(const PushPair& answers, int axis, double least_m)
{
  const auto late = [&](const PushAnswer& answer)
  { return std::fabs(answer.most_m) >= least_m && answer.reached_s > push::all_s; };
  return late(along(answers, 0, axis)) && late(along(answers, 1, axis)) &&
         (along(answers, 0, axis).most_m > 0.0) != (along(answers, 1, axis).most_m > 0.0);
}

/// The axis along which the late motion of a pair is largest.
int lateAxis(const SelfTestPlan& plan, const PushPair& answers)
{
  int most = 0;
  for (int axis = 1; axis < plan.axes; ++axis)
  {
    most = std::fabs(along(answers, 0, axis).most_m) > std::fabs(along(answers, 0, most).most_m) ? axis : most;
  }
  return most;
}

double waysOf(const PushPair& answers, int axis)
{
  return std::fabs(along(answers, 0, axis).moved_m - along(answers, 1, axis).moved_m);
}

/// Far less than the first time.
bool fades(const MotorAnswers& answers, int axis)
{
  constexpr double stays = 0.6;
  return waysOf(answers.free[1], axis) < stays * waysOf(answers.free[0], axis);
}

double responseOf(const std::array<PushPair, 2>& answers, int axis, int repetitions)
{
  double sum = 0.0;
  for (int r = 0; r < repetitions; ++r)
  {
    const PushPair& pair = answers[static_cast<std::size_t>(r)];
    sum += along(pair, 0, axis).response_m_per_N + along(pair, 1, axis).response_m_per_N;
  }
  return std::fabs(sum) / (2.0 * repetitions);
}

/// Pushes that only some of the commands made, or that came late.
MotorMotion troubleOf(
  const SelfTestPlan& plan, const MotorAnswers& answers, int repetitions, double least_m, MotorFinding& found)
{
  const int moved = pushesThatMoved(plan, answers, repetitions, least_m);
  if (moved == 0)
  {
    return MotorMotion::None;
  }
  if (moved < 2 * repetitions)
  {
    return MotorMotion::Sometimes;
  }
  const int axis = lateAxis(plan, answers.free[0]);
  found.sensor = axis;
  return isLate(answers.free[0], axis, least_m) ? MotorMotion::Late : MotorMotion::Clear;
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

MotorFinding findMotor(const SelfTestPlan& plan, const SelfTestState& state, int motor, int repetitions) noexcept
{
  if (repetitions > 1)
  {
    const MotorFinding first = findMotor(plan, state, motor, 1);
    if (first.motion != MotorMotion::Clear)
    {
      return first; // it was pushed no more
    }
  }
  const MotorAnswers& answers = state.motors[static_cast<std::size_t>(motor)];
  const double least_m = leastMotion_m(plan, state);
  MotorFinding found;
  found.motion = troubleOf(plan, answers, repetitions, least_m, found);
  if (found.motion != MotorMotion::Clear)
  {
    return found;
  }
  found.sensor = movedMost(plan, answers.free[0]);
  for (int r = 0; r < repetitions && found.motion == MotorMotion::Clear; ++r)
  {
    found.motion = motionOf(plan, answers.free[static_cast<std::size_t>(r)], found.sensor, least_m);
  }
  if (found.motion == MotorMotion::Clear && repetitions == 2 && fades(answers, found.sensor))
  {
    found.motion = MotorMotion::Fades;
  }
  found.sign = along(answers.free[0], 0, found.sensor).moved_m < 0.0 ? -1 : 1;
  found.response_m_per_N = responseOf(answers.free, found.sensor, repetitions);
  return found;
}

int motorOf(const SelfTestPlan& plan, const SelfTestState& state, int sensor) noexcept
{
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const MotorFinding found = findMotor(plan, state, motor);
    if (found.motion == MotorMotion::Clear && found.sensor == sensor)
    {
      return motor;
    }
  }
  return -1;
}

std::optional<bool> endedByItself(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept
{
  const MotorFinding found = findMotor(plan, state, motor);
  if (!(plan.effectsEndAfter_s > 0.0) || found.motion != MotorMotion::Clear)
  {
    return std::nullopt;
  }
  const PushAnswer& lapse = state.motors[static_cast<std::size_t>(motor)].lapse[static_cast<std::size_t>(found.sensor)];
  // An axis that friction holds returns neither way.
  const double before_m = std::fabs(lapse.most_m - lapse.last_m), after_m = std::fabs(lapse.last_m - lapse.rested_m);
  if (std::max(before_m, after_m) < leastMotion_m(plan, state))
  {
    return std::nullopt;
  }
  return before_m > after_m;
}

namespace
{

SelfTestReason reasonOf(MotorMotion motion)
{
  switch (motion)
  {
    case MotorMotion::None:
      return SelfTestReason::NoMotion;
    case MotorMotion::Unclear:
      return SelfTestReason::PushUnclear;
    case MotorMotion::Mixed:
      return SelfTestReason::BothAxes;
    case MotorMotion::Late:
      return SelfTestReason::AnswersLate;
    case MotorMotion::Sometimes:
      return SelfTestReason::Sometimes;
    case MotorMotion::Fades:
      return SelfTestReason::Fades;
    case MotorMotion::Clear:
      break;
  }
  return SelfTestReason::None;
}

/// Findings that hide those after them in the list.
SelfTestReason graver(SelfTestReason a, SelfTestReason b)
{
  constexpr std::array<SelfTestReason, 12> order{ SelfTestReason::PushUnclear, SelfTestReason::BothAxes,
    SelfTestReason::Turned, SelfTestReason::Reversed, SelfTestReason::AnswersLate, SelfTestReason::Sometimes,
    SelfTestReason::Fades, SelfTestReason::SharedAxis, SelfTestReason::NoExpiry, SelfTestReason::NotMoved,
    SelfTestReason::NoMotion, SelfTestReason::None };
  const auto rank = [&](SelfTestReason reason) { return std::find(order.begin(), order.end(), reason); };
  return rank(a) < rank(b) ? a : b;
}

/// Of a wheel one motor must answer along its axis; another one may be behind the same axis, or not be there. A person
/// who declares a wheel does not mind the other motors.
SelfTestReason judgeOneAxis(const SelfTestPlan& plan, const SelfTestState& state)
{
  const int sensor = findAxis(plan, state, 0).sensor;
  if (plan.wheel && motorOf(plan, state, sensor) >= 0)
  {
    return SelfTestReason::None;
  }
  SelfTestReason worst = SelfTestReason::None;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const MotorFinding found = findMotor(plan, state, motor);
    const bool elsewhere = found.motion == MotorMotion::Clear && found.sensor != sensor;
    const SelfTestReason reason = found.motion == MotorMotion::None ? SelfTestReason::None : reasonOf(found.motion);
    worst = graver(worst, elsewhere ? SelfTestReason::NotMoved : reason);
  }
  return motorOf(plan, state, sensor) < 0 ? graver(worst, SelfTestReason::NoMotion) : worst;
}

/// Of an arm, whose kinematics say where a push leads. Its coming back after the push is not judged: an arm has no
/// spring, and its friction or a hand that holds it lightly may leave a sound arm where it was pushed.
SelfTestReason contradictionOf(const MotorFinding& found, int motor)
{
  return found.motion != MotorMotion::Clear ? SelfTestReason::None
         : found.sensor != motor            ? SelfTestReason::Turned
         : found.sign < 0                   ? SelfTestReason::Reversed
                                            : SelfTestReason::None;
}

SelfTestReason judgeEachAxis(const SelfTestPlan& plan, const SelfTestState& state)
{
  SelfTestReason worst = SelfTestReason::None;
  int moved = 0;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const MotorFinding found = findMotor(plan, state, motor);
    const int bit = found.motion == MotorMotion::Clear ? 1 << found.sensor : 0;
    worst = graver(worst, (moved & bit) != 0 ? SelfTestReason::SharedAxis : reasonOf(found.motion));
    worst = graver(worst, plan.knowsAxes ? contradictionOf(found, motor) : SelfTestReason::None);
    moved |= bit;
  }
  return worst;
}

} // namespace

SelfTestReason judgePushes(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  SelfTestReason worst = state.axes(plan) == 1 ? judgeOneAxis(plan, state) : judgeEachAxis(plan, state);
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    worst =
      graver(worst, endedByItself(plan, state, motor).value_or(true) ? SelfTestReason::None : SelfTestReason::NoExpiry);
  }
  return worst;
}

std::optional<Calibration> calibrationFrom(
  const SelfTestPlan& plan, const SelfTestState& state, const DeviceInfo& device, const std::string& date)
{
  if (state.verdict != SelfTestVerdict::Passed)
  {
    return std::nullopt;
  }
  Calibration calibration{ device.name, device.serial, date, state.axes(plan), {}, heldProofOf(plan, state) };
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisFinding axis = findAxis(plan, state, i);
    const int motor = motorOf(plan, state, axis.sensor);
    const MotorFinding found = findMotor(plan, state, motor);
    calibration.axes[static_cast<std::size_t>(i)] = { axis.sensor, axis.sign, axis.low_m, axis.high_m, motor,
      found.sign * axis.sign, found.response_m_per_N, strengthOf(findHeld(plan, state, motor)) };
  }
  return calibration;
}

} // namespace palpate
