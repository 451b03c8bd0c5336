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

void PushRecord::begin(const Vec3& p_D) noexcept
{
  this->from_D_ = p_D;
  this->sums_.fill(Vec3::Zero());
  this->counts_.fill(0);
  this->staySum_ = Vec3::Zero();
  this->stayCount_ = 0;
}

void PushRecord::add(double time_s, const Vec3& p_D) noexcept
{
  const Vec3 way = p_D - this->from_D_;
  if (time_s < push::rise_s)
  {
    const auto bin = std::min(static_cast<std::size_t>(std::max(0.0, time_s / push::rise_s * bins)), bins - 1);
    this->sums_[bin] += way;
    ++this->counts_[bin];
  }
  else if (time_s < push::rise_s + push::stay_s)
  {
    this->staySum_ += way;
    ++this->stayCount_;
  }
}

double PushRecord::way(std::size_t bin, int axis) const noexcept
{
  return this->sums_[bin][axis] / this->counts_[bin];
}

PushAnswer PushRecord::answer(int axis, double force_N) const noexcept
{
  constexpr double shareThatMoves = 0.25;
  constexpr std::size_t earlyBins = bins / 16;
  PushAnswer answer;
  answer.moved_m = this->stayCount_ > 0 ? this->staySum_[axis] / this->stayCount_ : 0.0;
  double n = 0.0, sumF = 0.0, sumX = 0.0, sumFF = 0.0, sumFX = 0.0;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    if (this->counts_[bin] == 0)
    {
      continue;
    }
    const double x_m = this->way(bin, axis);
    if (bin < earlyBins)
    {
      answer.early_m = std::max(answer.early_m, std::fabs(x_m));
    }
    if (std::fabs(x_m) < shareThatMoves * std::fabs(answer.moved_m))
    {
      continue;
    }
    const double F_N = force_N * (static_cast<double>(bin) + 0.5) / bins;
    n += 1.0;
    sumF += F_N;
    sumX += x_m;
    sumFF += F_N * F_N;
    sumFX += F_N * x_m;
  }
  const double spread = n * sumFF - sumF * sumF;
  answer.response_m_per_N = spread > 0.0 ? (n * sumFX - sumF * sumX) / spread : 0.0;
  return answer;
}

} // namespace palpate
