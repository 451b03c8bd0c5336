// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "devices/calibration/SelfTestFindings.h"
#include "haptics/safety/ForceLimits.h"
#include "haptics/safety/HandLimits.h"

namespace palpate
{
namespace
{

constexpr double still_s = 0.5;     // this long still counts as having stopped
constexpr double settled_s = 0.25;  // and this long before a push
constexpr double noise_s = 1.0;     // watched for noise
constexpr double brace_s = 0.5;     // by then a device's walls may push with a tenth of its force
constexpr double patience_s = 30.0; // with a person who is to move it
constexpr double restless_s = 8.0;  // with one who is to hold still
constexpr double silent_s = 30.0;   // with a device that says where the hand is once it is moved
constexpr double latest_s = 0.020;  // between two ticks under force
constexpr double leaves = 0.1;      // radii: less is not going to an end
constexpr double middleHalf = 0.6;  // of the way to an end
constexpr double shake_s = 0.3;
constexpr double brakedFor_s = 0.05; // what viscosity makes a resting hand lag by
constexpr int firstCompared = 4;     // rounds of a motor, after which it is known what it moves

const PushRound& roundOf(const SelfTestState& state) noexcept
{
  return pushRounds[std::min(static_cast<std::size_t>(state.round), pushRounds.size() - 1)];
}

bool isHeld(PushKind kind) noexcept
{
  return kind == PushKind::Wall || kind == PushKind::Braked;
}

double stillWithin_m(const SelfTestPlan& plan)
{
  return std::max(4.0 * plan.resolution_m, 0.02 * plan.radius_m);
}

void end(SelfTestState& state, SelfTestVerdict verdict, SelfTestReason reason) noexcept
{
  state.stage = SelfTestStage::Done;
  state.verdict = verdict;
  state.reason = reason;
}

void enter(SelfTestState& state, SelfTestStage stage) noexcept
{
  state.stage = stage;
  state.stage_s = state.still_s = 0.0;
  state.from_D = state.least_D = state.most_D = state.last_D;
}

/// Follows the hand; a box that grows too large starts anew where the hand is.
void follow(const SelfTestPlan& plan, const Vec3& p_D, double dt_s, SelfTestState& state) noexcept
{
  constexpr double smoothing = 0.2;
  if (!state.seen)
  {
    state.last_D = p_D;
    enter(state, state.stage);
    state.seen = true;
  }
  state.velocity_D += smoothing * ((p_D - state.last_D) / dt_s - state.velocity_D);
  state.last_D = p_D;
  state.stage_s += dt_s;
  state.still_s += dt_s;
  state.least_D = state.least_D.cwiseMin(p_D);
  state.most_D = state.most_D.cwiseMax(p_D);
  if ((state.most_D - state.least_D).maxCoeff() > stillWithin_m(plan))
  {
    state.least_D = state.most_D = p_D;
    state.still_s = 0.0;
  }
}

/// Some devices say nothing until they are moved; nobody is asked to for ever.
void awaitHand(double dt_s, SelfTestState& state) noexcept
{
  state.waiting_s += dt_s;
  state.seen = false;
  if (state.waiting_s > silent_s)
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::Silent);
  }
}

bool givesForce(const SelfTestState& state)
{
  return state.stage == SelfTestStage::Brace || state.stage == SelfTestStage::Push ||
         state.stage == SelfTestStage::Shake;
}

/// No hand is carried further than the workspace between two ticks, nor many times past its end.
bool isImpossible(const SelfTestPlan& plan, const Vec3& p_D, double dt_s, const SelfTestState& state) noexcept
{
  constexpr double farOutside = 10.0;
  const bool leaps = state.seen && dt_s <= latest_s && (p_D - state.last_D).norm() > plan.radius_m;
  return leaps || p_D.cwiseAbs().maxCoeff() > farOutside * plan.radius_m;
}

SelfTestReason danger(
  const SelfTestPlan& plan, const DeviceSample& sample, double dt_s, const SelfTestState& state) noexcept
{
  if (!givesForce(state))
  {
    return SelfTestReason::None;
  }
  if (dt_s > latest_s && !plan.simulated)
  {
    return SelfTestReason::Late;
  }
  if (!palpate::isHeld(plan.deadMan, sample.buttons, sample.grip))
  {
    return SelfTestReason::LetGo;
  }
  if ((state.last_D - state.from_D).norm() > plan.farthest_m)
  {
    return SelfTestReason::TooFar;
  }
  return state.velocity_D.norm() > plan.fastest_m_per_s ? SelfTestReason::TooFast : SelfTestReason::None;
}

