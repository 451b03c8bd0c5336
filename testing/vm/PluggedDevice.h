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

#include "testing/devices/hid/VirtualHid.h"

namespace palpate::test
{

/// Identity of a device, told to the kernel before it asks for anything.
struct PlugIdentity
{
  std::string name, serial;
  std::uint16_t vendor = 0x1209, product = 0x0001, release = 0x0100; ///< the numbers that pid.codes keeps for tests
  std::vector<std::uint8_t> descriptor;
  std::vector<std::uint8_t> stopOrder = {}; ///< the report that ends all effects
};

/// A virtual device that the kernel takes for one that is plugged in: its firmware runs in real time in a thread of its
/// own, a millisecond at a time, and talks to the kernel through the transport that a subclass is.
class PluggedDevice
{
public:
  using Instant = std::chrono::steady_clock::time_point;

  /// The firmware must outlive it.
  PluggedDevice(VirtualHid& firmware, PlugIdentity identity);
  virtual ~PluggedDevice() = default;
  PluggedDevice(const PluggedDevice&) = delete;
  PluggedDevice& operator=(const PluggedDevice&) = delete;

  /// Power on: its memory is empty. Throws std::system_error where the kernel does not take it.
  void plug();
  void unplug();

  /// The firmware's own clock since it was made.
  [[nodiscard]] std::int64_t time_ms() const noexcept { return this->time_ms_; }
  [[nodiscard]] const PlugIdentity& identity() const noexcept { return this->identity_; }
  [[nodiscard]] const std::string& serial() const noexcept { return this->identity_.serial; }

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
  virtual void send(std::span<const std::uint8_t> input) = 0;
  /// Ends every millisecond.
  virtual void frame() {}

  [[nodiscard]] bool take(HidReportKind kind, std::span<const std::uint8_t> report);
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t id);

private:
  void run();
  void passMillisecond();

  VirtualHid& firmware_;
  PlugIdentity identity_;
  std::mutex mutex_;
  std::atomic<std::int64_t> time_ms_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

} // namespace palpate::test
