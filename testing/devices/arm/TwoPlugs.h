// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "devices/DeviceFactory.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/FakeSys.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate::test
{

/// The kernel's lists of a Falcon and of a 2DIY.
class TwoPlugs
{
public:
  TwoPlugs()
  {
    this->sys_.plugUsb("0403", "cb48", 7);
    this->sys_.plugSerial("ttyACM3", "2341", "003e");
  }

  [[nodiscard]] std::string sys() const { return this->sys_.path(); }
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
  FakeSys sys_;
};

} // namespace palpate::test
