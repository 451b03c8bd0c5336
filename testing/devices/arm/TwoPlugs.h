// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "devices/DeviceFactory.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{

/// The kernel's lists of a Falcon and of a 2DIY.
class TwoPlugs
{
public:
  TwoPlugs()
  {
    const std::filesystem::path falcon = this->sys_.path() / "bus/usb/devices/1-1";
    writeLine(falcon, "idVendor", "0403");
    writeLine(falcon, "idProduct", "cb48");
    writeLine(falcon, "busnum", "1");
    writeLine(falcon, "devnum", "7");
    const std::filesystem::path board = this->sys_.path() / "devices/usb1/1-2";
    const std::filesystem::path line = this->sys_.path() / "class/tty/ttyACM3";
    writeLine(board, "idVendor", "2341");
    writeLine(board, "idProduct", "003e");
    std::filesystem::create_directories(board / "1-2:1.0");
    std::filesystem::create_directories(line);
    std::filesystem::create_symlink(board / "1-2:1.0", line / "device");
  }

  [[nodiscard]] std::string sys() const { return this->sys_.path().string(); }
  /// A computer with these two alone, whose system answers so.
  [[nodiscard]] DeviceOptions options(FileAccess access) const
  {
    DeviceOptions options;
    options.hid = std::make_shared<FakeHidBus>();
    options.arms = std::make_shared<const std::vector<ArmKit>>(
      std::vector<ArmKit>{ falconKit(this->sys(), access), twoDiyKit(this->sys(), access) });
    return options;
  }
  /// As they are listed there.
  [[nodiscard]] std::vector<KnownDevice> listed(FileAccess access) const
  {
    std::vector<KnownDevice> known = knownDevices(this->options(access));
    return { known.end() - 2, known.end() };
  }

private:
  static void writeLine(const std::filesystem::path& folder, const std::string& name, const std::string& line)
  {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name) << line << '\n';
  }

  TemporaryFolder sys_;
};

} // namespace palpate::test
