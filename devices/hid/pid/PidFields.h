// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate::pid
{

/// Fields of the reports of a PID device by their usage. Fields that a report lacks are not written; `bytes` begin with
/// its ID. Pure.

void put(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, std::int64_t value,
  HidUsage parent = 0) noexcept;
void putShare(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double share) noexcept;
void putSignedShare(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double share) noexcept;
void putTime(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double time_ms) noexcept;
/// All of its bits 1: none, or for ever.
void putAllOnes(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage) noexcept;
/// False: the report does not know it.
bool select(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage) noexcept;

[[nodiscard]] std::int64_t get(
  const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage, std::int64_t otherwise) noexcept;
/// The value of an array, or a bit of its own.
[[nodiscard]] bool says(const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage) noexcept;

} // namespace palpate::pid
