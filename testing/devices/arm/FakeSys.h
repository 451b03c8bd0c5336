// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{

/// The kernel's lists of attached devices, as files below a folder.
class FakeSys
{
public:
  [[nodiscard]] std::string path() const { return this->folder_.path().string(); }

  /// A USB device; its file is /dev/bus/usb/001/`number`.
  void plugUsb(const std::string& vendor, const std::string& product, int number) const
  {
    const std::filesystem::path device = this->folder_.path() / "bus/usb/devices" / ("1-" + std::to_string(number));
    describe(device, vendor, product, "");
    writeLine(device, "busnum", "1");
    writeLine(device, "devnum", std::to_string(number));
  }
  /// A serial line of a USB device; its file is /dev/`line`. The line belongs to an interface of the device.
  void plugSerial(const std::string& line, const std::string& vendor, const std::string& product,
    const std::string& serial = "") const
  {
    namespace files = std::filesystem;
    const files::path device = this->folder_.path() / "devices/usb1" / ("of-" + line);
    const files::path listed = this->folder_.path() / "class/tty" / line;
    describe(device, vendor, product, serial);
    files::create_directories(device / "interface");
    files::create_directories(listed);
    files::create_symlink(device / "interface", listed / "device");
  }

private:
  static void writeLine(const std::filesystem::path& folder, const std::string& name, const std::string& line)
  {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name) << line << '\n';
  }
  static void describe(const std::filesystem::path& device, const std::string& vendor, const std::string& product,
    const std::string& serial)
  {
    writeLine(device, "idVendor", vendor);
    writeLine(device, "idProduct", product);
    writeLine(device, "product", "board");
    if (!serial.empty())
    {
      writeLine(device, "serial", serial);
    }
  }

  TemporaryFolder folder_;
};

} // namespace palpate::test