void awaitStill(SelfTestState& state) noexcept
{
  if (state.still_s >= noise_s)
  {
    state.noise_m = (state.most_D - state.least_D).maxCoeff();
    state.axis = 0;
    state.up = false;
    enter(state, SelfTestStage::End);
  }
  else if (state.stage_s > restless_s)
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::NeverStill);
  }
}

bool sensorIsTaken(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  const int sensor = findAxis(plan, state, state.axis).sensor;
  for (int other = 0; other < state.axis; ++other)
  {
    if (findAxis(plan, state, other).sensor == sensor)
    {
      return true;
    }
  }
  return false;
}

/// Nobody moved it. A second axis of two may not be there: a wheel that calls itself a stick.
void giveUpEnd(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  if (plan.axes != 2 || state.axis != 1)
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::NotMoved);
    return;
  }
  state.oneAxis = true;
  enter(state, SelfTestStage::Middle);
}

void keepEnd(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  const auto at = static_cast<std::size_t>(state.axis);
  (state.up ? state.high_D : state.low_D)[at] = state.last_D;
  if (!state.up)
  {
    state.up = true;
    enter(state, SelfTestStage::End);
    return;
  }
  if (!findAxis(plan, state, state.axis).found || sensorIsTaken(plan, state))
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::NotAlongAxis);
    return;
  }
  state.up = false;
  ++state.axis;
  enter(state, state.axis < state.axes(plan) ? SelfTestStage::End : SelfTestStage::Middle);
}

void awaitEnd(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  const bool moved = (state.last_D - state.from_D).cwiseAbs().maxCoeff() >= leaves * plan.radius_m;
  if (moved && state.still_s >= still_s)
  {
    keepEnd(plan, state);
  }
  else if (state.stage_s > patience_s)
  {
    giveUpEnd(plan, state);
  }
}

bool inMiddle(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  for (int axis = 0; axis < state.axes(plan); ++axis)
  {
    const AxisFinding found = findAxis(plan, state, axis);
    const double half_m = 0.5 * (found.high_m - found.low_m);
    if (std::fabs(state.last_D[found.sensor] - found.low_m - half_m) > middleHalf * half_m)
    {
      return false;
    }
  }
  return true;
}

void awaitMiddle(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  if (state.still_s >= still_s && inMiddle(plan, state))
  {
    state.axis = state.round = 0;
    enter(state, SelfTestStage::Settle);
  }
  else if (state.stage_s > patience_s)
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::NotInMiddle);
  }
}

void beginPush(SelfTestState& state) noexcept
{
  enter(state, SelfTestStage::Push);
  state.record.begin(state.last_D);
}

void awaitSettled(SelfTestState& state) noexcept
{
  if (state.still_s >= settled_s)
  {
    isHeld(roundOf(state).kind) ? enter(state, SelfTestStage::Brace) : beginPush(state);
  }
  else if (state.stage_s > restless_s)
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::NeverStill);
  }
}

bool applies(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  const PushKind kind = roundOf(state).kind;
  if (kind == PushKind::WarmUp || kind == PushKind::Free)
  {
    return true;
  }
  if (kind == PushKind::Lapse)
  {
    return plan.effectsEndAfter_s > 0.0;
  }
  return plan.offersWalls && state.broke == HeldProof::Unfelt;
}

void finish(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  const SelfTestReason reason = judgePushes(plan, state);
  const bool unknown = reason == SelfTestReason::PushUnclear || reason == SelfTestReason::Fades ||
                       reason == SelfTestReason::NotMoved;
  end(state,
    reason == SelfTestReason::None ? SelfTestVerdict::Passed
    : unknown                      ? SelfTestVerdict::Inconclusive
                                   : SelfTestVerdict::Faulty,
    reason);
}

/// The next push that there is something to learn from. What does not answer as it should is pushed no more.
void nextRound(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  constexpr auto all = static_cast<int>(pushRounds.size());
  do
  {
    ++state.round;
  } while (state.round < all && !applies(plan, state));
  if (state.round >= firstCompared && findMotor(plan, state, state.axis, 1).motion != MotorMotion::Clear)
  {
    state.round = all;
  }
  if (state.round >= all)
  {
    state.round = 0;
    ++state.axis;
  }
  if (state.axis < plan.axes)
  {
    state.stage = SelfTestStage::Settle;
    state.stage_s = 0.0; // it may have been still since before
    return;
  }
  state.axis = 0;
  plan.shakes ? enter(state, SelfTestStage::Shake) : finish(plan, state);
}

