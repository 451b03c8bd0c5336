// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/CostSample.h"

#include <ctime>
#include <limits>

namespace palpate::test
{
namespace
{

const MonotonicClock wall;

std::int64_t timeOf_ns(clockid_t clock) noexcept
{
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000000000 + now.tv_nsec;
}

} // namespace

std::int64_t ProcessorClock::now_ns() const noexcept
{
  return timeOf_ns(CLOCK_THREAD_CPUTIME_ID);
}

std::int64_t ProgramClock::now_ns() const noexcept
{
  return timeOf_ns(CLOCK_PROCESS_CPUTIME_ID);
}

CostSample::CostSample(std::size_t capacity) : CostSample(capacity, wall) {}

std::int64_t readingOf_ns(const Clock& clock)
{
  std::int64_t least_ns = std::numeric_limits<std::int64_t>::max();
  for (int i = 0; i < 10000; ++i)
  {
    const std::int64_t begin_ns = clock.now_ns();
    least_ns = std::min(least_ns, clock.now_ns() - begin_ns);
  }
  return least_ns;
}

CostSample::CostSample(std::size_t capacity, const Clock& clock) : clock_(&clock), overhead_ns_(readingOf_ns(clock))
{
  this->times_ns_.reserve(capacity);
}

double CostSample::quantile_us(double fraction) const
{
  std::vector<std::int64_t> sorted = this->times_ns_;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), at, sorted.end());
  return 1e-3 * static_cast<double>(std::max<std::int64_t>(0, *at - this->overhead_ns_));
}

} // namespace palpate::test
