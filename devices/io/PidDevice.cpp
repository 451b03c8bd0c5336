// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidDevice.h"

namespace palpate
{
DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale)
{
  const PidKind kind = pidKind(descriptor);
  const PidInput input(descriptor, kind.sensedAxes);
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = kind.deviceClass;
  info.rendersForce = descriptor.hasCollection(pid::setEffect);
  info.abilities = promised(kind);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.resolution_m = { input.usable() ? input.step() * scale.halfTravel_m : 0.0, false };
  info.maxForce_N = { scale.maxForce_N, false };
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = { scale.springStiffness_N_per_m, false };
    info.heldForce_N = { scale.maxForce_N, false };
  }
  return info;
}

PidDevice::PidDevice(
  const std::string& name, const std::shared_ptr<HidBus>& bus, const HidEntry& entry, const PidDeviceOptions& options)
  : PushedDevice(pidInfo(name, entry, parseReportDescriptor(bus->descriptor(entry).bytes), options.output.scale),
      options,
      [bus, entry, output = options.output](const Clock& clock)
      { return std::make_shared<PidLink>(bus, entry, output, clock); })
{
}

} // namespace palpate
