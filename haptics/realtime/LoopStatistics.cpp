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

double DurationHistogram::quantile(double fraction) const noexcept
{
  const auto rank = static_cast<std::uint64_t>(fraction * static_cast<double>(this->count_));
  std::uint64_t seen = 0;
  for (int bin = 0; bin < fineBins + coarseBins; ++bin)
  {
    seen += this->bins_[static_cast<std::size_t>(bin)];
    if (seen > rank)
    {
      return std::min(upperEnd_us(bin), this->max_us_);
    }
  }
  return this->max_us_;
}

Quantiles DurationHistogram::quantiles() const noexcept
{
  return { this->count_, this->quantile(0.5), this->quantile(0.99), this->quantile(0.999), this->max_us_ };
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
  const Quantiles a = this->turns_[0].quantiles(), b = this->turns_[1].quantiles();
  return { a.count + b.count, std::max(a.p50_us, b.p50_us), std::max(a.p99_us, b.p99_us), std::max(a.p999_us, b.p999_us),
    std::max(a.max_us, b.max_us) };
}

} // namespace palpate