std::array<PushAnswer, 3>* answersOf(SelfTestState& state) noexcept
{
  const PushRound& round = roundOf(state);
  MotorAnswers& answers = state.motors[static_cast<std::size_t>(state.axis)];
  const std::size_t direction = round.up ? 0 : 1;
  switch (round.kind)
  {
    case PushKind::WarmUp:
      return nullptr;
    case PushKind::Free:
      return &answers.free[round.repetition][direction];
    case PushKind::Wall:
      return &answers.walls[round.repetition][direction];
    case PushKind::Braked:
      return &answers.braked[round.repetition][direction];
    case PushKind::Lapse:
      return &answers.lapse;
  }
  return nullptr;
}

void endPush(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  if (std::array<PushAnswer, 3>* const kept = answersOf(state))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      (*kept)[static_cast<std::size_t>(axis)] =
        state.record.answer(axis, roundOf(state).up ? plan.push_N : -plan.push_N);
    }
  }
  nextRound(plan, state);
}

void endShake(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  const double wandered_m = (state.most_D - state.least_D).maxCoeff();
  state.shake = wandered_m > leastMotion_m(plan, state) ? ShakeFinding::Seen : ShakeFinding::Unseen;
  finish(plan, state);
}

void advance(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  switch (state.stage)
  {
    case SelfTestStage::Still:
      return awaitStill(state);
    case SelfTestStage::End:
      return awaitEnd(plan, state);
    case SelfTestStage::Middle:
      return awaitMiddle(plan, state);
    case SelfTestStage::Settle:
      return awaitSettled(state);
    case SelfTestStage::Brace:
      return state.stage_s >= brace_s ? beginPush(state) : void();
    case SelfTestStage::Push:
      state.record.add(state.stage_s, state.last_D);
      return state.stage_s >= push::all_s ? enter(state, SelfTestStage::Rest) : void();
    case SelfTestStage::Rest:
      state.record.add(push::all_s + state.stage_s, state.last_D);
      return state.stage_s >= push::rest_s ? endPush(plan, state) : void();
    case SelfTestStage::Shake:
      return state.stage_s >= shake_s ? endShake(plan, state) : void();
    case SelfTestStage::Done:
      return;
  }
}

/// Where the hand rests, against the way that the push goes; no harder than the push.
void holdWall(const SelfTestPlan& plan, const SelfTestState& state, DeviceCommand& command) noexcept
{
  const MotorFinding motor = findMotor(plan, state, state.axis, 1);
  const Vec3 against_D = (roundOf(state).up ? -motor.sign : motor.sign) * Vec3::Unit(motor.sensor);
  command.walls[command.wallCount++] = { against_D, against_D.dot(state.from_D),
    wallStiffness_N_per_m(plan, state, state.axis), plan.push_N };
}

void brake(const SelfTestPlan& plan, const SelfTestState& state, DeviceCommand& command) noexcept
{
  command.viscosity_Ns_per_m = brakedFor_s / findMotor(plan, state, state.axis, 1).response_m_per_N;
  command.brakeLargest_N = plan.push_N;
}

DeviceCommand commandOf(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  DeviceCommand command;
  const PushRound& round = roundOf(state);
  command.lapses = round.kind == PushKind::Lapse &&
                   ((state.stage == SelfTestStage::Push && state.stage_s >= push::lapse_s) ||
                     state.stage == SelfTestStage::Rest);
  if (!givesForce(state))
  {
    return command;
  }
  if (state.stage == SelfTestStage::Shake)
  {
    command.signal = Signal::Oscillation;
    return command;
  }
  if (isHeld(round.kind))
  {
    round.kind == PushKind::Wall ? holdWall(plan, state, command) : brake(plan, state, command);
  }
  if (state.stage == SelfTestStage::Push)
  {
    const bool lapse = round.kind == PushKind::Lapse;
    const double force_N =
      plan.push_N * (lapse ? push::lapsingShare(state.stage_s) : push::share(state.stage_s));
    command.wrench_D.force = (round.up ? force_N : -force_N) * Vec3::Unit(state.axis);
  }
  return command;
}

/// What the device holds by itself may take the hand away: then it holds nothing any more, and the test goes on.
void judgeDanger(const SelfTestPlan& plan, SelfTestReason danger, SelfTestState& state) noexcept
{
  const PushKind kind = roundOf(state).kind;
  const bool ranAway = danger == SelfTestReason::TooFar || danger == SelfTestReason::TooFast;
  if (state.stage == SelfTestStage::Shake || !isHeld(kind) || !ranAway)
  {
    end(state, SelfTestVerdict::Aborted, danger);
    return;
  }
  state.broke = kind == PushKind::Wall ? HeldProof::WrongWay : HeldProof::Drives;
  nextRound(plan, state);
  state.still_s = 0.0;
  state.least_D = state.most_D = state.last_D;
}

