// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "devices/hid/ReportDescriptor.h"

namespace palpate
{

/// The buttons of one input report: a bit each, or the numbers of those that are down.
class HidButtons
{
public:
  HidButtons() = default;
  /// The report must outlive it and stay where it is.
  explicit HidButtons(const HidReport& report) noexcept;

  [[nodiscard]] explicit operator bool() const noexcept { return this->field_ != nullptr; }
  [[nodiscard]] const HidReport& report() const noexcept { return *this->report_; }
  /// At most 32.
  [[nodiscard]] std::uint32_t count() const noexcept;
  /// Bit i: button i + 1 is down. `report` begins with its ID and is whole.
  [[nodiscard]] std::uint32_t down(std::span<const std::uint8_t> report) const noexcept;

private:
  [[nodiscard]] std::uint32_t bitOf(HidUsage usage) const noexcept;

  const HidReport* report_ = nullptr;
  const HidField* field_ = nullptr;
};

} // namespace palpate
