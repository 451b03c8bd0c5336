// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/Servo.h"

#include <algorithm>
#include <stdexcept>

#include "devices/hid/HidapiBus.h"
#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{

HidEntry waitForEntry(HidBus& bus, const std::string& serial)
{
  HidEntry found;
  const auto look = [&]
  {
    const std::vector<HidEntry> all = bus.devices();
    const auto it = std::find_if(all.begin(), all.end(), [&](const HidEntry& entry) { return entry.serial == serial; });
    found = it != all.end() ? *it : HidEntry{};
    return it != all.end();
  };
  if (!waitUntil(look))
  {
    throw std::runtime_error("no device " + serial + " has come");
  }
  return found;
}

PidDeviceOptions Servo::firmwareOptions()
{
  PidDeviceOptions options;
  PidScale& scale = options.output.scale;
  scale.springStiffness_N_per_m = VirtualPidDevice::springGain * scale.maxForce_N / scale.halfTravel_m;
  scale.damperViscosity_Ns_per_m = VirtualPidDevice::damperMetric * scale.springStiffness_N_per_m;
  options.output.trust = { true, true };
  return options;
}

Servo::Servo(const std::string& serial, const PidDeviceOptions& options)
  : Ticking(device), options(options), bus(systemHidBus()), entry(waitForEntry(*bus, serial)),
    device("pid", bus, entry, options)
{
}

} // namespace palpate::test
