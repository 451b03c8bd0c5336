// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace palpate
{

/// Presence of a device, from the threads that notice changes to the servo, which misses no loss however short.
class Presence
{
public:
  /// Any thread but the servo's.
  void found() noexcept { this->live_ = true; }
  void lost() noexcept
  {
    this->live_ = false;
    ++this->losses_;
  }
  /// The device is released without a loss.
  void left() noexcept { this->live_ = false; }
  /// The device is present but does not accept commands.
  void stalled() noexcept { ++this->losses_; }
  [[nodiscard]] std::uint64_t losses() const noexcept { return this->losses_; }

  /// True if the device is present and was since the last call. Servo thread; wait-free.
  [[nodiscard]] bool steady() noexcept
  {
    const std::uint64_t losses = this->losses_.load(std::memory_order_acquire);
    const bool same = losses == this->seenLosses_;
    this->seenLosses_ = losses;
    return same && this->live_.load(std::memory_order_acquire);
  }

private:
  std::atomic<bool> live_ = false;
  std::atomic<std::uint64_t> losses_ = 0;
  std::uint64_t seenLosses_ = 0; ///< servo's
};

} // namespace palpate
