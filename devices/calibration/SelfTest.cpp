// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestPushes.h"
#include "devices/calibration/SelfTestStages.h"
#include "haptics/safety/ForceLimits.h"
#include "haptics/safety/HandLimits.h"

namespace palpate
{
namespace
{

constexpr double still_s = 0.5;      // this long still counts as having stopped
constexpr double noise_s = 1.0;      // watched for noise
constexpr double patience_s = 30.0;  // with a person who is to move it
constexpr double silent_s = 30.0;    // with a device that says where the hand is once it is moved
constexpr double prepared_s = 600.0; // with a person who prepares an arm
constexpr double latest_s = 0.020;   // between two ticks under force
constexpr double leaves = 0.1;       // radii: less is not going to an end
constexpr double middleHalf = 0.6;   // of the way to an end

double stillWithin_m(const SelfTestPlan& plan)
{
  return std::max(4.0 * plan.resolution_m, 0.02 * plan.radius_m);
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
void awaitHand(const SelfTestPlan& plan, double dt_s, SelfTestState& state) noexcept
{
  state.waiting_s += dt_s;
  state.seen = false;
  if (state.waiting_s > (plan.knowsAxes ? prepared_s : silent_s))
  {
    end(state, SelfTestVerdict::Inconclusive, SelfTestReason::Silent);
  }
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

/// Of an arm the ends are those of its work space.
void goToPushes(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  for (int axis = 0; axis < plan.axes; ++axis)
  {
    state.high_D[static_cast<std::size_t>(axis)] = plan.radius_m * Vec3::Unit(axis);
    state.low_D[static_cast<std::size_t>(axis)] = -plan.radius_m * Vec3::Unit(axis);
  }
  enter(state, SelfTestStage::Settle);
}

void awaitStill(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  if (state.still_s >= noise_s)
  {
    state.noise_m = (state.most_D - state.least_D).maxCoeff();
    state.axis = 0;
    state.up = false;
    plan.knowsAxes ? goToPushes(plan, state) : enter(state, SelfTestStage::End);
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

void advance(const SelfTestPlan& plan, SelfTestState& state) noexcept
{
  switch (state.stage)
  {
    case SelfTestStage::Still:
      return awaitStill(plan, state);
    case SelfTestStage::End:
      return awaitEnd(plan, state);
    case SelfTestStage::Middle:
      return awaitMiddle(plan, state);
    case SelfTestStage::Settle:
    case SelfTestStage::Brace:
    case SelfTestStage::Push:
    case SelfTestStage::Rest:
    case SelfTestStage::Shake:
      return advancePushes(plan, state);
    case SelfTestStage::Done:
      return;
  }
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
  constexpr double assumedForce_N = 5.0, shareOfForce = 0.1, shareOfWay = 0.35, pushOfArm_N = 0.5;
  SelfTestPlan plan;
  plan.axes = device.rendersForce && device.causality == Causality::Impedance ? axesOf(device) : 0;
  plan.wheel = wheel || device.deviceClass == DeviceClass::Wheel1D;
  plan.offersWalls = device.abilities.offersWalls() && plan.axes <= 2;
  plan.shakes = device.abilities.signals;
  plan.effectsEndAfter_s = device.effectsEndAfter_s;
  plan.simulated = device.simulated;
  plan.radius_m = device.workspaceRadius_m.value;
  plan.resolution_m = device.resolution_m.value;
  plan.knowsAxes = device.knowsAxes;
  plan.push_N = device.knowsAxes ? std::min(device.maxForce_N.value, pushOfArm_N)
                                 : shareOfForce * std::min(device.maxForce_N.value, assumedForce_N);
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
    return "this device renders no force, so there is nothing to check";
  }
  if (this->wheel && this->knowsAxes)
  {
    return armIsNoWheel;
  }
  const bool measurable = this->radius_m > 0.0 && this->radius_m < std::numeric_limits<double>::infinity();
  return measurable && this->push_N > 0.0 ? ""
                                          : "this device reports neither its range of motion nor its largest force";
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
    awaitHand(plan, dt_s, state);
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
  return pushCommand(plan, state);
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
