// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// Bits of a report, lowest first, wherever they lie. Bits beyond the bytes read as 0 and are not written.
/// `bitCount` is 1 to 64. Real-time safe.
[[nodiscard]] std::uint64_t extractBits(
  std::span<const std::uint8_t> bytes, std::size_t bit, std::uint32_t bitCount) noexcept;
void insertBits(std::span<std::uint8_t> bytes, std::size_t bit, std::uint32_t bitCount, std::uint64_t value) noexcept;

/// The value of an element: negative ones where its range has such. `report` begins with the ID. Real-time safe.
[[nodiscard]] std::int64_t readControl(const HidControl& control, std::span<const std::uint8_t> report) noexcept;

/// Writes a value into a report that begins with the ID: cut to its logical range, and no neighbour is touched.
void writeControl(const HidControl& control, std::span<std::uint8_t> report, std::int64_t value) noexcept;

/// Writes a value as it is. One outside the logical range means "none": the device leaves that control as it was.
void writeRaw(const HidControl& control, std::span<std::uint8_t> report, std::int64_t value) noexcept;

} // namespace palpate
