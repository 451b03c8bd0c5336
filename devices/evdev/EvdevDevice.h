// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/common/HeldTrust.h"
#include "devices/common/LinkedDevice.h"
#include "devices/evdev/EvdevBus.h"
#include "devices/evdev/EvdevLink.h"
#include "devices/io/PidDevice.h"
#include "devices/io/ServedLink.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// A joystick or wheel that the kernel's own driver pushes: those of Logitech and Thrustmaster that are not of the USB
/// PID class, and old ones of I-Force. A reader and a writer thread of its own, as a PidDevice has. Its lengths and
/// forces are assumed until somebody measures them.
class EvdevDevice final
  : public HapticDevice
  , public LinkedDevice
  , public WallHolder
{
public:
  EvdevDevice(const std::string& name, const std::shared_ptr<EvdevBus>& bus, HidEntry entry,
    const PidDeviceOptions& options = {});

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override { this->link_.close(); }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->link_->command(command); }

  [[nodiscard]] LinkReport linkReport() const override { return this->link_->report(); }
  [[nodiscard]] DeviceAbilities abilitiesNow() const override;

  void trust(HeldTrust trust) noexcept override;
  [[nodiscard]] DeviceAbilities offered() const override;

  [[nodiscard]] EvdevLink& link() noexcept { return *this->link_; }

private:
  /// Says of itself what it is believed.
  void believe();

  DeviceInfo info_;
  PidDeviceOptions options_;
  DeviceAbilities promised_; ///< by its driver
  ServedLink<EvdevLink> link_;
};

} // namespace palpate
