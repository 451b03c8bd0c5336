// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include "devices/hid/HidConnection.h"

namespace palpate
{

using UsbIds = std::vector<std::pair<std::uint16_t, std::uint16_t>>; ///< maker and product, 0: any

/// Devices by their numbers, or one of them.
struct UsbDevices
{
  UsbIds ids;
  std::string serial; ///< empty: any

  [[nodiscard]] bool have(const HidEntry& entry) const noexcept;
};
/// Their numbers as lsusb shows them, "2341:003e".
[[nodiscard]] std::vector<std::string> numbersOf(const UsbDevices& devices);

/// USB devices with these numbers, as the kernel lists them below `sys`; a path is a file of /dev/bus/usb. Needs no
/// permission.
[[nodiscard]] std::vector<HidEntry> usbPlugs(const UsbIds& ids, const std::string& sys = "/sys");
/// Serial lines of USB devices with these numbers; a path is a file of /dev.
[[nodiscard]] std::vector<HidEntry> serialPlugs(const UsbIds& ids, const std::string& sys = "/sys");

/// Who answers whether this process may use a file, as access() of POSIX does.
using FileAccess = int (*)(const char* path, int mode);
/// The reason why the system would not open this file now, and the remedy; empty: it would.
[[nodiscard]] std::string fileRefusal(const std::string& path, FileAccess access = ::access);

} // namespace palpate
