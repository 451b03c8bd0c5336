// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/EventServo.h"

#include <algorithm>
#include <stdexcept>

#include "testing/devices/evdev/VirtualDriver.h"

namespace palpate::test
{
namespace
{

PushedDeviceOptions driverOptions()
{
  PushedDeviceOptions options;
  options.output.trust = { true, true };
  PidScale& scale = options.output.scale;
  scale.springStiffness_N_per_m = VirtualDriver::springGain * scale.maxForce_N / scale.halfTravel_m;
  scale.damperViscosity_Ns_per_m = VirtualDriver::damperMetric * scale.springStiffness_N_per_m;
  return options;
}

} // namespace

HidEntry waitForEventDevice(EvdevBus& bus, std::uint16_t vendor, std::uint16_t product)
{
  HidEntry found;
  const auto look = [&]
  {
    const std::vector<HidEntry> all = bus.devices();
    const auto it = std::find_if(all.begin(), all.end(),
      [&](const HidEntry& entry)
      { return entry.vendor == vendor && entry.product == product && bus.traits(entry).forces.any(); });
    found = it != all.end() ? *it : HidEntry{};
    return it != all.end();
  };
  if (!waitUntil(look))
  {
    throw std::runtime_error("no event device with force has come");
  }
  return found;
}

EventServo::EventServo(std::uint16_t vendor, std::uint16_t product)
  : Ticking(device), options(driverOptions()), entry(waitForEventDevice(*bus, vendor, product)),
    device("evdev", bus, entry, options)
{
}

} // namespace palpate::test
