// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace palpate
{

/// Finds for the reader of a device that its writer hangs in the system, once each time.
class WriterWatch
{
public:
  static constexpr std::int64_t stuckAfter_ns = 50000000;

  /// Writer thread, around a call that may hang.
  void begins(std::int64_t now_ns) noexcept { this->since_ns_ = now_ns; }
  void ends() noexcept { this->since_ns_ = notWriting; }

  /// True when it has just become clear that the writer hangs. Reader thread.
  [[nodiscard]] bool hasStalled(std::int64_t now_ns) noexcept
  {
    const std::int64_t since_ns = this->since_ns_;
    const bool stuck = since_ns != notWriting && now_ns - since_ns > stuckAfter_ns;
    const bool news = stuck && !this->stuck_;
    this->stuck_ = stuck;
    this->stalls_ += news ? 1 : 0;
    return news;
  }
  /// Any thread.
  [[nodiscard]] std::uint64_t stalls() const noexcept { return this->stalls_; }

private:
  static constexpr std::int64_t notWriting = -1;
  std::atomic<std::int64_t> since_ns_ = notWriting;
  std::atomic<std::uint64_t> stalls_ = 0;
  bool stuck_ = false; ///< reader's
};

} // namespace palpate
