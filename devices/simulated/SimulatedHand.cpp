// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/SimulatedHand.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace palpate
{

HandModel idealHand()
{
  return { "simulated-ideal", 0.1, 0.0 };
}

HandModel genericHand()
{
  return { "simulated-generic", 0.1, 1.0 };
}

SimulatedHand::SimulatedHand(HandModel model, HandPath path, double period_s)
  : model_(std::move(model)), path_(std::move(path)), period_s_(period_s),
    plant_(model_.deviceMass_kg + model_.handMass_kg, model_.deviceDamping_Ns_per_m + model_.handDamping_Ns_per_m,
      model_.handStiffness_N_per_m, period_s)
{
  this->info_.name = this->model_.name;
  this->info_.simulated = true;
  this->info_.mass_kg = { this->model_.deviceMass_kg, true };
  this->info_.damping_Ns_per_m = { this->model_.deviceDamping_Ns_per_m, true };
}

std::string SimulatedHand::open()
{
  if (this->path_.points_D.empty())
  {
    return "the simulated hand has nowhere to go: give it a stroke with at least one point";
  }
  if (!std::all_of(
        this->path_.points_D.begin(), this->path_.points_D.end(), [](const Vec3& p) { return p.allFinite(); }))
  {
    return "the simulated hand's stroke has a point that is not finite";
  }
  if (!(this->path_.speed_m_per_s > 0.0))
  {
    return "the simulated hand's speed [m/s] must be above zero";
  }
  this->reached_m_.assign(1, 0.0);
  for (std::size_t i = 1; i < this->path_.points_D.size(); ++i)
  {
    this->reached_m_.push_back(
      this->reached_m_.back() + (this->path_.points_D[i] - this->path_.points_D[i - 1]).norm());
  }
  this->x_D_ = this->path_.points_D.front();
  this->v_D_ = this->force_D_ = Vec3::Zero();
  this->time_s_ = 0.0;
  return {};
}

Vec3 SimulatedHand::target(double time_s) const noexcept
{
  const double length = this->reached_m_.back();
  double along = this->path_.speed_m_per_s * time_s;
  if (this->path_.loops && length > 0.0)
  {
    const double turns = along / (2 * length);
    along = (turns - static_cast<double>(static_cast<std::int64_t>(turns))) * 2 * length;
    along = along > length ? 2 * length - along : along;
  }
  const auto next = std::upper_bound(this->reached_m_.begin(), this->reached_m_.end(), along);
  if (next == this->reached_m_.end())
  {
    return this->path_.points_D.back();
  }
  const auto i = static_cast<std::size_t>(next - this->reached_m_.begin());
  const double share = (along - this->reached_m_[i - 1]) / (this->reached_m_[i] - this->reached_m_[i - 1]);
  return this->path_.points_D[i - 1] + share * (this->path_.points_D[i] - this->path_.points_D[i - 1]);
}

DeviceStatus SimulatedHand::read(double tickTime_s, DeviceSample& sample) noexcept
{
  // Half a period of tolerance: tick times are multiples of the period, computed once more by the caller.
  constexpr int mostPeriods = 1000;
  for (int k = 0; k < mostPeriods && this->time_s_ + 0.5 * this->period_s_ < tickTime_s; ++k)
  {
    const Vec3 before = this->target(this->time_s_), after = this->target(this->time_s_ + this->period_s_);
    const Vec3 led = this->model_.handStiffness_N_per_m * after +
                     this->model_.handDamping_Ns_per_m / this->period_s_ * (after - before);
    this->plant_.step(this->x_D_, this->v_D_, led + this->force_D_);
    this->time_s_ += this->period_s_;
  }
  sample = DeviceSample{};
  sample.time_s = tickTime_s;
  sample.pose_D.p = this->x_D_;
  sample.velocity_D.linear = this->v_D_;
  sample.grip = true;
  return DeviceStatus::Ok;
}

} // namespace palpate
