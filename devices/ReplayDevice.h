// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "devices/RecordedHand.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// The hand of a recording, from where there was one: gives its samples one a tick, then ends. Forces go nowhere.
class ReplayDevice final : public HapticDevice
{
public:
  explicit ReplayDevice(std::vector<DeviceSample> samples);
  /// Reads the recording when it is opened first.
  explicit ReplayDevice(std::string recordingFile);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  /// Begins anew.
  [[nodiscard]] std::string open() override;
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand&) noexcept override {}

  /// The recording, once the device is open.
  [[nodiscard]] const RecordedHand& hand() const noexcept { return this->hand_; }

private:
  DeviceInfo info_;
  std::string file_;
  RecordedHand hand_;
  std::size_t next_ = 0;
};

} // namespace palpate
