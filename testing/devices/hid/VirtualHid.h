// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate::test
{

/// The firmware of a virtual device, whatever it is plugged into.
class VirtualHid
{
public:
  virtual ~VirtualHid() = default;

  /// An output report, or a feature to be set. False: it is not one of its own.
  virtual bool take(HidReportKind kind, std::span<const std::uint8_t> bytes) = 0;
  /// A feature, or empty.
  [[nodiscard]] virtual std::vector<std::uint8_t> feature(std::uint8_t id) = 0;
  /// The oldest input report not yet read, or empty.
  [[nodiscard]] virtual std::vector<std::uint8_t> nextInput() = 0;
  /// A millisecond at a time.
  virtual void advance(int duration_ms) = 0;
};

} // namespace palpate::test
