// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "devices/evdev/EvdevDevice.h"
#include "testing/vm/Ticking.h"

namespace palpate::test
{

/// An event device of this computer with its own threads, and a servo that ticks it.
struct EventServo : Ticking
{
  /// Waits for the device with these numbers; throws std::runtime_error when it does not come.
  EventServo(std::uint16_t vendor, std::uint16_t product);

  /// The scale of the virtual driver.
  PushedDeviceOptions options;
  std::shared_ptr<EvdevBus> bus = systemEvdevBus();
  HidEntry entry;
  EvdevDevice device;
};

/// The entry with these numbers, as soon as the kernel shows it with force.
[[nodiscard]] HidEntry waitForEventDevice(EvdevBus& bus, std::uint16_t vendor, std::uint16_t product);

} // namespace palpate::test
