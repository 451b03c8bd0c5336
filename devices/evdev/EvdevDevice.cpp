// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevDevice.h"

#include "devices/evdev/EvdevKind.h"

namespace palpate
{
namespace
{

DeviceInfo infoOf(const std::string& name, const HidEntry& entry, const EvdevKind& kind, const PidScale& scale)
{
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = kind.pushes.deviceClass;
  info.rendersForce = kind.pushes.pushedAxes > 0;
  info.abilities = promised(kind.pushes);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.maxForce_N = { scale.maxForce_N, false };
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = { scale.springStiffness_N_per_m, false };
    info.heldForce_N = { scale.maxForce_N, false };
  }
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
  if (const std::optional<EvdevLink::Found> found = this->link_->found())
  {
    this->info_.resolution_m = { found->step * this->options_.output.scale.halfTravel_m, false };
  }
  return problem;
}

} // namespace palpate
