// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace palpate
{

/// A number of an item as it stands and with its sign.
struct ItemValue
{
  std::uint32_t plain = 0;
  std::int32_t withSign = 0;
  std::size_t bytes = 0;
};

struct ReportItem
{
  enum class Type : std::uint8_t
  {
    Main,
    Global,
    Local,
    Reserved,
  };
  Type type = Type::Main;
  int tag = 0;
  ItemValue value;
};

/// The items of a report descriptor one after the other (Device Class Definition for HID 1.11, section 6.2.2).
class ReportItems
{
public:
  explicit ReportItems(std::span<const std::uint8_t> bytes) noexcept : bytes_(bytes) {}

  /// The next one; none at the end, and where the bytes are cut.
  [[nodiscard]] std::optional<ReportItem> next();
  /// Where the newest item begins.
  [[nodiscard]] std::size_t begin() const noexcept { return this->begin_; }
  /// Empty, or why there are no more.
  [[nodiscard]] const std::string& problem() const noexcept { return this->problem_; }

private:
  void skipLongItem();
  [[nodiscard]] ItemValue valueOf(std::size_t size) noexcept;

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::string problem_;
};

} // namespace palpate
