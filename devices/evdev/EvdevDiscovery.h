// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "devices/evdev/EvdevBus.h"
#include "devices/evdev/EvdevKind.h"

namespace palpate
{

/// An event device for a hand, usable or not.
struct FoundEvdev
{
  std::string name; ///< for the factory: the same as long as the same devices are plugged in
  HidEntry entry;
  EvdevKind kind;
  std::string problem;  ///< empty, or the reason against its use, and the remedy
  bool hasTwin = false; ///< another one is plugged in that neither kind nor serial number tells apart
};

/// The devices that the kernel's own driver pushes, and joysticks without force that are not HID. Devices of the PID
/// class are left out, with all devices behind the same plug: PID devices are driven past that driver, and two that
/// drive one device undo each other. So are HID devices without force: the search through HID says why they cannot be
/// used. A usable device is opened for a moment to see whether this user may use it.
[[nodiscard]] std::vector<FoundEvdev> findEvdevDevices(EvdevBus& bus);

} // namespace palpate
