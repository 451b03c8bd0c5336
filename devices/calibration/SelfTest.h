// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "devices/calibration/GentlePush.h"
#include "devices/calibration/SelfTestRounds.h"
#include "haptics/core/DeviceCommand.h"
#include "haptics/core/DeviceInfo.h"
#include "haptics/core/DeviceSample.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/safety/DeadMan.h"

namespace palpate
{

/// Why no device whose kinematics are known is taken for a wheel.
inline constexpr const char* armIsNoWheel =
  "an arm is no wheel, because its kinematics say which axes it has: deselect the wheel option";

/// Limits of a self-test. Fixed while it runs.
struct SelfTestPlan
{
  int axes = 0;             ///< with force, 1 .. 3; 0: there is nothing to test
  bool wheel = false;       ///< the device has one axis, however many it says it has
  bool offersWalls = false; ///< with viscosity
  bool shakes = false;
  bool knowsAxes = false;         ///< each push must move the hand where it points; nobody is sent to the ends
  bool simulated = false;         ///< ticks may come late
  double effectsEndAfter_s = 0.0; ///< unless they are renewed; 0: they do not end
  double radius_m = 0.0;          ///< of the workspace, as it is assumed so far
  double resolution_m = 0.0;
  double push_N = 0.0;           ///< at most a tenth of the device's largest force; of an arm 0.5 N
  double stiffest_N_per_m = 0.0; ///< of the walls that the device holds
  double farthest_m = 0.0;       ///< a push that moves the hand further ends the test
  double fastest_m_per_s = 0.0;  ///< and so does a faster hand under force
  DeadMan deadMan;

  /// `wheel`: the person says that it is one.
  [[nodiscard]] static SelfTestPlan forDevice(
    const DeviceInfo& device, const DeadMan& deadMan = {}, bool wheel = false);
  /// Empty, or one sentence why this device cannot be tested.
  [[nodiscard]] std::string refusal() const;
};

/// Phases of the test, in this order; Settle to Rest again for each push of each motor.
enum class SelfTestStage : std::uint8_t
{
  Still,  ///< the hand holds still
  End,    ///< the hand goes to one end of an axis
  Middle, ///< the hand lets the device rest in the middle
  Settle, ///< the hand holds still before a push
  Brace,  ///< the device holds its wall where the hand is, or brakes, before a push against that
  Push,
  Rest,  ///< without force; the motion after the push is observed
  Shake, ///< the device vibrates
  Done,
};

enum class SelfTestVerdict : std::uint8_t
{
  None, ///< the test still runs
  Passed,
  Faulty,       ///< a motor does not move its axis, or not as a device should
  Inconclusive, ///< the hand did not follow the instruction, so there is no result
  Aborted,      ///< something unexpected: the force was taken away at once
};

/// Why it is not Passed.
enum class SelfTestReason : std::uint8_t
{
  None,
  NeverStill,   ///< the hand moves by itself
  NotMoved,     ///< nobody moved the device to the end that was asked for
  NotAlongAxis, ///< two ends of one axis do not lie along one axis of the device, or two axes share one
  NotInMiddle,  ///< the hand did not bring the device back
  PushUnclear,  ///< the motion did not match the pushes: the hand moves by itself
  NoMotion,     ///< a motor moves nothing
  BothAxes,     ///< one motor moves two axes
  SharedAxis,   ///< two motors move one axis
  AnswersLate,  ///< the axis moves after the push is over
  Sometimes,    ///< some pushes only move the axis
  Fades,        ///< the second push moved the axis much less
  NoExpiry,     ///< commands that are not renewed continue
  Reversed,     ///< of an arm: a push moves the hand the other way
  Turned,       ///< of an arm: a push moves the hand along another axis
  TooFar,
  TooFast,
  NotFinite,
  Impossible, ///< the hand is where or as fast as no hand can be
  Lost,
  Late, ///< the computer
  LetGo,
  Stopped, ///< by the person
  Silent,  ///< the device never said where the hand is
};

/// Pushes of one motor along both directions: [0] up, [1] down, each with the motion of all three axes.
using PushPair = std::array<std::array<PushAnswer, 3>, 2>;

/// Its effect along one axis. Real-time safe.
[[nodiscard]] inline const PushAnswer& along(const PushPair& answers, std::size_t direction, int axis) noexcept
{
  return answers[direction][static_cast<std::size_t>(axis)];
}

/// Twice, for values that must repeat.
struct MotorAnswers
{
  std::array<PushPair, 2> free{};
  std::array<PushPair, 2> walls{};
  std::array<PushPair, 2> braked{};
  PushPair corridor{}; ///< [0] into its wall, [1] away from it
  PushPair limited{};
  std::array<PushAnswer, 3> lapse{};
};

enum class ShakeFinding : std::uint8_t
{
  NotTried,
  Unseen, ///< the hand did not move with it
  Seen,
};

/// All that a self-test remembers. Copyable.
struct SelfTestState
{
  SelfTestStage stage = SelfTestStage::Still;
  SelfTestVerdict verdict = SelfTestVerdict::None;
  SelfTestReason reason = SelfTestReason::None;
  int axis = 0;    ///< End: of D. Settle, Push: the motor
  bool up = false; ///< End: the upper one
  int round = 0;   ///< of the pushes of one motor, in pushRounds
  double stage_s = 0.0;
  double waiting_s = 0.0; ///< for how long the device has not said where the hand is; 0: it says so

  double noise_m = 0.0;                  ///< how far the position wandered while the hand held still
  std::array<Vec3, 3> low_D{}, high_D{}; ///< where the hand was at the ends of each axis
  bool oneAxis = false;                  ///< of two nobody moved the second one
  std::array<MotorAnswers, 3> motors{};
  HeldProof broke = HeldProof::Unfelt; ///< the device's own walls moved the hand away: they are switched off
  ShakeFinding shake = ShakeFinding::NotTried;

  double still_s = 0.0; ///< for how long the position has not left the box from least_D to most_D
  Vec3 least_D = Vec3::Zero(), most_D = Vec3::Zero();
  Vec3 from_D = Vec3::Zero(); ///< where the stage began; in a push, where the hand rested
  Vec3 last_D = Vec3::Zero();
  Vec3 velocity_D = Vec3::Zero(); ///< smoothed [m/s]
  bool seen = false;              ///< last_D is of the tick before
  PushRecord record;

  /// Of the device, as far as they are there.
  [[nodiscard]] int axes(const SelfTestPlan& plan) const noexcept
  {
    return plan.wheel || this->oneAxis ? 1 : plan.axes;
  }
};

/// One tick of a self-test: (sample, plan, state) -> (state, command). Pure: no clock, no allocation, no lock. Without
/// a verdict yet the command is a push, or nothing; with one it is nothing. Real-time safe.
[[nodiscard]] DeviceCommand stepSelfTest(const SelfTestPlan& plan, const DeviceSample& sample, DeviceStatus status,
  double dt_s, SelfTestState& state) noexcept;

/// Ends the test without a result.
void stopSelfTest(SelfTestState& state) noexcept;

/// How much of the test is done, 0 .. 1.
[[nodiscard]] double selfTestProgress(const SelfTestPlan& plan, const SelfTestState& state) noexcept;

/// Target of a hand that follows the instructions, in D [m]: for simulated hands.
[[nodiscard]] Vec3 askedPlace_D(const SelfTestPlan& plan, const SelfTestState& state) noexcept;

} // namespace palpate
