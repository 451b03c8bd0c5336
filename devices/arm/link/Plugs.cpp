// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/Plugs.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <unistd.h>

#include "devices/common/AttributeFile.h"
#include "devices/hid/HidapiBus.h"
#include "haptics/core/Text.h"

namespace palpate
{
namespace
{

namespace files = std::filesystem;

std::string attribute(const files::path& folder, const char* name)
{
  std::string text = contentOf(folder / name);
  text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
  return text;
}

std::uint16_t hexNumber(const std::string& text)
{
  std::uint16_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number, 16);
  return number;
}

/// None: another device.
std::optional<HidEntry> plugAt(const files::path& folder, const UsbIds& ids)
{
  HidEntry entry;
  entry.vendor = hexNumber(attribute(folder, "idVendor"));
  entry.product = hexNumber(attribute(folder, "idProduct"));
  entry.serial = attribute(folder, "serial");
  entry.name = attribute(folder, "product");
  const bool wanted = std::any_of(ids.begin(), ids.end(),
    [&entry](const auto& id) { return id.first == entry.vendor && (id.second == entry.product || id.second == 0); });
  return wanted ? std::optional(entry) : std::nullopt;
}

std::vector<files::path> foldersOf(const files::path& folder)
{
  std::vector<files::path> all;
  std::error_code ignored;
  for (files::directory_iterator at(folder, ignored), end; !ignored && at != end; at.increment(ignored))
  {
    all.push_back(at->path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace

std::vector<HidEntry> usbPlugs(const UsbIds& ids, const std::string& sys)
{
  std::vector<HidEntry> plugs;
  for (const files::path& folder : foldersOf(files::path(sys) / "bus/usb/devices"))
  {
    if (std::optional<HidEntry> entry = plugAt(folder, ids))
    {
      const int bus = numberIn<int>(attribute(folder, "busnum")).value_or(0);
      const int device = numberIn<int>(attribute(folder, "devnum")).value_or(0);
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
  for (const files::path& folder : foldersOf(files::path(sys) / "class/tty"))
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

std::string fileRefusal(const std::string& path)
{
  return access(path.c_str(), R_OK | W_OK) == 0 ? "" : openProblem(path, errno);
}

} // namespace palpate
