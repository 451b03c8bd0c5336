// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/io/PidLink.h"
#include "devices/io/PushedDevice.h"

namespace palpate
{

using PidDeviceOptions = PushedDeviceOptions;

/// A force-feedback joystick, wheel or base of the USB PID class.
class PidDevice final : public PushedDevice<PidLink>
{
public:
  PidDevice(const std::string& name, const std::shared_ptr<HidBus>& bus, const HidEntry& entry,
    const PidDeviceOptions& options = {});
};

/// Properties of the device of that entry, from its descriptor alone.
[[nodiscard]] DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale);

} // namespace palpate
