// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/core/Clock.h"
#include "testing/support/CostSample.h"

namespace palpate::test
{

/// Time of each call of a run, as the least of some runs of the same: other work of the machine is left out, so that
/// high quantiles and the maximum mean something.
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

  /// The value below which `fraction` of the calls lie, less the time to read the clock [us].
  [[nodiscard]] double quantile_us(double fraction) const
  {
    const auto at = static_cast<std::size_t>(fraction * static_cast<double>(this->least_ns_.size() - 1));
    return 1e-3 * static_cast<double>(std::max<std::int64_t>(0, this->least_ns_[at] - this->reading_ns_));
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

  MonotonicClock clock_;
  std::int64_t reading_ns_ = readingOf_ns(clock_);
  std::vector<std::int64_t> least_ns_;
};

} // namespace palpate::test
