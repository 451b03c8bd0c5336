// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "devices/evdev/EvdevBus.h"

namespace palpate
{

/// Information of the kernel's files about event devices: that needs no permission, so a person learns of a device that
/// may not be opened, too. `event` is the device's folder, such as /sys/class/input/event3.

/// The numbers of the bits that are set in a line such as "3 0 100f": words of 64 bits, the highest first. Any other
/// line has none.
[[nodiscard]] std::vector<std::size_t> bitsOf(std::string_view line);

[[nodiscard]] EvdevTraits traitsOf(const std::filesystem::path& event);
[[nodiscard]] HidEntry entryOf(const std::filesystem::path& event);

/// The folders of the HID interfaces behind the plug of an event device, its own first; none where it is not HID. One
/// plug may have several, and a property of one of them is one of the device.
[[nodiscard]] std::vector<std::filesystem::path> hidFolders(const std::filesystem::path& event);

/// The program that has one of these interfaces open past the kernel's driver, as "NAME (process N)"; empty: none, as
/// far as this person may look.
[[nodiscard]] std::string hidrawHolder(
  const std::vector<std::filesystem::path>& folders, const std::filesystem::path& processes = "/proc");

} // namespace palpate
