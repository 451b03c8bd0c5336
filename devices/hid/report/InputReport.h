// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace palpate
{

/// An input report as read, with its ID in front: a device without IDs sends none, so it gets the 0 that is left out.
class InputReport
{
public:
  static constexpr std::size_t longest = 2049;

  InputReport(bool numbered, std::span<const std::uint8_t> read) noexcept
  {
    if (numbered || read.size() >= longest)
    {
      this->bytes_ = read;
      return;
    }
    this->whole_[0] = 0;
    std::copy(read.begin(), read.end(), this->whole_.begin() + 1);
    this->bytes_ = { this->whole_.data(), read.size() + 1 };
  }
  InputReport(const InputReport&) = delete;
  InputReport& operator=(const InputReport&) = delete;

  [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return this->bytes_; }
  /// Whether this is that report, whole.
  [[nodiscard]] bool is(std::uint8_t id, std::size_t length) const noexcept
  {
    return !this->bytes_.empty() && this->bytes_[0] == id && this->bytes_.size() >= length;
  }

private:
  std::array<std::uint8_t, longest> whole_;
  std::span<const std::uint8_t> bytes_;
};

} // namespace palpate
