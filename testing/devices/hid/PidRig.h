// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>

#include "devices/io/PidDevice.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate::test
{

/// Nothing runs by itself, the scale is that of the virtual firmware, and its walls are trusted.
inline PidDeviceOptions virtualOptions(const FakeHidBus& bus)
{
  PidDeviceOptions options;
  options.threads = false;
  options.clock = &bus.time();
  PidScale& scale = options.output.scale;
  scale.springStiffness_N_per_m = VirtualPidDevice::springGain * scale.maxForce_N / scale.halfTravel_m;
  scale.damperViscosity_Ns_per_m = VirtualPidDevice::damperMetric * scale.springStiffness_N_per_m;
  options.output.trust = { true, true };
  return options;
}

inline constexpr int ramped_ms = 1550; // the ramp, and half of the time between two turns of arming effects again
inline const std::array<Vec3, 4> directions{ Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0) };

/// Walls on four sides, at a share of half the travel behind the middle.
inline DeviceCommand corridors(const PidScale& scale, double half)
{
  DeviceCommand command;
  const double at_m = -half * scale.halfTravel_m, K = scale.springStiffness_N_per_m;
  command.wallCount = 4;
  command.walls = { { { Vec3::UnitX(), at_m, K }, { -Vec3::UnitX(), at_m, K }, { Vec3::UnitY(), at_m, K },
    { -Vec3::UnitY(), at_m, K } } };
  return command;
}

/// A device on a bus in virtual time: every millisecond a tick of the servo and a pass of the reader and the writer.
struct PidRig
{
  explicit PidRig(const PidLayout& layout, const std::string& serial = "0001")
    : port(bus->plug(layout, serial)), options(virtualOptions(*bus)), device("pid", bus, port.entry, options)
  {
  }

  PidRig(const std::shared_ptr<FirmwareModel>& model, const std::vector<std::uint8_t>& descriptor)
    : port(bus->plug(model, descriptor)), options(virtualOptions(*bus)), device("pid", bus, port.entry, options)
  {
  }

  VirtualPidDevice& stick() { return *this->port.device; }
  [[nodiscard]] const PidScale& scale() const { return this->options.output.scale; }

  /// Lets the servo run; the command holds.
  void run(int duration_ms)
  {
    const std::int64_t until_ns = this->bus->time().now_ns() + duration_ms * std::int64_t{ 1000000 };
    while (this->bus->time().now_ns() < until_ns)
    {
      this->status = this->device.read(0.0, this->sample);
      this->lostTicks += this->status == DeviceStatus::Lost ? 1 : 0;
      this->device.write(this->command);
      this->pass();
    }
  }

  /// The threads alone: the servo stands still.
  void pass()
  {
    static_cast<void>(this->device.link().readPass(0));
    if (!this->device.link().writePass())
    {
      this->bus->advance(1); // a report takes its time by itself
    }
  }

  std::shared_ptr<FakeHidBus> bus = std::make_shared<FakeHidBus>();
  FakePort& port;
  PidDeviceOptions options;
  PidDevice device;
  DeviceCommand command;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  int lostTicks = 0;
};

} // namespace palpate::test
