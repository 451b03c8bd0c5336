// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/LedPath.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{

LedPath::LedPath(HandPath path) : path_(std::move(path))
{
  this->reached_m_.assign(1, 0.0);
  for (std::size_t i = 1; i < this->path_.points_D.size(); ++i)
  {
    this->reached_m_.push_back(
      this->reached_m_.back() + (this->path_.points_D[i] - this->path_.points_D[i - 1]).norm());
  }
}

std::string LedPath::refusal() const
{
  if (this->path_.points_D.empty())
  {
    return "the simulated hand has no path: set a stroke with at least one point";
  }
  if (!std::all_of(
        this->path_.points_D.begin(), this->path_.points_D.end(), [](const Vec3& p) { return p.allFinite(); }))
  {
    return "the simulated hand's stroke has a point that is not finite";
  }
  if (!this->path_.turn_D.allFinite())
  {
    return "the simulated hand's rotation [rad] is not finite";
  }
  if (!(this->path_.speed_m_per_s > 0.0))
  {
    return "the simulated hand's speed [m/s] must be above zero";
  }
  return {};
}

Pose LedPath::at_D(double time_s) const noexcept
{
  const double length = this->reached_m_.back();
  double along = this->path_.speed_m_per_s * time_s;
  if (this->path_.loops && length > 0.0)
  {
    const double turns = along / (2 * length);
    along = (turns - static_cast<double>(static_cast<std::int64_t>(turns))) * 2 * length;
    along = along > length ? 2 * length - along : along;
  }
  const double whole = length > 0.0 ? std::min(1.0, along / length) : 0.0;
  const Quat turn_D = turnBy(whole * this->path_.turn_D);
  const auto next = std::upper_bound(this->reached_m_.begin(), this->reached_m_.end(), along);
  if (next == this->reached_m_.end())
  {
    return { this->path_.points_D.back(), turn_D };
  }
  const auto i = static_cast<std::size_t>(next - this->reached_m_.begin());
  const double share = (along - this->reached_m_[i - 1]) / (this->reached_m_[i] - this->reached_m_[i - 1]);
  return { this->path_.points_D[i - 1] + share * (this->path_.points_D[i] - this->path_.points_D[i - 1]), turn_D };
}

} // namespace palpate
