// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/hid/HidConnection.h"

namespace palpate
{

/// The HID devices of this computer, through hidapi on the kernel's hidraw, whose descriptors stand in `sysfs`.
[[nodiscard]] std::shared_ptr<HidBus> systemHidBus(const std::string& sysfs = "/sys/class/hidraw");

/// Why the system did not open a device, from its error number, and the remedy.
[[nodiscard]] std::string openProblem(const std::string& path, int systemError);

} // namespace palpate
