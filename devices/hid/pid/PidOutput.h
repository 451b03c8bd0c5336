// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "devices/common/HeldTrust.h"
#include "devices/hid/Rumble.h"
#include "devices/hid/pid/PidEngine.h"
#include "devices/hid/pid/PidKind.h"
#include "devices/hid/pid/PidShake.h"
#include "devices/hid/pid/PidStep.h"
#include "devices/hid/pid/PidWalls.h"
#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// How a joystick is driven. The times are those of the safety rules (docs/faults.md).
struct PidOutputOptions
{
  PidScale scale;
  double largestShare = 0.6; ///< of the device's force, for walls in its own loop or for the link
  int duration_ms = 200;     ///< of every effect: a program that dies leaves no force behind
  int restartEvery_ms = 100;
  int wallsEvery_ms = 16; ///< at most that often
  int silence_ms = 20;    ///< without a new command everything stops
  int rampUp_ms = 1000;   ///< of walls in the device's own loop, from the first request for force on
  HeldTrust trust;        ///< before anybody says otherwise
};

/// A device may have to push for it.
[[nodiscard]] inline bool asksForForce(const DeviceCommand& command) noexcept
{
  return command.wallCount > 0 || command.viscosity_Ns_per_m > 0.0 || command.wrench_D.force != Vec3::Zero();
}

/// Decides which one report to send next so that a device follows the newest command, at whatever rate its link takes
/// reports: a start that is due, then walls and viscosity where they changed, then the force axis by axis. The order is
/// that of Windows: an effect's settings again after its conditions, actuators enabled again after a stop of all. Not
/// real-time; one thread.
class PidOutput
{
public:
  /// With one axis, a wheel, nothing is ever sent for y: some firmwares would turn a y into an x. With no axis a push
  /// is felt as vibration.
  PidOutput(EffectEngine& engine, const PidOutputOptions& options, const PidKind& kind) noexcept;

  /// Makes the effects. Empty, or why the device gives no force at all.
  [[nodiscard]] std::string begin();
  /// The offers of the device, now that its effects are made.
  [[nodiscard]] DeviceAbilities abilities() const noexcept;

  /// The present request: the newest command, its number, the position of the handle, and the trusted walls.
  struct Wish
  {
    DeviceCommand command;
    std::uint64_t beat = 0;
    Vec3 p_D = Vec3::Zero(); ///< [m]
    HeldTrust trust;
  };
  using Step = PidStep;
  [[nodiscard]] Step step(std::int64_t now_ns, const Wish& wish) noexcept;

  /// Everything was stopped because no new command came.
  [[nodiscard]] bool silent() const noexcept { return this->silent_; }
  /// The device has had time to say that its actuators are on, and should not say anything else.
  [[nodiscard]] bool shouldBeOn(std::int64_t now_ns) const noexcept;
  /// An effect that should be playing, and that the device should not report as stopped: reports of the stops that were
  /// sent to it have had time to come.
  [[nodiscard]] bool shouldPlay(int block, std::int64_t now_ns) const noexcept;
  /// Effects that were armed again before they ended.
  [[nodiscard]] std::uint64_t restarts() const noexcept { return this->restarts_ + this->shake_.restarts(); }

private:
  struct Effect
  {
    EffectSettings settings;
    int block = 0; ///< 0: the device has none
    std::int64_t started_ns = never;
    std::int64_t stopped_ns = never; ///< when a stop was sent to it last
    bool lapses = false;             ///< it is not renewed, so it ends by itself
    bool lingers = false;            ///< stopped with all others, not yet by itself
    bool unsettled = false;          ///< its conditions changed after its settings were sent
  };
  static constexpr std::int64_t never = -1;
  using Conditions = std::array<Condition, 4>; ///< the springs of the x and the y axis, then their dampers

  [[nodiscard]] std::string make(Effect& effect, HidUsage type, double comesFrom_deg);
  [[nodiscard]] std::string makeForces();
  void makeConditions();
  [[nodiscard]] bool makeCondition(Effect& effect, HidUsage type);
  [[nodiscard]] std::array<Effect*, 4> effects() noexcept;
  [[nodiscard]] bool fallsSilent(std::int64_t now_ns, std::uint64_t beat) noexcept;
  void allStopped(std::int64_t now_ns) noexcept;
  [[nodiscard]] Step stop(Effect& effect, std::int64_t now_ns) noexcept;
  [[nodiscard]] Step endLingering(std::int64_t now_ns) noexcept;
  [[nodiscard]] Step enable(std::int64_t now_ns) noexcept;
  [[nodiscard]] Step restart(std::int64_t now_ns, const Wish& wish) noexcept;
  [[nodiscard]] Step sendWalls(std::int64_t now_ns, const Wish& wish) noexcept;
  [[nodiscard]] Step sendCondition() noexcept;
  [[nodiscard]] Step sendForce(const Wish& wish) noexcept;
  [[nodiscard]] double rampedShare(std::int64_t now_ns, const DeviceCommand& command) noexcept;

  EffectEngine& engine_;
  PidOutputOptions options_;
  PidKind kind_;
  ConditionAbilities conditions_; ///< none without the effect that has them
  std::array<Effect, 2> forces_{};
  Effect spring_, damper_; ///< a condition for each axis
  PidShake shake_;
  Rumble rumble_;
  Conditions wanted_{}, sent_{};
  std::size_t turn_ = 0; ///< of the conditions: whose it is
  std::array<std::int64_t, 2> sentForce_{};
  int lastAxis_ = 1;
  WallPlan plan_;
  std::int64_t wallsSent_ns_ = never;
  std::int64_t askedSince_ns_ = never; ///< since when force has been asked for
  std::uint64_t restarts_ = 0;
  std::uint64_t beat_ = 0;
  std::int64_t beat_ns_ = never;
  bool silent_ = false;
  bool enabled_ = true; ///< its actuators; it was just opened
  std::int64_t enabled_ns_ = never;
};

} // namespace palpate
