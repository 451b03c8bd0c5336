// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/ReportItems.h"

namespace palpate
{

std::optional<ReportItem> ReportItems::next()
{
  constexpr std::uint8_t longItem = 0xFE;
  while (this->at_ < this->bytes_.size() && this->problem_.empty())
  {
    this->begin_ = this->at_;
    const std::uint8_t prefix = this->bytes_[this->at_++];
    if (prefix == longItem)
    {
      this->skipLongItem();
      continue;
    }
    const std::size_t size = (prefix & 3) == 3 ? 4 : prefix & 3;
    if (size > this->bytes_.size() - this->at_)
    {
      this->problem_ = "an item runs past the end";
      break;
    }
    const auto type = static_cast<ReportItem::Type>((prefix >> 2) & 3);
    return ReportItem{ type, prefix >> 4, this->valueOf(size) };
  }
  return std::nullopt;
}

/// Its second byte says how many follow its tag; no meaning has ever been given to one.
void ReportItems::skipLongItem()
{
  const std::size_t left = this->bytes_.size() - this->at_;
  if (left < 2 || left - 2 < this->bytes_[this->at_])
  {
    this->problem_ = "a long item runs past the end";
    return;
  }
  this->at_ += 2 + std::size_t{ this->bytes_[this->at_] };
}

ItemValue ReportItems::valueOf(std::size_t size) noexcept
{
  ItemValue value{ 0, 0, size };
  for (std::size_t i = 0; i < size; ++i)
  {
    value.plain |= std::uint32_t{ this->bytes_[this->at_++] } << (8 * i);
  }
  const auto unusedBits = static_cast<std::uint32_t>(32 - 8 * size);
  value.withSign = size == 0 ? 0 : static_cast<std::int32_t>(value.plain << unusedBits) >> unusedBits;
  return value;
}

} // namespace palpate
