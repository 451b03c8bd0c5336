// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidDevice.h"

namespace palpate
{
DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale)
{
  const PidKind kind = pidKind(descriptor);
  const PidInput input(descriptor, kind.sensedAxes);
  DeviceInfo info = pushedInfo(name, entry, kind, scale);
  info.rendersForce = descriptor.hasCollection(pid::setEffect);
  info.resolution_m = { input.usable() ? input.step() * scale.halfTravel_m : 0.0, false };
  return info;
}

PidDevice::PidDevice(
  const std::string& name, const std::shared_ptr<HidBus>& bus, const HidEntry& entry, const PidDeviceOptions& options)
  : PushedDevice(pidInfo(name, entry, parseReportDescriptor(bus->descriptor(entry).value), options.output.scale),
      options,
      [bus, entry, output = options.output](const Clock& clock)
      { return std::make_shared<PidLink>(bus, entry, output, clock); })
{
}

} // namespace palpate
