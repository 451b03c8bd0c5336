// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "devices/common/Condition.h"
#include "devices/hid/report/ReportDescriptor.h"
#include "testing/devices/hid/PidLayout.h"
#include "testing/devices/hid/VirtualHandle.h"
#include "testing/devices/hid/VirtualHid.h"

namespace palpate::test
{

/// A force-feedback joystick without any hardware: its firmware takes the reports of a layout, keeps a pool of effects,
/// runs them at 1 kHz and lets them expire.
class VirtualPidDevice final
  : public VirtualHid
  , public VirtualHandle
{
public:
  /// Force of a condition's coefficient of 1 at a distance of 1: full force at a tenth of half the travel.
  static constexpr double springGain = 10.0;
  /// A damper's metric, as a share of the speed in half travels a second.
  static constexpr double damperMetric = 0.2;
  /// Force of the spring to the centre at a distance of 1.
  static constexpr double centringGain = 0.5;

  explicit VirtualPidDevice(const PidLayout& layout);

  /// An output report, or a feature to be set. False: unknown, short or for a block that is not there.
  bool take(HidReportKind kind, std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t id) override;
  [[nodiscard]] std::vector<std::uint8_t> nextInput() override;
  /// Firmware and handle.
  void advance(int duration_ms) override;

  /// The effect of the kernel's own driver on it once a program uploads an effect: reset, enable, an effect of its own.
  void uploadFromElsewhere();

  /// Shows the host an input report, whatever it says.
  void show(std::vector<std::uint8_t> report) { this->inputs_.push_back(std::move(report)); }

  /// Of all effects now [shares].
  [[nodiscard]] Axes force() const;

  std::uint8_t buttons = 0;
  bool silent = false;                                ///< it shows nothing of the handle
  int slowLoads = 0;                                  ///< so many block loads say nothing yet
  std::optional<std::vector<std::uint8_t>> wrongLoad; ///< answer of a block load instead

  int badReports = 0, outputs = 0, stopAlls = 0, resets = 0, constantForces = 0, conditions = 0;
  double gain = 1.0;
  bool actuators = false;
  [[nodiscard]] int effectsUsed() const;
  [[nodiscard]] int effectsPlaying() const;
  [[nodiscard]] const PidLayout& layout() const noexcept { return this->layout_; }
  [[nodiscard]] bool centring() const noexcept { return this->centring_; }
  /// Of the effect in a block, 1 and up, along an axis: its last numbers.
  [[nodiscard]] const Condition& condition(int block, int axis) const;

private:
  struct Effect
  {
    bool allocated = false, playing = false, directed = false, set = false;
    std::uint8_t type = 0;
    std::int64_t trigger = noTrigger;
    std::int64_t duration_ms = 0, age_ms = 0;
    double gain = 1.0, direction_deg = 0.0, constant = 0.0, magnitude = 0.0, period_ms = 1.0;
    std::array<bool, 2> axes{};
    std::array<Condition, 2> told{}, conditions{}; ///< the last ones, and those that it acts by
    std::array<double, 2> signs{ 1.0, 1.0 };       ///< of the forces of its conditions
  };
  static constexpr std::int64_t noTrigger = 255;

  [[nodiscard]] std::int64_t number(
    const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage, HidUsage parent = 0) const;
  [[nodiscard]] std::uint8_t chosen(const std::vector<std::uint8_t>& order, std::int64_t number) const;
  void create(const HidReport& report, std::span<const std::uint8_t> bytes);
  void create(std::uint8_t type);
  bool takeEffect(const HidReport& report, std::span<const std::uint8_t> bytes);
  void setEffect(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes);
  bool setCondition(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes);
  void operate(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes);
  void control(const HidReport& report, std::span<const std::uint8_t> bytes);
  void control(std::uint8_t usage);
  void settle(Effect& effect);
  void play(Effect& effect, bool playing);
  void stopAll();
  void reset();
  void pullTrigger();
  void showState(int block, bool playing);
  void showInput();
  [[nodiscard]] double effectForce(const Effect& effect, std::size_t axis) const;

  PidLayout layout_;
  ReportDescriptor descriptor_;
  std::vector<Effect> effects_;
  std::deque<std::vector<std::uint8_t>> inputs_;
  int lastBlock_ = 0;
  bool centring_ = false;
  std::uint8_t buttonsBefore_ = 0;
  std::uint8_t lastStatus_ = 0;
};

} // namespace palpate::test
