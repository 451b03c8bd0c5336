// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// The hand of a recording, from where there was one: gives its samples one a tick, then ends. Forces go nowhere.
class ReplayDevice final : public HapticDevice
{
public:
  explicit ReplayDevice(std::vector<DeviceSample> samples);
  /// Reads the samples of a recording when it is opened.
  explicit ReplayDevice(std::string recordingFile);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand&) noexcept override {}

private:
  DeviceInfo info_;
  std::string file_;
  std::vector<DeviceSample> samples_;
  std::size_t next_ = 0;
};

} // namespace palpate
