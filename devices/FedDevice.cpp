// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/FedDevice.h"

namespace palpate
{

FedDevice::FedDevice()
{
  this->info_.name = "fed";
  this->info_.simulated = true;
  this->info_.rendersForce = false;
}

DeviceStatus FedDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  sample = this->fed_.read();
  sample.time_s = tickTime_s;
  return DeviceStatus::Ok;
}

} // namespace palpate
