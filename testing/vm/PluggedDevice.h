// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{

/// A virtual joystick that the kernel takes for one that is plugged in: its firmware runs in real time in a thread of
/// its own, a millisecond at a time, and talks to the kernel through the transport that a subclass is.
class PluggedDevice
{
public:
  using Instant = std::chrono::steady_clock::time_point;

  PluggedDevice(const PidLayout& layout, std::string serial);
  virtual ~PluggedDevice() = default;
  PluggedDevice(const PluggedDevice&) = delete;
  PluggedDevice& operator=(const PluggedDevice&) = delete;

  /// Power on: its memory is empty. Throws std::system_error where the kernel does not take it.
  void plug();
  void unplug();

  /// Reads or changes the firmware while it stands still.
  template<class Body>
  auto alone(Body body)
  {
    const std::lock_guard lock(this->mutex_);
    return body(this->firmware_);
  }
  /// Of all effects now along x [share].
  [[nodiscard]] double forceX()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.force()[0]; });
  }
  [[nodiscard]] int effectsPlaying()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.effectsPlaying(); });
  }
  [[nodiscard]] int badReports()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.badReports; });
  }
  /// Orders to stop all effects that it has taken.
  [[nodiscard]] int stopAlls()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.stopAlls; });
  }
  /// What the firmware's own clock shows since it was made.
  [[nodiscard]] std::int64_t time_ms() const noexcept { return this->time_ms_; }
  [[nodiscard]] const PidLayout& layout() const noexcept { return this->layout_; }
  [[nodiscard]] const std::string& serial() const noexcept { return this->serial_; }

  /// It takes nothing from the host any more; its effects go on and its input reports too.
  std::atomic<bool> stalls = false;

protected:
  virtual void attach() = 0;
  virtual void detach() noexcept = 0;
  /// Answers the host until then, or less long.
  virtual void serve(Instant until) = 0;
  virtual void send(std::span<const std::uint8_t> input) = 0;
  /// Ends every millisecond.
  virtual void frame() {}

  [[nodiscard]] bool take(HidReportKind kind, std::span<const std::uint8_t> report);
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t id);

private:
  void run();
  void passMillisecond();

  PidLayout layout_;
  std::string serial_;
  std::mutex mutex_;
  VirtualPidDevice firmware_;
  std::atomic<std::int64_t> time_ms_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

} // namespace palpate::test
