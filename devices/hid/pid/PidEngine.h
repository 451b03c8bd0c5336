// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/common/Condition.h"
#include "devices/hid/EffectEngine.h"
#include "devices/hid/HidConnection.h"
#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// Abilities of a device's conditions.
struct ConditionAbilities
{
  bool twoCoefficients = false; ///< one for each side of the centre
  bool deadBand = false;
  bool saturation = false;
};

[[nodiscard]] ConditionAbilities conditionAbilities(const ReportDescriptor& descriptor) noexcept;

/// How an effect is played. Written anew while it plays, it changes in place. The angle says where a force comes from,
/// clockwise from north, which is away from the person: 270 pushes to +x, 90 to -x, 0 to +y of HID, towards the person.
/// So do Windows, Linux and the firmwares whose sources are public. With conditions it is 90, as sent by Windows: some
/// firmwares take a sign for each axis from it.
struct EffectSettings
{
  HidUsage type = pid::constantForce;
  int duration_ms = 200; ///< it ends by itself unless it is started again
  double gain = 1.0;     ///< share of the largest, 0 .. 1
  double comesFrom_deg = 90.0;
};

/// The state that a device reports while it runs.
struct PidState
{
  bool actuatorsEnabled = true;
  bool paused = false;
  bool power = true;         ///< of its motors
  bool safetyClosed = false; ///< its dead-man switch is held: a grip
  bool overrideOn = false;   ///< its own switch lets forces through
  bool playing = false;      ///< the effect of `block`
  int block = 0;             ///< 0 where the device does not say
};

/// The USB Physical Interface Devices protocol 1.0 with a pool of effects that the device manages. Reports, their
/// fields and the numbers of selectors are found by usage in the device's own descriptor; a field that it does not have
/// is not written. Forces and positions are shares of the device's largest, -1 .. 1. Blocking: one thread, not the
/// servo's. Each bool says whether the device took the report.
class PidEngine final : public EffectEngine
{
public:
  /// Both must outlive the engine and stay where they are.
  PidEngine(HidConnection& connection, const ReportDescriptor& descriptor) noexcept;

  /// Why this descriptor is not that of a force-feedback device we can drive, or empty. Asks the device nothing.
  [[nodiscard]] static std::string refusal(const ReportDescriptor& descriptor);

  /// Asks for the pool, which on some devices frees all effects; resets; stops everything, which switches off the
  /// spring to the centre that some sticks have after a reset; enables the actuators; sets full gain. Empty, or why
  /// not.
  [[nodiscard]] std::string open();
  /// Stops everything, frees the engine's effects, disables the actuators, and resets: a stick that has a spring to its
  /// centre when it is plugged in has it again. PID cannot tell whether somebody had switched that off before.
  void close() noexcept;

  [[nodiscard]] Created create(HidUsage type) override;
  [[nodiscard]] bool supports(HidUsage type) const noexcept;

  /// With Direction Enable alone, the bits of the axes 0, and no trigger button: all ones. 0 would be a button to some
  /// firmwares, which play the effect again whenever it is pressed.
  [[nodiscard]] bool setEffect(int block, const EffectSettings& settings) noexcept override;
  /// One axis, 0 or 1, of a spring or a damper; centre, dead band, coefficients and saturations as shares. Some
  /// firmwares know it before the next setEffect() only, others forget settings before the first one.
  [[nodiscard]] bool setCondition(int block, int axis, const Condition& condition) noexcept override;
  [[nodiscard]] bool setConstantForce(int block, double share) noexcept override;
  [[nodiscard]] bool setPeriodic(int block, double magnitude, double period_ms) noexcept override;
  /// Starting a playing effect restarts its clock; that this is not felt is assumed of every firmware and was not
  /// checked on a real one.
  [[nodiscard]] bool start(int block) noexcept override { return this->operate(block, pid::start); }
  [[nodiscard]] bool startSolo(int block) noexcept { return this->operate(block, pid::startSolo); }
  [[nodiscard]] bool stop(int block) noexcept override { return this->operate(block, pid::stop); }
  [[nodiscard]] bool free(int block) noexcept;
  [[nodiscard]] bool control(HidUsage what) noexcept override;
  [[nodiscard]] bool setGain(double share) noexcept;

  /// It can tell whether it is gripped.
  [[nodiscard]] static bool hasSafetySwitch(const ReportDescriptor& descriptor) noexcept;

  [[nodiscard]] std::string error() const override { return this->connection_.error(); }

  /// The device's answer about the effect that was made last, whoever made it: its block, and the memory left. Two
  /// answers differ once somebody else has made or wiped effects. Without the ID, which some devices clear when they
  /// have answered once; empty: it does not answer.
  [[nodiscard]] std::vector<std::uint8_t> lastLoad() noexcept;

  /// The state, where `report`, as read, is one.
  [[nodiscard]] std::optional<PidState> state(std::span<const std::uint8_t> report) const noexcept;

  [[nodiscard]] std::int64_t constantForceSteps(double share) const noexcept override;

private:
  /// An output report that is being filled.
  struct Draft
  {
    const HidReport* report = nullptr;
    std::vector<std::uint8_t> bytes;
  };
  [[nodiscard]] Draft draft(HidUsage collection, int block) const;
  [[nodiscard]] bool send(const Draft& draft) noexcept;
  [[nodiscard]] bool operate(int block, HidUsage what) noexcept;
  [[nodiscard]] std::string askForPool();
  [[nodiscard]] std::string request(HidUsage type);
  [[nodiscard]] Created awaitBlock();
  [[nodiscard]] std::string getFeature(const HidReport& report, std::vector<std::uint8_t>& bytes);

  HidConnection& connection_;
  const ReportDescriptor& descriptor_;
  std::vector<int> blocks_; ///< made and not freed
};

} // namespace palpate
