// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "devices/io/PidDevice.h"
#include "testing/vm/Ticking.h"

namespace palpate::test
{

/// A device on this computer's bus with its own threads, and a servo that ticks it.
struct Servo : Ticking
{
  /// Waits for the device with that serial number; throws std::runtime_error when it does not come.
  explicit Servo(const std::string& serial, const PidDeviceOptions& options = firmwareOptions());

  /// The scale of the virtual firmware.
  [[nodiscard]] static PidDeviceOptions firmwareOptions();

  PidDeviceOptions options;
  std::shared_ptr<HidBus> bus;
  HidEntry entry;
  PidDevice device;
};

/// The entry with that serial number, as soon as the kernel shows it.
[[nodiscard]] HidEntry waitForEntry(HidBus& bus, const std::string& serial);

} // namespace palpate::test
