// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate::test
{

/// Writes the items of a report descriptor one by one, each in the fewest bytes that hold its number.
class DescriptorWriter
{
public:
  static constexpr std::uint8_t data = 0x00, constant = 0x01, array = 0x00, variable = 0x02;

  /// Item of a kind (0 main, 1 global, 2 local) with a number in that many bytes: 0, 1, 2 or 4.
  DescriptorWriter& item(int type, int tag, std::uint32_t value, int bytes);
  /// In as few bytes as keep its sign.
  DescriptorWriter& number(int type, int tag, std::int64_t value);

  DescriptorWriter& page(std::uint16_t id) { return this->number(1, 0, id); }
  DescriptorWriter& reportId(std::uint8_t id) { return this->item(1, 8, id, 1); }
  DescriptorWriter& logical(std::int64_t min, std::int64_t max);
  DescriptorWriter& physical(std::int64_t min, std::int64_t max);
  DescriptorWriter& exponent(int power) { return this->item(1, 5, static_cast<std::uint32_t>(power) & 0xF, 1); }
  DescriptorWriter& unit(std::uint32_t code) { return this->number(1, 6, code); }
  DescriptorWriter& size(std::uint32_t bits, std::uint32_t count = 1);
  /// Of the page in force.
  DescriptorWriter& usage(std::uint16_t id);
  /// With its own page, in four bytes.
  DescriptorWriter& wideUsage(HidUsage usage) { return this->item(2, 0, usage, 4); }
  DescriptorWriter& usages(std::initializer_list<std::uint16_t> ids);
  DescriptorWriter& usageRange(std::uint16_t first, std::uint16_t last);
  /// 0 physical, 1 application, 2 logical.
  DescriptorWriter& begin(std::uint8_t kind = 2) { return this->item(0, 10, kind, 1); }
  DescriptorWriter& end() { return this->item(0, 12, 0, 0); }
  DescriptorWriter& main(HidReportKind kind, std::uint8_t flags);

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return this->bytes_; }

private:
  std::vector<std::uint8_t> bytes_;
};

} // namespace palpate::test
