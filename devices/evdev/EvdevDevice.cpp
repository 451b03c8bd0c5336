// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevDevice.h"

#include "devices/evdev/EvdevKind.h"

namespace palpate
{
namespace
{

DeviceInfo infoOf(const std::string& name, const HidEntry& entry, const EvdevKind& kind, const PidScale& scale)
{
  DeviceInfo info = pushedInfo(name, entry, kind.pushes, scale);
  info.rendersForce = kind.pushes.pushedAxes > 0;
  return info;
}

} // namespace

EvdevDevice::EvdevDevice(const std::string& name, const std::shared_ptr<EvdevBus>& bus, const HidEntry& entry,
  const PushedDeviceOptions& options)
  : PushedDevice(infoOf(name, entry, evdevKind(bus->traits(entry), entry), options.output.scale), options,
      [bus, entry, output = options.output](const Clock& clock)
      { return std::make_shared<EvdevLink>(bus, entry, output, clock); })
{
}

std::string EvdevDevice::open()
{
  std::string problem = this->PushedDevice::open();
  if (this->link_->abilities())
  {
    this->info_.resolution_m = { this->link_->step() * this->options_.output.scale.halfTravel_m, false };
  }
  return problem;
}

} // namespace palpate
