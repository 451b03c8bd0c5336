// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>

#include "haptics/core/Clock.h"

namespace palpate::test
{

/// A virtual device that the kernel takes for one that is plugged in: its firmware runs in real time in a thread of its
/// own, a millisecond at a time, and talks to the kernel through the transport that a subclass is.
class RunningDevice
{
public:
  using Instant = std::chrono::steady_clock::time_point;

  RunningDevice() = default;
  virtual ~RunningDevice() = default;
  RunningDevice(const RunningDevice&) = delete;
  RunningDevice& operator=(const RunningDevice&) = delete;

  /// Throws std::system_error where the kernel does not take it.
  void plug();
  void unplug();

  /// The firmware's own clock since it was made.
  [[nodiscard]] std::int64_t time_ms() const noexcept { return this->time_ms_; }

  /// It takes nothing from the host any more; its effects go on and its input reports too.
  std::atomic<bool> stalls = false;

protected:
  /// Does something while the firmware stands still.
  template<class Body>
  auto still(Body body)
  {
    const std::lock_guard lock(this->mutex_);
    return body();
  }
  /// The firmware as it is before anybody has used it. The handle stands still.
  virtual void powerOn() = 0;
  virtual void attach() = 0;
  virtual void detach() noexcept = 0;
  /// Answers the host until then, or less long.
  virtual void serve(Instant until) = 0;
  virtual void passMillisecond() = 0;

private:
  void run();

  std::mutex mutex_;
  std::atomic<std::int64_t> time_ms_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

/// A device's own time as a program's clock: a machine that stands still for a while has lost no time. Stands while the
/// device is unplugged.
class FirmwareClock final : public Clock
{
public:
  /// The device must outlive it.
  explicit FirmwareClock(const RunningDevice& device) : device_(device) {}
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return perMs_ns * this->device_.time_ms(); }

private:
  const RunningDevice& device_;
};

} // namespace palpate::test
