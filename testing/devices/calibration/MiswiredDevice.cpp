// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/calibration/MiswiredDevice.h"

#include <algorithm>

namespace palpate::test
{

MiswiredDevice::MiswiredDevice(const DeviceModel& model, const HandModel& hand, const Wiring& wiring)
  : info_(infoOf(model)), device_(model, hand, HandPath{ { Vec3::Zero() } }), wiring_(wiring)
{
  this->info_.abilities.holdsWalls = model.loop_s > 0.0;
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

void MiswiredDevice::write(const DeviceCommand& command) noexcept
{
  this->told_ = command;
  DeviceCommand given = command;
  given.wrench_D.force = this->wiring_.motors * command.wrench_D.force;
  for (std::size_t i = 0; i < std::min<std::size_t>(given.wallCount, given.walls.size()); ++i)
  {
    given.walls[i].normal_D = this->wiring_.sensors.transpose() * command.walls[i].normal_D;
    given.walls[i].stiffness_N_per_m *= this->wiring_.springs;
  }
  this->device_.write(given);
}

} // namespace palpate::test
