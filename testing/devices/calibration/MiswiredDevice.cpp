// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/calibration/MiswiredDevice.h"

#include <algorithm>
#include <cmath>

#include "haptics/force/DeviceWalls.h"

namespace palpate::test
{

MiswiredDevice::MiswiredDevice(const DeviceModel& model, const HandModel& hand, const Wiring& wiring)
  : info_(infoOf(model)), device_(model, hand, HandPath{ { Vec3::Zero() } }), wiring_(wiring)
{
}

DeviceStatus MiswiredDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const DeviceStatus status = this->device_.read(tickTime_s, sample);
  ++this->ticks_;
  const Vec3 stops = this->wiring_.travel_m;
  sample.pose_D.p = (this->wiring_.sensors * sample.pose_D.p.cwiseMax(-stops).cwiseMin(stops)).eval();
  const bool lost = this->wiring_.lostAfter_ticks >= 0 && this->ticks_ > this->wiring_.lostAfter_ticks;
  return lost ? DeviceStatus::Lost : status;
}

/// A push begins after there was no force.
double MiswiredDevice::strengthNow(const DeviceCommand& command) noexcept
{
  const bool pushes = command.wrench_D.force != Vec3::Zero();
  this->pushes_ += pushes && !this->pushing_ ? 1 : 0;
  this->pushing_ = pushes;
  const bool fails = this->wiring_.failsEach > 0 && this->pushes_ % this->wiring_.failsEach == 0;
  return fails ? 0.0 : std::pow(this->wiring_.keeps, this->pushes_);
}

void MiswiredDevice::write(const DeviceCommand& command) noexcept
{
  this->told_ = command;
  this->onTheWay_.push_back(command);
  if (this->onTheWay_.size() <= this->wiring_.late_ticks)
  {
    return;
  }
  DeviceCommand given = this->onTheWay_.front();
  this->onTheWay_.pop_front();
  given.wrench_D.force = this->strengthNow(given) * (this->wiring_.motors * given.wrench_D.force).eval();
  given.viscosity_Ns_per_m *= this->wiring_.brake;
  for (std::size_t i = 0; i < std::min<std::size_t>(given.wallCount, given.walls.size()); ++i)
  {
    DeviceWall& wall = given.walls[i];
    wall.stiffness_N_per_m *= this->wiring_.springs;
    for (int side = 0; side < AxisWalls::count; ++side)
    {
      const bool thisOne = wall.normal_D.dot(AxisWalls::direction(side)) > 0.5;
      wall.stiffness_N_per_m *= thisOne ? this->wiring_.sides[static_cast<std::size_t>(side)] : 1.0;
    }
    wall.normal_D = (this->wiring_.sensors.transpose() * wall.normal_D).eval();
  }
  this->device_.write(given);
}

} // namespace palpate::test
