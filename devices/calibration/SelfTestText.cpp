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
      return "the hand moved during the measurement: rest your hand on the device and try again";
    case SelfTestReason::NotMoved:
      return "the handle was not moved to the requested end, or the device does not measure that axis";
    case SelfTestReason::NotAlongAxis:
      return "the two ends of one axis do not lie along one axis of the device: move the handle straight from end to "
             "end";
    case SelfTestReason::NotInMiddle:
      return "the handle was not moved back to the middle";
    case SelfTestReason::PushUnclear:
      return "the hand moved against the pushes: rest your hand, hold the device loosely, and try again";
    case SelfTestReason::NoMotion:
      return "a motor moves nothing; if the device is a wheel, select the wheel option and try again";
    case SelfTestReason::BothAxes:
      return "one push moves two axes at once: the motors are coupled, or the firmware mixes directions";
    case SelfTestReason::SharedAxis:
      return "two motors move the same axis; if the device is a wheel, select the wheel option and try again";
    case SelfTestReason::AnswersLate:
      return "The device reacts only after the force pulse has ended. With that latency no closed-loop force is safe";
    case SelfTestReason::Sometimes:
      return "only some pushes move the device: check its cable, power supply and safety switch";
    case SelfTestReason::Fades:
      return "the later pushes moved the device far less than the first: let the motors cool, hold the device equally "
             "loosely throughout, and try again";
    case SelfTestReason::NoExpiry:
      return "force commands do not expire: if this program stops, the force continues; switch the device off with its "
             "power switch";
    case SelfTestReason::Reversed:
      return "a push moves the handle against its direction: a motor or an encoder of the arm is reversed, or the arm "
             "is described by the file of another arm";
    case SelfTestReason::Turned:
      return "a push moves the hand along another axis: motors or encoders of the arm are mixed, or the "
             "arm is described by the file of another arm";
    case SelfTestReason::TooFar:
      return "a gentle push moved the device too far: rest a hand on it; if a hand did rest on it, the device may push "
             "in the wrong direction";
    case SelfTestReason::TooFast:
      return "the device moved faster than a gentle push allows: rest a hand on it";
    case SelfTestReason::NotFinite:
      return "the device reported a position that is not a finite number";
    case SelfTestReason::Impossible:
      return "the device reports impossible positions: check its cable and power supply";
    case SelfTestReason::Lost:
      return "the device no longer answers: check its cable";
    case SelfTestReason::Late:
      return "the computer was too busy for timed pushes: close other programs and try again";
    case SelfTestReason::LetGo:
      return "the dead-man switch was released";
    case SelfTestReason::Stopped:
      return "the check was stopped";
    case SelfTestReason::Silent:
      return "the device has not reported a position: move the handle until it does, and try again";
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
    line += text(", less than half of the %.3g mm in its description", 2e3 * plan.radius_m);
  }
  if (found.sensor != axis)
  {
    line += std::string(", measured by the driver's ") + axisLetters[found.sensor];
  }
  return line + (found.sign < 0 ? ", with reversed sign" : "");
}

std::string held(const SelfTestPlan& plan, const SelfTestState& state, int motor)
{
  const HeldFinding found = findHeld(plan, state, motor);
  if (!plan.offersWalls || state.broke != HeldProof::Unfelt)
  {
    return {};
  }
  return text(", its own walls are %.2f", found.walls[0]) +
         text(" and %.2f of the requested stiffness", found.walls[1]) +
         text(", while the viscosity leaves %.0f %%", 1e2 * found.braking[0]) +
         text(" and %.0f %% of the displacement", 1e2 * found.braking[1]);
}

std::string motorLine(const SelfTestPlan& plan, const SelfTestState& state, int motor, double strongest)
{
  const MotorFinding found = findMotor(plan, state, motor);
  std::string line = std::string("motor ") + axisLetters[motor] + ": ";
  if (found.motion == MotorMotion::None)
  {
    return line + text("moves nothing at %.2g N", plan.push_N);
  }
  if (found.motion != MotorMotion::Clear)
  {
    return line + "does not follow its commands";
  }
  line += std::string("moves the driver's ") + axisLetters[found.sensor] +
          text(" by %.2g mm per N", 1e3 * found.response_m_per_N);
  line += found.sign < 0 ? ", in the reverse direction" : "";
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
  return proof == HeldProof::Felt ? "\nThe device's own walls work from both sides of each axis, with viscosity: after "
                                    "saving, the device holds walls itself."
                                  : std::string("\nThe program renders the walls: ") + whyNotHeld(proof) + ".";
}

/// Sentences on effects that end by themselves, and on vibration.
std::string otherLines(const SelfTestPlan& plan, const SelfTestState& state)
{
  std::string lines;
  for (int motor = 0; motor < plan.axes; ++motor)
  {
    const bool ended = endedByItself(plan, state, motor).value_or(false);
    lines = ended ? "\nForce commands that are not renewed expire." : lines;
  }
  lines += state.shake == ShakeFinding::Seen     ? "\nThe device can vibrate."
           : state.shake == ShakeFinding::Unseen ? "\nIts vibration is smaller than its own position resolution."
                                                 : "";
  return lines;
}

std::string linkLine(const LinkReport& link)
{
  return link.outOfRange > 0
           ? '\n' + std::to_string(link.outOfRange) + " of its positions were outside the range in its description."
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
  lines += state.oneAxis ? "\nThe device is a wheel: one axis of motion." : "";
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
    return "The device has not reported a position yet: move the handle.";
  }
  switch (state.stage)
  {
    case SelfTestStage::Still:
      return "Hold the handle still.";
    case SelfTestStage::End:
      return (plan.wheel ? "Turn the wheel to its end " : "Move the handle to its end ") + endName(plan, state) +
             " and hold it there." + (state.axis == 1 && plan.axes == 2 ? " With a wheel: wait." : "");
    case SelfTestStage::Middle:
      return "Move the handle to the middle and rest a relaxed hand on it.";
    case SelfTestStage::Settle:
    case SelfTestStage::Brace:
    case SelfTestStage::Push:
    case SelfTestStage::Rest:
      return "Rest a relaxed hand on the handle: the device pushes gently to and fro.";
    case SelfTestStage::Shake:
      return "The device vibrates for a moment: rest your hand on the handle.";
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
      return "No result: " + why + '.' + linkLine(link);
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
