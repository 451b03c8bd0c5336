// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"
#include "devices/hid/report/ReportItems.h"

namespace palpate
{

/// The items that describe a main item: global ones hold until they are changed, local ones for one main
/// item.
class ReportItemState
{
public:
  /// A range whose upper end is read without sign once the lower one turns out not to be negative: many descriptors
  /// write 255 in one byte, which would be -1.
  struct Range
  {
    ItemValue low;
    ItemValue high;

    [[nodiscard]] std::int64_t min() const noexcept { return this->low.withSign; }
    [[nodiscard]] std::int64_t max() const noexcept
    {
      return this->low.withSign >= 0 ? std::int64_t{ this->high.plain } : std::int64_t{ this->high.withSign };
    }
  };
  struct Global
  {
    std::uint32_t page = 0;
    Range logical;
    Range physical;
    int exponent = 0;
    std::uint32_t unit = 0;
    std::uint32_t bitCount = 0;
    std::uint32_t count = 0;
    std::uint8_t report = 0;
  };

  /// Takes a global or a local item. Empty, or why it cannot be.
  [[nodiscard]] std::string take(const ReportItem& item);
  /// Why a main item cannot follow, or empty.
  [[nodiscard]] std::string unfinished() const;
  /// A main item has used its local items.
  void forgetLocal() noexcept;

  [[nodiscard]] const Global& global() const noexcept { return this->global_; }
  [[nodiscard]] const std::vector<HidUsage>& usages() const noexcept { return this->usages_; }

private:
  [[nodiscard]] std::string takeGlobal(int tag, const ItemValue& value);
  [[nodiscard]] std::string takeReport(int tag, const ItemValue& value);
  [[nodiscard]] std::string takeLocal(int tag, const ItemValue& value);
  [[nodiscard]] std::string setReport(const ItemValue& value);
  [[nodiscard]] std::string push();
  [[nodiscard]] std::string pop();
  [[nodiscard]] std::string closeRange();
  [[nodiscard]] std::string addUsages(HidUsage first, HidUsage last);
  [[nodiscard]] HidUsage usageOf(const ItemValue& value) const noexcept;

  Global global_;
  std::vector<Global> pushed_;
  std::vector<HidUsage> usages_;
  std::optional<HidUsage> rangeStart_, rangeEnd_; ///< of a range that has one of them so far
};

} // namespace palpate
