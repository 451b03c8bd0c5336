// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <string>

#include "devices/evdev/EvdevKind.h"
#include "devices/hid/pid/PidInput.h"

namespace palpate
{

/// Reads axes and buttons of a joystick from its events. One thread.
class EvdevInput
{
public:
  /// `connection` must outlive it.
  EvdevInput(const EvdevKind& kind, EvdevConnection& connection);

  /// Asks for the ranges and where everything is. Empty, or why its axes cannot be read.
  [[nodiscard]] std::string begin();
  /// The smallest step of an axis as a share of half its travel.
  [[nodiscard]] double step() const noexcept;

  /// True: a report has ended, and hand() is as it says. Events that the kernel had to drop are made up for by asking.
  [[nodiscard]] bool take(const input_event& event) noexcept;
  /// None: the device has not said yet where the hand is. Until it does the kernel has 0 for every axis, which for most
  /// is an end.
  [[nodiscard]] std::optional<PidHand> hand() const noexcept;

private:
  void ask() noexcept;
  [[nodiscard]] std::uint32_t buttonsDown() const noexcept;

  EvdevKind kind_;
  EvdevConnection& connection_;
  std::array<input_absinfo, 2> axes_{}; ///< the newest value among it
  std::bitset<KEY_CNT> keys_;
  bool known_ = false;
  bool dropped_ = false; ///< until the end of the report nothing is as it was
};

} // namespace palpate
