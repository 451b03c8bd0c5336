// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/Clock.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/PeriodicTimer.h"

namespace palpate
{

/// Periods that the device begins: each of its samples is one, and the time since the sample before, rounded to whole
/// periods, tells how many were missed. Servo thread.
class DeviceTimer final : public TickTimer
{
public:
  DeviceTimer(HapticDevice& device, const Clock& clock, std::int64_t period_ns) noexcept
    : device_(device), clock_(clock), period_ns_(period_ns)
  {
  }
  Wakeup wait() noexcept override;
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->clock_.now_ns(); }

private:
  HapticDevice& device_;
  const Clock& clock_;
  std::int64_t period_ns_;
  std::int64_t last_ns_ = 0;
  bool started_ = false;
};

} // namespace palpate
