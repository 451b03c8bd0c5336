// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "devices/hid/report/HidButtons.h"
#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// The state of the hand in an input report.
struct PidHand
{
  std::array<double, 2> at{}; ///< shares along HID's axes, -1 .. 1
  std::uint32_t buttons = 0;  ///< bit i: button i + 1 is down
  bool outOfRange = false;    ///< a position beyond the range of the descriptor, cut to it
};

/// Reads the axes and buttons of a joystick from its input reports.
class PidInput
{
public:
  /// The descriptor must outlive it and stay where it is. With one axis a control called y is no part of the hand: a
  /// pedal of a wheel.
  explicit PidInput(const ReportDescriptor& descriptor, std::size_t axes = 2);

  /// It has an x axis at least.
  [[nodiscard]] bool usable() const noexcept { return static_cast<bool>(this->axes_[0]); }
  [[nodiscard]] bool hasTwoAxes() const noexcept { return static_cast<bool>(this->axes_[1]); }
  [[nodiscard]] std::uint32_t buttonCount() const noexcept { return this->buttons_.count(); }
  /// The smallest step of an axis as a share of half its travel.
  [[nodiscard]] double step() const noexcept;

  /// The hand, where `report`, as read, is the one with the axes. Another or a short one says nothing.
  [[nodiscard]] std::optional<PidHand> hand(std::span<const std::uint8_t> report) const noexcept;

private:
  std::array<HidControl, 2> axes_{};
  HidButtons buttons_;
};

} // namespace palpate
