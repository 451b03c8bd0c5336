// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "devices/calibration/SelfTestFindings.h"
#include "devices/common/DeviceNotes.h"

namespace palpate
{
namespace
{

constexpr const char* axisLetters = "xyz";
constexpr double weakest = 1.0 / 3.0; // of the strongest motor's response
constexpr double shortest = 0.5;      // of the range that was assumed

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

std::string because(SelfTestReason reason)
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
      return "a motor moves nothing; if it is a wheel, say so and try again";
    case SelfTestReason::BothAxes:
      return "one push moves two axes at once: its motors are coupled, or its firmware mixes directions";
    case SelfTestReason::SharedAxis:
      return "two of its motors move the same axis; if it is a wheel, say so and try again";
    case SelfTestReason::AnswersLate:
      return "it is moved only after a push is over: so late no force is safe";
    case SelfTestReason::Sometimes:
      return "only some of the pushes move it: look at its cable, its power and its safety switch";
    case SelfTestReason::Fades:
      return "the later pushes moved it far less than the first: let its motors cool, hold it as loosely all the time, "
             "and "
             "try again";
    case SelfTestReason::NoExpiry:
      return "what it is told does not end by itself: if this program dies its force goes on; switch it off by its "
             "power switch";
    case SelfTestReason::TooFar:
      return "a gentle push moved it too far: rest a hand on it; if one did, the device may push the wrong way";
    case SelfTestReason::TooFast:
      return "it moved faster than a gentle push can: rest a hand on it";
    case SelfTestReason::NotFinite:
      return "the device gave a position that is no number";
    case SelfTestReason::Impossible:
      return "it shows positions where no hand can be: look at its cable and its power";
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
  std::string line = std::string(1, axisLetters[axis]) + ": " + text("%.3g mm", 1e3 * range_m);
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
    line += std::string(", measured by the driver's ") + axisLetters[found.sensor];
  }
  return line + (found.sign < 0 ? ", counted the other way" : "");
}

std::string held(const SelfTestPlan& plan, const SelfTestState& state, int motor)
{
  const HeldFinding found = findHeld(plan, state, motor);
  if (!plan.offersWalls || state.broke != HeldProof::Unfelt)
  {
    return {};
  }
  return text(", its own walls are %.2f", found.walls[0]) + text(" and %.2f of what they should be", found.walls[1]) +
         text(", while it brakes %.0f %%", 1e2 * found.braking[0]) +
         text(" and %.0f %% of the way are left", 1e2 * found.braking[1]);
}

std::string motorLine(const SelfTestPlan& plan, const SelfTestState& state, int motor, double strongest)
{
  const MotorFinding found = findMotor(plan, state, motor);
  std::string line = std::string("motor ") + axisLetters[motor] + ": ";
  if (found.motion == MotorMotion::None)
  {
    return line + text("moves nothing when it is asked for %.2g N", plan.push_N);
  }
  if (found.motion != MotorMotion::Clear)
  {
    return line + "does not do what it is asked for";
  }
  line += std::string("moves the driver's ") + axisLetters[found.sensor] +
          text(" by %.2g mm per N", 1e3 * found.response_m_per_N);
  line += found.sign < 0 ? ", the other way" : "";
  line += found.response_m_per_N < weakest * strongest ? ", weak beside the strongest" : "";
  return line + held(plan, state, motor);
}

std::string heldLine(const SelfTestPlan& plan, const SelfTestState& state)
{
  if (!plan.offersWalls)
  {
    return {};
  }
  const HeldProof proof = heldProofOf(plan, state);
  return proof == HeldProof::Felt ? "\nIts own walls hold from both sides of each axis, and it brakes: once this is "
                                    "kept, walls are left to it."
                                  : std::string("\nThe program closes its walls: ") + whyNotHeld(proof) + ".";
}

/// Of what ends by itself, and of what shakes.
std::string otherLines(const SelfTestPlan& plan, const SelfTestState& state)
{
  std::string lines;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const bool ended = endedByItself(plan, state, motor).value_or(false);
    lines = ended ? "\nWhat is not renewed ends by itself." : lines;
  }
  lines += state.shake == ShakeFinding::Seen     ? "\nIt shakes."
           : state.shake == ShakeFinding::Unseen ? "\nIts shaking moves it less than it can tell."
                                                 : "";
  return lines;
}

std::string linkLine(const LinkReport& link)
{
  return link.outOfRange > 0
           ? '\n' + std::to_string(link.outOfRange) + " of its positions were beyond what it says it can show."
           : "";
}

double strongestOf(const SelfTestPlan& plan, const SelfTestState& state)
{
  double strongest = 0.0;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const MotorFinding found = findMotor(plan, state, motor);
    strongest = found.motion == MotorMotion::Clear ? std::max(strongest, found.response_m_per_N) : strongest;
  }
  return strongest;
}

/// All axes with their motors.
std::string foundLines(const SelfTestPlan& plan, const SelfTestState& state)
{
  std::string lines = text(" At rest its position wanders by %.3g mm.", 1e3 * state.noise_m);
  lines += state.oneAxis ? "\nIt is a wheel: it moves along one axis only." : "";
  const double strongest = strongestOf(plan, state);
  for (int i = 0; i < plan.axes; ++i)
  {
    const bool there = i < state.axes(plan);
    lines += '\n' + (there ? axisLine(plan, state, i) + "; " : "") + motorLine(plan, state, i, strongest);
  }
  return lines + heldLine(plan, state) + otherLines(plan, state);
}

} // namespace

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
             " and hold it there." + (state.axis == 1 && plan.axes == 2 ? " A wheel that only turns: wait." : "");
    case SelfTestStage::Middle:
      return "Bring it to the middle and rest a relaxed hand on it.";
    case SelfTestStage::Settle:
    case SelfTestStage::Brace:
    case SelfTestStage::Push:
    case SelfTestStage::Rest:
      return "Let your hand rest on it, relaxed: it is pushed gently, to and fro.";
    case SelfTestStage::Shake:
      return "It shakes for a moment: let your hand rest on it.";
    case SelfTestStage::Done:
      break;
  }
  return {};
}

std::string resultOf(const SelfTestPlan& plan, const SelfTestState& state, const LinkReport& link)
{
  const bool knowsWhy = state.reason == SelfTestReason::Lost && !link.lostFor.empty();
  const std::string why = knowsWhy ? "the device was lost: " + link.lostFor : because(state.reason);
  switch (state.verdict)
  {
    case SelfTestVerdict::None:
      return {};
    case SelfTestVerdict::Inconclusive:
      return "Nothing was found out: " + why + '.' + linkLine(link);
    case SelfTestVerdict::Aborted:
      return "The check ended without force: " + why + '.' + linkLine(link);
    case SelfTestVerdict::Passed:
      return "The device works." + foundLines(plan, state) + linkLine(link);
    case SelfTestVerdict::Faulty:
      return "The device is faulty: " + why + '.' + foundLines(plan, state) + linkLine(link);
  }
  return {};
}

} // namespace palpate
