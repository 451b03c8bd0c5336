// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/Plugs.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "devices/common/AttributeFile.h"
#include "devices/hid/HidapiBus.h"
#include "haptics/core/Text.h"

namespace palpate
{
namespace
{

namespace files = std::filesystem;

/// None: another device.
std::optional<HidEntry> plugAt(const files::path& folder, const UsbIds& ids)
{
  HidEntry entry;
  entry.vendor = hexIn(folder / "idVendor");
  entry.product = hexIn(folder / "idProduct");
  entry.serial = lineOf(folder / "serial");
  entry.name = lineOf(folder / "product");
  return UsbDevices{ ids, {} }.have(entry) ? std::optional(entry) : std::nullopt;
}

} // namespace

bool UsbDevices::have(const HidEntry& entry) const noexcept
{
  const auto isIt = [&entry](const auto& id)
  { return id.first == entry.vendor && (id.second == entry.product || id.second == 0); };
  return std::any_of(this->ids.begin(), this->ids.end(), isIt) &&
         (this->serial.empty() || this->serial == entry.serial);
}

std::vector<std::string> numbersOf(const UsbDevices& devices)
{
  std::vector<std::string> numbers;
  for (const auto& [maker, product] : devices.ids)
  {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%04x:%04x", maker, product);
    numbers.emplace_back(text.data());
  }
  return numbers;
}

std::vector<HidEntry> usbPlugs(const UsbIds& ids, const std::string& sys)
{
  std::vector<HidEntry> plugs;
  for (const files::path& folder : entriesOf(files::path(sys) / "bus/usb/devices"))
  {
    if (std::optional<HidEntry> entry = plugAt(folder, ids))
    {
      const int bus = numberIn<int>(lineOf(folder / "busnum")).value_or(0);
      const int device = numberIn<int>(lineOf(folder / "devnum")).value_or(0);
      std::array<char, 40> path{};
      std::snprintf(path.data(), path.size(), "/dev/bus/usb/%03d/%03d", bus, device);
      entry->path = path.data();
      plugs.push_back(std::move(*entry));
    }
  }
  return plugs;
}

/// The line belongs to an interface, whose folder lies in that of the device.
std::vector<HidEntry> serialPlugs(const UsbIds& ids, const std::string& sys)
{
  std::vector<HidEntry> plugs;
  for (const files::path& folder : entriesOf(files::path(sys) / "class/tty"))
  {
    std::error_code error;
    const files::path interface = files::canonical(folder / "device", error);
    std::optional<HidEntry> entry = error ? std::nullopt : plugAt(interface.parent_path(), ids);
    if (entry)
    {
      entry->path = "/dev/" + folder.filename().string();
      plugs.push_back(std::move(*entry));
    }
  }
  return plugs;
}

std::string fileRefusal(const std::string& path, FileAccess access)
{
  return access(path.c_str(), R_OK | W_OK) == 0 ? "" : openProblem(path, errno);
}

} // namespace palpate
