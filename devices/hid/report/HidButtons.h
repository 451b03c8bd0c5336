// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// The buttons of one input report, in however many fields: a bit each, or the numbers of those that are down.
class HidButtons
{
public:
  HidButtons() = default;
  /// The report must outlive it and stay where it is.
  explicit HidButtons(const HidReport& report);

  [[nodiscard]] explicit operator bool() const noexcept { return !this->fields_.empty(); }
  [[nodiscard]] const HidReport& report() const noexcept { return *this->report_; }
  /// At most 32.
  [[nodiscard]] std::uint32_t count() const noexcept;
  /// Bit i: button i + 1 is down. `report` begins with its ID and is whole.
  [[nodiscard]] std::uint32_t down(std::span<const std::uint8_t> report) const noexcept;

private:
  [[nodiscard]] std::uint32_t down(const HidField& field, std::span<const std::uint8_t> report) const noexcept;

  const HidReport* report_ = nullptr;
  std::vector<const HidField*> fields_;
};

} // namespace palpate
