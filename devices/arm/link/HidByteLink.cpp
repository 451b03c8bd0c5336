// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/HidByteLink.h"

#include <algorithm>

namespace palpate
{

bool HidByteLink::send(std::span<const std::uint8_t> bytes) noexcept
{
  if (bytes.size() >= this->report_.size())
  {
    return false;
  }
  std::fill(this->report_.begin(), this->report_.end(), std::uint8_t{ 0 });
  std::copy(bytes.begin(), bytes.end(), this->report_.begin() + 1);
  return this->connection_->write(this->report_);
}

} // namespace palpate
