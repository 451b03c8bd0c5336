// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/Clock.h"

namespace palpate
{

/// Time around a tick, less the time of asking the clock twice (the median of many empty measurements).
class TickCost
{
public:
  TickCost();
  void start() { this->start_ns_ = this->clock_.now_ns(); }
  /// Since start() [us], never negative.
  [[nodiscard]] double cost_us() const;

private:
  MonotonicClock clock_;
  std::int64_t start_ns_ = 0;
  double overhead_us_ = 0.0;
};

} // namespace palpate
