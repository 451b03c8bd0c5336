// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "haptics/core/Clock.h"

namespace palpate::test
{

/// What each call of a run takes, as the least of some runs of the same: whatever else the machine does is left out, so
/// that high quantiles and the maximum mean something.
class LeastCosts
{
public:
  /// Runs run(call) so many times; each call(f) calls f() and times it.
  template<class Run>
  LeastCosts(int runs, Run run)
  {
    for (int i = 0; i < runs; ++i)
    {
      std::size_t at = 0;
      run(
        [&](auto call)
        {
          const std::int64_t begin_ns = this->clock_.now_ns();
          call();
          this->add(at++, this->clock_.now_ns() - begin_ns);
        });
    }
    std::ranges::sort(this->least_ns_);
  }

  /// The value below which `fraction` of the calls lie, less what reading the clock takes [us].
  [[nodiscard]] double quantile_us(double fraction) const
  {
    const auto at = static_cast<std::size_t>(fraction * static_cast<double>(this->least_ns_.size() - 1));
    return 1e-3 * static_cast<double>(std::max<std::int64_t>(0, this->least_ns_[at] - this->readingOfClock_ns()));
  }

private:
  void add(std::size_t at, std::int64_t cost_ns)
  {
    if (at == this->least_ns_.size())
    {
      this->least_ns_.push_back(cost_ns);
    }
    this->least_ns_[at] = std::min(this->least_ns_[at], cost_ns);
  }
  [[nodiscard]] std::int64_t readingOfClock_ns() const
  {
    std::int64_t least_ns = std::numeric_limits<std::int64_t>::max();
    for (int i = 0; i < 10000; ++i)
    {
      const std::int64_t begin_ns = this->clock_.now_ns();
      least_ns = std::min(least_ns, this->clock_.now_ns() - begin_ns);
    }
    return least_ns;
  }

  MonotonicClock clock_;
  std::vector<std::int64_t> least_ns_;
};

} // namespace palpate::test
