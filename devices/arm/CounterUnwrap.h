// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// Counters that wrap, as whole ways: each step is the shortest that leads to the new count.
class CounterUnwrap
{
public:
  explicit CounterUnwrap(int bits) noexcept : range_(bits > 0 ? std::ldexp(1.0, bits) : 0.0) {}

  /// The next reading follows nothing.
  void restart() noexcept { this->begun_ = false; }
  void follow(std::array<double, WireReading::encoders>& counts) noexcept
  {
    for (std::size_t i = 0; i < counts.size() && this->range_ > 0.0 && this->begun_; ++i)
    {
      counts[i] = this->whole_[i] + std::remainder(counts[i] - this->whole_[i], this->range_);
    }
    this->begun_ = true;
    this->whole_ = counts;
  }

private:
  double range_;
  bool begun_ = false;
  std::array<double, WireReading::encoders> whole_{};
};

} // namespace palpate
