// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/FedDevice.h"

#include <algorithm>

namespace palpate
{

FedDevice::FedDevice() : FedDevice("fed", {}) {}

FedDevice::FedDevice(const char* name, const Glide& glide) : glide_(glide)
{
  this->info_.name = name;
  this->info_.simulated = true;
  this->info_.rendersForce = false;
}

std::unique_ptr<FedDevice> FedDevice::mouse()
{
  constexpr double threeFrames_s = 0.05; // of a slow screen; a pointer that rested longer starts anew
  constexpr double briskHand_m_per_s = 0.5;
  std::unique_ptr<FedDevice> mouse(new FedDevice("mouse", { threeFrames_s, briskHand_m_per_s }));
  mouse->info_.heldTurning_N_m_per_rad = 1.0; // a rod of 50 mm is as stiff at its end as a spring of 400 N/m
  return mouse;
}

void FedDevice::feed(const DeviceSample& sample, std::uint64_t places) noexcept
{
  this->fed_.write({ sample, ++this->feeds_, places });
}

DeviceStatus FedDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const Fed& fed = this->fed_.read();
  if (fed.count == 0)
  {
    return DeviceStatus::Waiting;
  }
  sample = fed.sample;
  sample.time_s = tickTime_s;
  if (this->glide_.longest_s > 0.0)
  {
    this->glideTo(fed, tickTime_s);
    sample.pose_D.p = this->hand_D_;
  }
  return DeviceStatus::Ok;
}

/// Steps of one size: the rest of the displacement, over the ticks that are left for it.
void FedDevice::glideTo(const Fed& fed, double tickTime_s) noexcept
{
  const double dt_s = tickTime_s - this->last_s_;
  this->last_s_ = tickTime_s;
  if (this->seen_ == 0 || fed.places != this->placed_ || !this->hand_D_.allFinite())
  {
    this->hand_D_ = fed.sample.pose_D.p; // there is no displacement from nowhere
  }
  if (fed.count != this->seen_)
  {
    const double since_s = tickTime_s - this->news_s_;
    this->arrival_s_ = tickTime_s - dt_s + std::min(since_s, this->glide_.longest_s);
    this->news_s_ = tickTime_s;
    this->seen_ = fed.count;
    this->placed_ = fed.places;
  }
  const double left_s = this->arrival_s_ - (tickTime_s - dt_s);
  const Vec3 way_D = fed.sample.pose_D.p - this->hand_D_;
  const double share = dt_s < left_s ? dt_s / left_s : 1.0;
  const double length_m = share * way_D.norm();
  const double longest_m = this->glide_.fastest_m_per_s * dt_s;
  if (length_m <= longest_m)
  {
    this->hand_D_ = share < 1.0 ? Vec3(this->hand_D_ + share * way_D) : fed.sample.pose_D.p;
  }
  else
  {
    this->hand_D_ += (longest_m / length_m) * share * way_D;
  }
}

} // namespace palpate
