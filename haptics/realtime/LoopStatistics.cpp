// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/realtime/LoopStatistics.h"

#include <algorithm>

namespace palpate
{

void DurationHistogram::add(double duration_us) noexcept
{
  const double d = std::max(duration_us, 0.0);
  int bin = fineBins + coarseBins;
  if (d < fineBins)
  {
    bin = static_cast<int>(d);
  }
  else if (d < coarseBins * coarse_us)
  {
    bin = fineBins + static_cast<int>(d / coarse_us);
  }
  ++this->bins_[static_cast<std::size_t>(bin)];
  ++this->count_;
  this->max_us_ = std::max(this->max_us_, d);
}

double DurationHistogram::upperEnd_us(int bin) noexcept
{
  return bin < fineBins ? bin + 1.0 : (bin - fineBins + 1) * coarse_us;
}

Quantiles DurationHistogram::quantiles() const noexcept
{
  return this->quantilesWith(DurationHistogram{});
}

/// One pass over the bins: the servo asks while it runs.
Quantiles DurationHistogram::quantilesWith(const DurationHistogram& other) const noexcept
{
  const std::uint64_t count = this->count_ + other.count_;
  const double max_us = std::max(this->max_us_, other.max_us_);
  constexpr std::array fractions = { 0.5, 0.99, 0.999 };
  std::array<double, fractions.size()> found = { max_us, max_us, max_us };
  std::size_t next = 0;
  std::uint64_t seen = 0;
  for (int bin = 0; bin < fineBins + coarseBins && next < fractions.size(); ++bin)
  {
    const auto b = static_cast<std::size_t>(bin);
    seen += std::uint64_t{ this->bins_[b] } + other.bins_[b];
    while (next < fractions.size() && seen > static_cast<std::uint64_t>(fractions[next] * static_cast<double>(count)))
    {
      found[next++] = std::min(upperEnd_us(bin), max_us);
    }
  }
  return { count, found[0], found[1], found[2], max_us };
}

void SlidingHistogram::add(double time_s, double duration_us) noexcept
{
  if (time_s >= this->turnEnds_s_)
  {
    this->current_ = 1 - this->current_;
    this->turns_[static_cast<std::size_t>(this->current_)].clear();
    this->turnEnds_s_ = time_s + turn_s;
  }
  this->turns_[static_cast<std::size_t>(this->current_)].add(duration_us);
}

Quantiles SlidingHistogram::quantiles() const noexcept
{
  return this->turns_[0].quantilesWith(this->turns_[1]);
}

} // namespace palpate
