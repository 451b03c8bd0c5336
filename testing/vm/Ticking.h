// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "haptics/core/HapticDevice.h"

namespace palpate::test
{

/// Looks every millisecond. False: it has not come within that time.
bool waitUntil(const std::function<bool()>& done, int patience_ms = 5000);

/// A servo that ticks a device about once a millisecond in the caller's thread. Times are real.
class Ticking
{
public:
  /// The device must outlive it.
  explicit Ticking(HapticDevice& device) : ticked_(device) {}

  void run(int duration_ms);
  /// Runs until then. False: it has not come within that time.
  bool runUntil(const std::function<bool()>& done, int patience_ms = 5000);

  DeviceCommand command;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;

private:
  void tick();

  HapticDevice& ticked_;
};

} // namespace palpate::test
