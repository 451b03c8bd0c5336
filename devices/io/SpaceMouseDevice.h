// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/common/LinkedDevice.h"
#include "devices/io/CapMotion.h"
#include "devices/io/ServedLink.h"
#include "devices/io/SpaceMouseLink.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// Options of a SpaceMouseDevice; the defaults are for users, other values for tests.
struct SpaceMouseOptions
{
  CapMotionOptions motion;
  bool threads = true;          ///< false: no threads, the link's passes are called from outside
  const Clock* clock = nullptr; ///< null: the system's monotonic clock; must outlive the device
};

/// A SpaceMouse moves the hand with six degrees of freedom and gives no force. A pressed cap moves and rotates the
/// hand; a cap that is released, or has sent no report for a tenth of a second, stops the hand. Its buttons can be the
/// dead-man switch. Reading is wait-free whatever the device does.
class SpaceMouseDevice final
  : public HapticDevice
  , public LinkedDevice
{
public:
  SpaceMouseDevice(
    const std::string& name, const std::shared_ptr<HidBus>& bus, HidEntry entry, const SpaceMouseOptions& options = {});

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override { this->link_.close(); }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand&) noexcept override {}

  [[nodiscard]] LinkReport linkReport() const override { return this->link_->report(); }
  [[nodiscard]] DeviceAbilities abilitiesNow() const override { return this->info_.abilities; }

  [[nodiscard]] SpaceMouseLink& link() noexcept { return *this->link_; }

private:
  [[nodiscard]] Cap heard(double tickTime_s, const SpaceMouseLink::News& news) noexcept;

  DeviceInfo info_;
  HidEntry entry_;
  SpaceMouseOptions options_;
  ServedLink<SpaceMouseLink> link_;

  CapMotion motion_;          ///< servo's
  double lastTick_s_ = never; ///< servo's
  double heardAt_s_ = 0.0;    ///< servo's
  std::uint64_t heardOf_ = 0; ///< servo's
  static constexpr double never = -1.0;
};

} // namespace palpate
