// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "devices/io/PidDevice.h"

namespace palpate::test
{

/// A device on this computer's bus with its own threads, and a servo that ticks it about once a millisecond in the
/// caller's thread. Times are real.
struct Servo
{
  /// Waits for the device with that serial number; throws std::runtime_error when it does not come.
  explicit Servo(const std::string& serial, const PidDeviceOptions& options = firmwareOptions());

  /// The scale of the virtual firmware.
  [[nodiscard]] static PidDeviceOptions firmwareOptions();

  void run(int duration_ms);
  /// Runs until then. False: it has not come within that time.
  bool runUntil(const std::function<bool()>& done, int patience_ms = 5000);

  PidDeviceOptions options;
  std::shared_ptr<HidBus> bus;
  HidEntry entry;
  PidDevice device;
  DeviceCommand command;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;

private:
  void tick();
};

/// The entry with that serial number, as soon as the kernel shows it.
[[nodiscard]] HidEntry waitForEntry(HidBus& bus, const std::string& serial);

/// Looks every millisecond. False: it has not come within that time.
bool waitUntil(const std::function<bool()>& done, int patience_ms = 5000);

} // namespace palpate::test
