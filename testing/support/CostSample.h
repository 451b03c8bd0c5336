// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/core/Clock.h"

namespace palpate::test
{

/// Processor time of this thread: for calls that take longer than the machine lets a thread run.
class ProcessorClock final : public Clock
{
public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override;
};

/// Processor time of all threads of this program: for calls that use more than one.
class ProgramClock final : public Clock
{
public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override;
};

/// Time to read a clock, at the least [ns].
[[nodiscard]] std::int64_t readingOf_ns(const Clock& clock);

/// Times of single calls in microseconds, less the time to read the clock. A maximum says nothing on a shared machine.
class CostSample
{
public:
  explicit CostSample(std::size_t capacity);
  /// By another clock than the wall's.
  CostSample(std::size_t capacity, const Clock& clock);

  template<class Call>
  void time(Call call)
  {
    const std::int64_t begin_ns = this->clock_->now_ns();
    call();
    this->times_ns_.push_back(this->clock_->now_ns() - begin_ns);
  }

  /// Runs pass(call) twice, once to warm up: each call(f) calls f(), and times it the second time.
  template<class Pass>
  void timeWarm(Pass pass)
  {
    pass([](auto call) { call(); });
    pass([this](auto call) { this->time(call); });
  }

  /// The value below which `fraction` of the calls lie [us].
  [[nodiscard]] double quantile_us(double fraction) const;

private:
  const Clock* clock_;
  std::int64_t overhead_ns_;
  std::vector<std::int64_t> times_ns_;
};

/// Two costs of the same run that are to be compared, measured in turn some times over, so that whatever else the
/// machine does meets both alike: the pair whose ratio of p50_us is the median.
template<class One, class Other>
auto costsInTurn(One one, Other other)
{
  constexpr std::size_t rounds = 5;
  std::vector<std::pair<decltype(one()), decltype(other())>> pairs;
  for (std::size_t i = 0; i < rounds; ++i)
  {
    auto first = one();
    pairs.emplace_back(std::move(first), other());
  }
  std::ranges::nth_element(
    pairs, pairs.begin() + rounds / 2, {}, [](const auto& pair) { return pair.first.p50_us / pair.second.p50_us; });
  return pairs[rounds / 2];
}

} // namespace palpate::test
