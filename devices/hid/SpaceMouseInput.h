// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "devices/hid/report/HidButtons.h"
#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// How the cap of a SpaceMouse is pressed out of its rest.
struct Cap
{
  std::array<double, 6> at{}; ///< x, y, z, and the turns about them: shares along HID's axes, -1 .. 1
  std::uint32_t buttons = 0;  ///< bit i: button i + 1 is down
};

/// Reads a multi-axis controller with six axes (USB HID Usage Tables, generic desktop page, usage 8). The axes may come
/// in one report or in two, and the buttons in a third; each says only its part. Whether an axis calls itself
/// relative does not matter: both kinds give how far the cap is from its rest.
class SpaceMouseInput
{
public:
  /// The descriptor must outlive it and stay where it is.
  explicit SpaceMouseInput(const ReportDescriptor& descriptor) noexcept;

  /// Whether this is a SpaceMouse, usable or not.
  [[nodiscard]] static bool describes(const ReportDescriptor& descriptor) noexcept;
  /// Why it cannot be used, or empty.
  [[nodiscard]] std::string refusal() const;
  [[nodiscard]] std::uint32_t buttonCount() const noexcept;

  enum class Said : std::uint8_t
  {
    Nothing,    ///< another report, or a short one
    Part,       ///< its part of the cap
    OutOfRange, ///< the same, cut to the range of the descriptor
  };
  /// Reads the values of `report` into `cap`.
  [[nodiscard]] Said take(std::span<const std::uint8_t> report, Cap& cap) const noexcept;

private:
  bool numbered_ = false;
  std::array<HidControl, 6> axes_{};
  std::vector<HidButtons> buttons_; ///< each report has its own
};

} // namespace palpate
