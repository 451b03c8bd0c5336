// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/calibration/Calibration.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// The description of a checked device. The device's workspace is the largest ball between its ends. Walls that were
/// felt are left to the device; those of a simulated one need no proof. A device with one axis is a wheel.
[[nodiscard]] DeviceInfo calibratedInfo(DeviceInfo info, const Calibration& calibration);

/// A stick of which only x is there: some wheels call themselves sticks. An arm keeps its class.
[[nodiscard]] DeviceInfo asWheel(DeviceInfo info);

/// Of such a device of which nobody knows more. `date`: YYYY-MM-DD.
[[nodiscard]] Calibration wheelCalibration(const DeviceInfo& info, const std::string& date);

/// A device seen through its calibration: x is to the right, y up or away, z towards the person, the middle of its
/// range is the origin, and a force pushes where it points. Forces are never made larger. Orientations and torques are
/// passed on as they are. Real-time safe where the device is.
class CalibratedDevice final : public HapticDevice
{
public:
  /// The calibration must be one that is not refused.
  CalibratedDevice(std::unique_ptr<HapticDevice> device, const Calibration& calibration);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override { this->device_->close(); }
  void await() noexcept override { this->device_->await(); }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  /// The device itself.
  [[nodiscard]] HapticDevice& inner() const noexcept { return *this->device_; }

private:
  std::unique_ptr<HapticDevice> device_;
  Calibration calibration_;
  DeviceInfo info_;
  Mat3 sensors_;  ///< from the driver's axes to D: a permutation with signs
  Mat3 motors_;   ///< from D to the driver's axes of force
  Vec3 middle_D_; ///< of the range, before it becomes the origin
};

} // namespace palpate
