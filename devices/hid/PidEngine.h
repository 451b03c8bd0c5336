// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/Condition.h"
#include "devices/hid/EffectEngine.h"
#include "devices/hid/HidConnection.h"
#include "devices/hid/PidUsages.h"
#include "devices/hid/ReportDescriptor.h"

namespace palpate
{

/// What a device's conditions can express.
struct ConditionAbilities
{
  bool twoCoefficients = false; ///< one for each side of the centre
  bool deadBand = false;
  bool saturation = false;
};

[[nodiscard]] ConditionAbilities conditionAbilities(const ReportDescriptor& descriptor) noexcept;

/// How an effect is played. Written anew while it plays, it changes in place.
struct EffectSettings
{
  HidUsage type = pid::constantForce;
  int duration_ms = 200;               ///< it ends by itself unless it is started again
  double gain = 1.0;                   ///< share of the largest, 0 .. 1
  std::optional<double> direction_deg; ///< clockwise from -y: 90 is +x, 180 is +y; none: along the axes
  bool alongX = true;
  bool alongY = true;
};

/// What a device says about itself while it runs.
struct PidState
{
  bool actuatorsEnabled = true;
  bool paused = false;
  bool power = true;         ///< of its motors
  bool safetyClosed = false; ///< what must be held on it is held: a grip
  bool overrideOn = false;   ///< its own switch lets forces through
  bool playing = false;      ///< the effect of `block`
  int block = 0;             ///< 0 where the device does not say
};

/// The USB Physical Interface Devices protocol 1.0 with a pool of effects that the device manages. Reports, their
/// fields and the numbers of what is selected are found by usage in the device's own descriptor; a field that it does
/// not have is not written. Forces and positions are shares of the device's largest, -1 .. 1. Blocking: one thread, not
/// the servo's. Each bool says whether the device took the report.
class PidEngine final : public EffectEngine
{
public:
  /// Both must outlive the engine and stay where they are.
  PidEngine(HidConnection& connection, const ReportDescriptor& descriptor) noexcept;

  /// Why this descriptor is not that of a force-feedback device we can drive, or empty. Asks the device nothing.
  [[nodiscard]] static std::string refusal(const ReportDescriptor& descriptor);

  /// Asks for the pool, resets, enables the actuators, sets full gain. Empty, or why not.
  [[nodiscard]] std::string open();
  /// Stops everything, frees the effects it made and disables the actuators.
  void close() noexcept;

  [[nodiscard]] Created create(HidUsage type) override;
  [[nodiscard]] bool supports(HidUsage type) const noexcept;

  [[nodiscard]] bool setEffect(int block, const EffectSettings& settings) noexcept override;
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
