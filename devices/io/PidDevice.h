// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/common/HeldTrust.h"
#include "devices/common/LinkedDevice.h"
#include "devices/io/PidLink.h"
#include "devices/io/ServedLink.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// How a PidDevice runs; the defaults are for people, the rest for tests.
struct PidDeviceOptions
{
  PidOutputOptions output;
  bool threads = true;          ///< false: nothing runs by itself, the link's passes are called from outside
  const Clock* clock = nullptr; ///< null: the system's monotonic clock; must outlive the device
};

/// A force-feedback joystick, wheel or base of the USB PID class, with a reader and a writer thread of its own. Reading
/// and writing are wait-free whatever the device does. Its lengths and forces are assumed until somebody measures them.
class PidDevice final
  : public HapticDevice
  , public LinkedDevice
  , public WallHolder
{
public:
  PidDevice(
    const std::string& name, const std::shared_ptr<HidBus>& bus, HidEntry entry, const PidDeviceOptions& options = {});

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override { this->link_.close(); }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->link_->command(command); }

  [[nodiscard]] LinkReport linkReport() const override { return this->link_->report(); }
  [[nodiscard]] DeviceAbilities abilitiesNow() const override;

  void trust(HeldTrust trust) noexcept override;
  [[nodiscard]] DeviceAbilities offered() const override;

  [[nodiscard]] PidLink& link() noexcept { return *this->link_; }

private:
  DeviceInfo info_;
  HidEntry entry_;
  PidDeviceOptions options_;
  DeviceAbilities promised_; ///< by its descriptor
  ServedLink<PidLink> link_;
};

/// What a device of that entry is, from its descriptor alone.
[[nodiscard]] DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale);

} // namespace palpate
