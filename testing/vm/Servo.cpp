// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/Servo.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "devices/hid/HidapiBus.h"
#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{

using std::chrono::milliseconds;
using std::chrono::steady_clock;

bool waitUntil(const std::function<bool()>& done, int patience_ms)
{
  const auto until = steady_clock::now() + milliseconds(patience_ms);
  while (!done())
  {
    if (steady_clock::now() > until)
    {
      return false;
    }
    std::this_thread::sleep_for(milliseconds(1));
  }
  return true;
}

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
  : options(options), bus(systemHidBus()), entry(waitForEntry(*bus, serial)), device("pid", bus, entry, options)
{
}

void Servo::run(int duration_ms)
{
  static_cast<void>(this->runUntil([] { return false; }, duration_ms));
}

bool Servo::runUntil(const std::function<bool()>& done, int patience_ms)
{
  return waitUntil(
    [&]
    {
      this->tick();
      return done();
    },
    patience_ms);
}

void Servo::tick()
{
  this->status = this->device.read(0.0, this->sample);
  this->device.write(this->command);
}

} // namespace palpate::test