int axesOf(const DeviceInfo& device)
{
  switch (device.deviceClass)
  {
    case DeviceClass::Vibration0D:
      return 0;
    case DeviceClass::Wheel1D:
      return 1;
    case DeviceClass::Joystick2D:
      return 2;
    case DeviceClass::Point3D:
    case DeviceClass::Rigid6D:
      return 3;
  }
  return 0;
}

} // namespace

SelfTestPlan SelfTestPlan::forDevice(const DeviceInfo& device, const DeadMan& deadMan, bool wheel)
{
  constexpr double assumedForce_N = 5.0, shareOfForce = 0.1, shareOfWay = 0.35;
  SelfTestPlan plan;
  plan.axes = device.rendersForce && device.causality == Causality::Impedance ? axesOf(device) : 0;
  plan.wheel = wheel || device.deviceClass == DeviceClass::Wheel1D;
  plan.offersWalls = device.abilities.offersWalls() && plan.axes <= 2;
  plan.shakes = device.abilities.signals;
  plan.effectsEndAfter_s = device.effectsEndAfter_s;
  plan.simulated = device.simulated;
  plan.radius_m = device.workspaceRadius_m.value;
  plan.resolution_m = device.resolution_m.value;
  plan.push_N = shareOfForce * std::min(device.maxForce_N.value, assumedForce_N);
  plan.stiffest_N_per_m = device.heldStiffness_N_per_m.value;
  plan.farthest_m = shareOfWay * plan.radius_m;
  plan.fastest_m_per_s = handLimits(plan.radius_m, plan.push_N).speed_m_per_s;
  plan.deadMan = deadMan;
  return plan;
}

std::string SelfTestPlan::refusal() const
{
  if (this->axes == 0)
  {
    return "this device gives no force, so there is nothing to check";
  }
  const bool measurable = this->radius_m > 0.0 && this->radius_m < std::numeric_limits<double>::infinity();
  return measurable && this->push_N > 0.0 ? "" : "this device says neither how far it moves nor how strong it is";
}

DeviceCommand stepSelfTest(
  const SelfTestPlan& plan, const DeviceSample& sample, DeviceStatus status, double dt_s, SelfTestState& state) noexcept
{
  if (state.verdict != SelfTestVerdict::None)
  {
    return {};
  }
  if (status == DeviceStatus::Waiting)
  {
    awaitHand(dt_s, state);
    return {};
  }
  if (status != DeviceStatus::Ok || !isFinite(sample))
  {
    end(state, SelfTestVerdict::Aborted, status != DeviceStatus::Ok ? SelfTestReason::Lost : SelfTestReason::NotFinite);
    return {};
  }
  state.waiting_s = 0.0;
  if (isImpossible(plan, sample.pose_D.p, dt_s, state))
  {
    end(state, SelfTestVerdict::Aborted, SelfTestReason::Impossible);
    return {};
  }
  follow(plan, sample.pose_D.p, dt_s, state);
  const SelfTestReason unexpected = danger(plan, sample, dt_s, state);
  if (unexpected != SelfTestReason::None)
  {
    judgeDanger(plan, unexpected, state);
    return {};
  }
  advance(plan, state);
  return commandOf(plan, state);
}

void stopSelfTest(SelfTestState& state) noexcept
{
  if (state.verdict == SelfTestVerdict::None)
  {
    end(state, SelfTestVerdict::Aborted, SelfTestReason::Stopped);
  }
}

double selfTestProgress(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  constexpr auto rounds = static_cast<int>(pushRounds.size());
  const int ends = 2 * (plan.wheel ? 1 : plan.axes), all = 1 + ends + 1 + plan.axes * rounds + 1;
  int done = 0;
  switch (state.stage)
  {
    case SelfTestStage::Still:
      break;
    case SelfTestStage::End:
      done = 1 + 2 * state.axis + (state.up ? 1 : 0);
      break;
    case SelfTestStage::Middle:
      done = 1 + ends;
      break;
    case SelfTestStage::Settle:
    case SelfTestStage::Brace:
    case SelfTestStage::Push:
    case SelfTestStage::Rest:
      done = 1 + ends + 1 + state.axis * rounds + state.round;
      break;
    case SelfTestStage::Shake:
      done = all - 1;
      break;
    case SelfTestStage::Done:
      done = all;
      break;
  }
  return static_cast<double>(done) / all;
}

Vec3 askedPlace_D(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  constexpr double beyondTheEnd = 1.2;
  if (state.stage != SelfTestStage::End)
  {
    return Vec3::Zero();
  }
  return (state.up ? 1.0 : -1.0) * beyondTheEnd * plan.radius_m * Vec3::Unit(state.axis);
}

} // namespace palpate
