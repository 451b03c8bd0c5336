// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/GentlePush.h"

#include <algorithm>
#include <cmath>

namespace palpate
{

double push::share(double time_s) noexcept
{
  if (!(time_s > 0.0) || time_s >= all_s)
  {
    return 0.0;
  }
  return std::min({ 1.0, time_s / rise_s, (all_s - time_s) / fall_s });
}

double push::lapsingShare(double time_s) noexcept
{
  return time_s > 0.0 && time_s < all_s ? std::min(1.0, time_s / lapse_s) : 0.0;
}

void PushRecord::begin(const Vec3& p_D) noexcept
{
  this->from_D_ = p_D;
  this->sums_.fill(Vec3::Zero());
  this->counts_.fill(0);
}

void PushRecord::add(double time_s, const Vec3& p_D) noexcept
{
  const auto bin = static_cast<std::size_t>(std::max(0.0, time_s / bin_s));
  if (bin < bins)
  {
    this->sums_[bin] += p_D - this->from_D_;
    ++this->counts_[bin];
  }
}

double PushRecord::way(std::size_t bin, int axis) const noexcept
{
  return this->counts_[bin] > 0 ? this->sums_[bin][axis] / this->counts_[bin] : 0.0;
}

double PushRecord::meanWay(double from_s, double to_s, int axis) const noexcept
{
  double sum_m = 0.0;
  int count = 0;
  const auto first = static_cast<std::size_t>(from_s / bin_s + 0.5), end = static_cast<std::size_t>(to_s / bin_s + 0.5);
  for (std::size_t bin = first; bin < std::min(end, bins); ++bin)
  {
    sum_m += this->sums_[bin][axis];
    count += this->counts_[bin];
  }
  return count > 0 ? sum_m / count : 0.0;
}

/// Least squares over the bins of the rise in which the way is at least that.
double PushRecord::slope(int axis, double force_N, double least_m) const noexcept
{
  double n = 0.0, sumF = 0.0, sumX = 0.0, sumFF = 0.0, sumFX = 0.0;
  for (std::size_t bin = 0; bin < risingBins; ++bin)
  {
    const double x_m = this->way(bin, axis);
    if (this->counts_[bin] == 0 || std::fabs(x_m) < least_m)
    {
      continue;
    }
    const double F_N = force_N * (static_cast<double>(bin) + 0.5) / risingBins;
    n += 1.0;
    sumF += F_N;
    sumX += x_m;
    sumFF += F_N * F_N;
    sumFX += F_N * x_m;
  }
  const double spread = n * sumFF - sumF * sumF;
  return spread > 0.0 ? (n * sumFX - sumF * sumX) / spread : 0.0;
}

void PushRecord::findMost(int axis, PushAnswer& answer) const noexcept
{
  constexpr double nearly = 0.9;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    const double x_m = this->way(bin, axis);
    answer.most_m = std::fabs(x_m) > std::fabs(answer.most_m) ? x_m : answer.most_m;
  }
  for (std::size_t bin = bins; bin-- > 0;)
  {
    if (answer.most_m != 0.0 && this->way(bin, axis) / answer.most_m >= nearly)
    {
      answer.reached_s = (static_cast<double>(bin) + 0.5) * bin_s; // the first push is the one that stays
    }
  }
}

PushAnswer PushRecord::answer(int axis, double force_N) const noexcept
{
  constexpr double shareThatMoves = 0.25, early_s = push::rise_s / 16, end_s = push::all_s - push::fall_s;
  PushAnswer answer;
  answer.moved_m = this->meanWay(push::rise_s, end_s, axis);
  answer.mean_m = this->meanWay(0.0, push::rise_s, axis);
  answer.last_m = this->meanWay(end_s, push::all_s, axis);
  answer.rested_m = this->meanWay(push::all_s + push::rest_s - push::stay_s, push::all_s + push::rest_s, axis);
  for (std::size_t bin = 0; static_cast<double>(bin) * bin_s < early_s; ++bin)
  {
    answer.early_m = std::max(answer.early_m, std::fabs(this->way(bin, axis)));
  }
  answer.response_m_per_N = this->slope(axis, force_N, shareThatMoves * std::fabs(answer.moved_m));
  this->findMost(axis, answer);
  return answer;
}

} // namespace palpate
