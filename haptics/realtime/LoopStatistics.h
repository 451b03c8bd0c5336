// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace palpate
{

/// Quantiles of a histogram [us], each the upper end of the bin it falls in.
struct Quantiles
{
  std::uint64_t count = 0;
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0; ///< exact
};

/// Durations in bins of 1 us up to 1 ms, then 100 us up to 100 ms, then one. Fixed memory; one thread.
class DurationHistogram
{
public:
  void add(double duration_us) noexcept;
  void clear() noexcept { *this = {}; }
  [[nodiscard]] Quantiles quantiles() const noexcept;
  /// Of everything in this histogram and in `other` together.
  [[nodiscard]] Quantiles quantilesWith(const DurationHistogram& other) const noexcept;
  [[nodiscard]] std::uint64_t count() const noexcept { return this->count_; }

private:
  static constexpr int fineBins = 1000, coarseBins = 1000;
  static constexpr double coarse_us = 100.0;
  [[nodiscard]] static double upperEnd_us(int bin) noexcept;

  std::array<std::uint32_t, fineBins + coarseBins + 1> bins_{};
  std::uint64_t count_ = 0;
  double max_us_ = 0.0;
};

/// The last 5 s of a loop, as two histograms that take turns: once 2.5 s have passed, a quantile covers between
/// 2.5 and 5 s, so that no single value decides a p99. Fixed memory; one thread.
class SlidingHistogram
{
public:
  void add(double time_s, double duration_us) noexcept;
  [[nodiscard]] Quantiles quantiles() const noexcept;

private:
  static constexpr double turn_s = 2.5;
  std::array<DurationHistogram, 2> turns_{};
  int current_ = 0;
  double turnEnds_s_ = -1.0;
};

} // namespace palpate
