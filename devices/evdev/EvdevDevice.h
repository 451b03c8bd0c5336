// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/evdev/EvdevBus.h"
#include "devices/evdev/EvdevLink.h"
#include "devices/io/PushedDevice.h"

namespace palpate
{

/// A joystick or wheel that the kernel's own driver pushes: those of Logitech and Thrustmaster that are not of the USB
/// PID class, and old ones of I-Force. Its steps are known once it is open.
class EvdevDevice final : public PushedDevice<EvdevLink>
{
public:
  EvdevDevice(const std::string& name, const std::shared_ptr<EvdevBus>& bus, const HidEntry& entry,
    const PushedDeviceOptions& options = {});

  [[nodiscard]] std::string open() override;
};

} // namespace palpate
