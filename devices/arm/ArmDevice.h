// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/arm/AnswerBell.h"
#include "devices/arm/ArmLink.h"
#include "devices/common/DeviceSteps.h"
#include "devices/common/LinkedDevice.h"
#include "devices/io/ServedLink.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// How an ArmDevice runs; the defaults are for people, the rest for tests.
struct ArmDeviceOptions
{
  bool threads = true;          ///< false: nothing runs by itself, the link's passes are called from outside
  const Clock* clock = nullptr; ///< null: the system's monotonic clock; must outlive the device
};

/// An arm that a person owns: a link, a protocol and the kinematics. Its answers pace the servo. Reading and writing
/// are wait-free whatever the device does. Its force is limited to 1 N until it was proven.
class ArmDevice final
  : public HapticDevice
  , public LinkedDevice
  , public PreparedDevice
  , public ProvenDevice
{
public:
  ArmDevice(const std::string& name, const std::shared_ptr<ArmBus>& bus, const HidEntry& entry, const ArmSetup& setup,
    const ArmDeviceOptions& options = {});
  ~ArmDevice() override { this->link_.close(); }
  ArmDevice(const ArmDevice&) = delete;
  ArmDevice& operator=(const ArmDevice&) = delete;

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override { this->link_.close(); }
  void await() noexcept override;
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->link_->command(command); }

  [[nodiscard]] LinkReport linkReport() const override { return this->link_->report(); }
  [[nodiscard]] DeviceAbilities abilitiesNow() const override { return this->info_.abilities; }
  [[nodiscard]] std::optional<DeviceStep> step() const override { return this->link_->step(); }
  void stepDone(const std::string& file) const override { this->link_->stepDone(file); }
  void prove() noexcept override;

  [[nodiscard]] ArmLink& link() noexcept { return *this->link_; }

private:
  DeviceInfo info_;
  ArmSetup setup_;
  ArmDeviceOptions options_;
  AnswerBell::Shared bell_; ///< the exchange thread's too
  ServedLink<ArmLink> link_;

  std::uint64_t heardOf_ = 0; ///< servo's: answers
  double heardAt_s_ = 0.0;    ///< servo's
};

/// Properties of such an arm before it is opened.
[[nodiscard]] DeviceInfo armInfo(const std::string& name, const HidEntry& entry, const ArmSetup& setup);

} // namespace palpate
