// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate::test
{

/// A hand that a test moves, of a device that pushes and turns it as far as the session knows, or not at all.
class HandOfTest final : public HapticDevice
{
public:
  explicit HandOfTest(bool turns)
  {
    this->info_.name = "test";
    this->info_.simulated = true;
    this->info_.rendersForce = false;
    this->info_.rendersTorque = turns;
  }

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override
  {
    sample.pose_D = this->hand_D_.read();
    sample.time_s = tickTime_s;
    return DeviceStatus::Ok;
  }
  void write(const DeviceCommand& /*command*/) noexcept override {}

  void move(const Pose& hand_D) { this->hand_D_.write(hand_D); }

private:
  DeviceInfo info_;
  TripleBuffer<Pose> hand_D_;
};

} // namespace palpate::test
