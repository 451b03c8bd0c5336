// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/DeviceCommand.h"
#include "haptics/core/DeviceInfo.h"
#include "haptics/core/DeviceSample.h"

namespace palpate
{

enum class DeviceStatus : std::uint8_t
{
  Ok,
  Ended,   ///< a scripted or replayed device has no more samples
  Lost,    ///< the device does not answer any more
  Waiting, ///< the hand's place has not been given yet
};

/// The seam between the servo and whatever moves and pushes a hand.
///
/// read() and write() are called from the servo thread only, once each per tick, in that order; they are
/// wait-free, allocate nothing and never ask a clock: the tick's time is handed in. A device that needs
/// blocking I/O keeps its own threads behind this interface.
class HapticDevice
{
public:
  virtual ~HapticDevice() = default;

  [[nodiscard]] virtual const DeviceInfo& info() const noexcept = 0;

  /// Makes the device ready. Not real-time safe. Returns an empty string, or the reason and the remedy.
  [[nodiscard]] virtual std::string open() = 0;

  /// Leaves the device without force. Not real-time safe.
  virtual void close() noexcept = 0;

  /// Waits until the device has measured the hand anew, but never for more than a few periods: a device that hangs is
  /// told by read(). Called once before each read() of a device whose pacing is not Pacing::Timer, and of no other.
  virtual void await() noexcept {}

  /// The hand at tick time `tickTime_s` [s]. Real-time safe.
  [[nodiscard]] virtual DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept = 0;

  /// The command that holds until the next write. Real-time safe.
  virtual void write(const DeviceCommand& command) noexcept = 0;
};

} // namespace palpate
