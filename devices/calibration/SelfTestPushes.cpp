// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestPushes.h"

#include <algorithm>
#include <array>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestStages.h"

namespace palpate
{
namespace
{

constexpr double settled_s = 0.25; // a hand that was still so long may be pushed
constexpr double brace_s = 0.5;    // by then a device's walls may push with a tenth of its force
constexpr double shake_s = 0.3;
constexpr double brakedFor_s = 0.05; // lag of a resting hand by viscosity
constexpr int firstCompared = 4;     // rounds of a motor, after which its axis is known

const PushRound& roundOf(const SelfTestState& state) noexcept
{
  return pushRounds[std::min(static_cast<std::size_t>(state.round), pushRounds.size() - 1)];
}

bool isHeld(PushKind kind) noexcept
{
  return kind == PushKind::Wall || kind == PushKind::Braked || kind == PushKind::Corridor || kind == PushKind::Limited;
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
  const bool unknown =
    reason == SelfTestReason::PushUnclear || reason == SelfTestReason::Fades || reason == SelfTestReason::NotMoved;
  end(state,
    reason == SelfTestReason::None ? SelfTestVerdict::Passed
    : unknown                      ? SelfTestVerdict::Inconclusive
                                   : SelfTestVerdict::Faulty,
    reason);
}

/// The next push that there is something to learn from. An axis that answers wrongly is pushed no more.
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
    case PushKind::Corridor:
      return &answers.corridor[direction];
    case PushKind::Limited:
      return &answers.limited[direction];
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

/// No wall pushes harder than the push. A limited one pushes with a quarter of the force that it would take of the
/// push.
double largestOfWall_N(const SelfTestPlan& plan, const SelfTestState& state, double wall_N_per_m) noexcept
{
  constexpr double quarter = 0.25;
  const double stiffness = wall_N_per_m * findMotor(plan, state, state.axis, 1).response_m_per_N; // of the hand's
  return roundOf(state).kind == PushKind::Limited ? quarter * plan.push_N * stiffness / (1.0 + stiffness) : plan.push_N;
}

/// Where the hand rests, against the way that the push goes; of a corridor the upper one of two.
void holdWalls(const SelfTestPlan& plan, const SelfTestState& state, DeviceCommand& command) noexcept
{
  constexpr double corridorWidth = 0.6; // radii
  const MotorFinding motor = findMotor(plan, state, state.axis, 1);
  const bool corridor = roundOf(state).kind == PushKind::Corridor;
  const Vec3 against_D = (roundOf(state).up || corridor ? -motor.sign : motor.sign) * Vec3::Unit(motor.sensor);
  const double at_m = against_D.dot(state.from_D), wall_N_per_m = wallStiffness_N_per_m(plan, state, state.axis);
  const double largest_N = largestOfWall_N(plan, state, wall_N_per_m);
  command.walls[command.wallCount++] = { against_D, at_m, wall_N_per_m, largest_N };
  if (corridor)
  {
    command.walls[command.wallCount++] = { -against_D, -at_m - corridorWidth * plan.radius_m, wall_N_per_m, largest_N };
    command.wallMotors = motor.sign * Vec3::Unit(state.axis) * Vec3::Unit(motor.sensor).transpose();
  }
}

void brake(const SelfTestPlan& plan, const SelfTestState& state, DeviceCommand& command) noexcept
{
  command.viscosity_Ns_per_m = brakedFor_s / findMotor(plan, state, state.axis, 1).response_m_per_N;
  command.brakeLargest_N = plan.push_N;
}

} // namespace

bool givesForce(const SelfTestState& state) noexcept
{
  return state.stage == SelfTestStage::Brace || state.stage == SelfTestStage::Push ||
         state.stage == SelfTestStage::Shake;
}

void advancePushes(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  switch (state.stage)
  {
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
    default:
      return;
  }
}

DeviceCommand pushCommand(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  DeviceCommand command;
  const PushRound& round = roundOf(state);
  command.lapses =
    round.kind == PushKind::Lapse &&
    ((state.stage == SelfTestStage::Push && state.stage_s >= push::lapse_s) || state.stage == SelfTestStage::Rest);
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
    round.kind == PushKind::Braked ? brake(plan, state, command) : holdWalls(plan, state, command);
  }
  if (state.stage == SelfTestStage::Push)
  {
    const bool lapse = round.kind == PushKind::Lapse;
    const double force_N = plan.push_N * (lapse ? push::lapsingShare(state.stage_s) : push::share(state.stage_s));
    command.wrench_D.force = (round.up ? force_N : -force_N) * Vec3::Unit(state.axis);
  }
  return command;
}

void judgeDanger(const SelfTestPlan& plan, SelfTestReason danger, SelfTestState& state) noexcept
{
  const PushKind kind = roundOf(state).kind;
  const bool ranAway = danger == SelfTestReason::TooFar || danger == SelfTestReason::TooFast;
  if (state.stage == SelfTestStage::Shake || !isHeld(kind) || !ranAway)
  {
    end(state, SelfTestVerdict::Aborted, danger);
    return;
  }
  state.broke = kind == PushKind::Braked     ? HeldProof::Drives
                : kind == PushKind::Corridor ? HeldProof::Misplaced
                                             : HeldProof::WrongWay;
  nextRound(plan, state);
  state.still_s = 0.0;
  state.least_D = state.most_D = state.last_D;
}

} // namespace palpate
