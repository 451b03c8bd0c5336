// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "devices/evdev/EvdevDevice.h"
#include "testing/devices/evdev/FakeEvdevBus.h"

namespace palpate::test
{

/// Nothing runs by itself, and the scale is that of the virtual driver.
inline PushedDeviceOptions virtualOptions(const FakeEvdevBus& bus)
{
  PushedDeviceOptions options;
  options.threads = false;
  options.clock = &bus.time;
  options.output.trust = { true, true };
  PidScale& scale = options.output.scale;
  scale.springStiffness_N_per_m = VirtualDriver::springGain * scale.maxForce_N / scale.halfTravel_m;
  scale.damperViscosity_Ns_per_m = VirtualDriver::damperMetric * scale.springStiffness_N_per_m;
  return options;
}

/// A device in virtual time: every millisecond it says where it is, then a tick of the servo, then a pass of the reader
/// and the writer each.
struct EvdevRig
{
  explicit EvdevRig(const EvdevTraits& traits, std::uint16_t product = 0xC281)
    : port(bus->plug(traits, "", 0x046D, product)), options(virtualOptions(*bus)),
      device("evdev", bus, port.entry, options)
  {
  }

  VirtualDriver& driver() { return this->port.driver; }
  [[nodiscard]] const PidScale& scale() const { return this->options.output.scale; }

  /// Lets the servo run; the command holds.
  void run(int duration_ms)
  {
    for (int i = 0; i < duration_ms; ++i)
    {
      this->port.move(ABS_X, this->driver().position[0]);
      this->port.move(ABS_Y, this->driver().position[1]);
      this->status = this->device.read(0.0, this->sample);
      this->device.write(this->command);
      this->pass();
    }
  }

  /// The threads alone: the servo stands still.
  void pass()
  {
    static_cast<void>(this->device.link().readPass(0));
    for (int i = 0; i < mostAMillisecond && this->device.link().writePass(); ++i)
    {
    }
    this->bus->advance(1);
  }

  std::shared_ptr<FakeEvdevBus> bus = std::make_shared<FakeEvdevBus>();
  FakeEvdevPort& port;
  PushedDeviceOptions options;
  EvdevDevice device;
  DeviceCommand command;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  static constexpr int mostAMillisecond = 8; ///< calls to the kernel, 0.1 ms each and a little slack
};

} // namespace palpate::test
