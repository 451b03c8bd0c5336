// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/FtdiByteLink.h"

#include <algorithm>

namespace palpate
{

int FtdiByteLink::receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept
{
  constexpr int ownBytes = 2;
  constexpr int shortest_ms = 3; // longer than the chip is silent: a transfer that is given up may lose its bytes
  std::array<std::uint8_t, 64> transfer; // as long as a packet: each packet has bytes of the chip's own
  for (int left_ms = timeout_ms; left_ms >= 0; --left_ms)
  {
    const int count = this->port_->read(transfer, std::max(shortest_ms, left_ms));
    if (count < 0)
    {
      return -1;
    }
    if (count > ownBytes)
    {
      const std::size_t taken = std::min(bytes.size(), static_cast<std::size_t>(count - ownBytes));
      std::copy_n(transfer.begin() + ownBytes, taken, bytes.begin());
      return static_cast<int>(taken);
    }
    left_ms = count == 0 ? 0 : left_ms; // all of the time has passed
  }
  return 0;
}

} // namespace palpate
