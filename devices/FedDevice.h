// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// A device whose poses a program feeds: the mouse in a view, a script, a test. What is fed last holds.
class FedDevice final : public HapticDevice
{
public:
  FedDevice();

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->command_.write(command); }

  /// Feeding thread only; wait-free. The time of the sample is set by the tick that reads it.
  void feed(const DeviceSample& sample) noexcept { this->fed_.write(sample); }
  /// The newest command. Feeding thread only; wait-free.
  [[nodiscard]] const DeviceCommand& command() noexcept { return this->command_.read(); }

private:
  DeviceInfo info_;
  TripleBuffer<DeviceSample> fed_;
  TripleBuffer<DeviceCommand> command_;
};

} // namespace palpate
