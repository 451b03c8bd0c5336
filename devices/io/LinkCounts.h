// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "devices/common/LinkedDevice.h"

namespace palpate
{

/// Rate of reports, counted over a second. One thread counts, any other may read.
class ReportRate
{
public:
  void count(std::uint64_t reports, std::int64_t now_ns) noexcept
  {
    this->reports_ += reports;
    if (this->since_ns_ == none)
    {
      this->since_ns_ = now_ns;
      this->reports_ = 0;
    }
    else if (now_ns - this->since_ns_ >= window_ns)
    {
      this->rate_Hz_ = 1e9 * static_cast<double>(this->reports_) / static_cast<double>(now_ns - this->since_ns_);
      this->since_ns_ = now_ns;
      this->reports_ = 0;
    }
  }
  /// Reports come no more: the next one begins a second anew. Called by the thread that counts.
  void restart() noexcept
  {
    this->since_ns_ = none;
    this->rate_Hz_ = 0.0;
  }
  [[nodiscard]] double rate_Hz() const noexcept { return this->rate_Hz_; }

private:
  static constexpr std::int64_t none = -1, window_ns = 1000000000;
  std::int64_t since_ns_ = none;
  std::uint64_t reports_ = 0;
  std::atomic<double> rate_Hz_ = 0.0;
};

/// Counters of a link's threads, for the user.
struct LinkCounts
{
  /// On a cache line of its own: the reader counts every report.
  alignas(64) ReportRate rate;
  std::atomic<std::uint64_t> inputs = 0, strange = 0, outOfRange = 0; ///< reader's
  std::atomic<std::uint64_t> outputs = 0, restarts = 0;               ///< writer's

  void reportTo(LinkReport& report) const
  {
    report.inputs = this->inputs;
    report.strange = this->strange;
    report.outOfRange = this->outOfRange;
    report.outputs = this->outputs;
    report.restarts = this->restarts;
    report.inputRate_Hz = this->rate.rate_Hz();
  }
};

} // namespace palpate
