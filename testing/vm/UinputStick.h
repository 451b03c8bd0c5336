// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>

#include "testing/devices/evdev/VirtualDriver.h"

namespace palpate::test
{

/// A force-feedback stick that a program makes up through /dev/uinput: the kernel hands its effects to this thread,
/// which plays them at 1 kHz. Numbers of maker and product are its own, for uinput gives no serial number.
class UinputStick
{
public:
  /// Throws std::system_error where the kernel does not take it.
  explicit UinputStick(std::uint16_t product);
  ~UinputStick();
  UinputStick(const UinputStick&) = delete;
  UinputStick& operator=(const UinputStick&) = delete;

  static constexpr std::uint16_t vendor = 0x1209;

  /// Reads or changes the driver while it stands still.
  template<class Body>
  auto alone(Body body)
  {
    const std::lock_guard lock(this->mutex_);
    return body(this->driver_);
  }
  [[nodiscard]] VirtualDriver::Axes force()
  {
    return this->alone([](VirtualDriver& driver) { return driver.force(); });
  }
  [[nodiscard]] int playing()
  {
    return this->alone([](VirtualDriver& driver) { return driver.playing(); });
  }
  [[nodiscard]] std::int64_t time_ms() const noexcept { return this->time_ms_; }

  /// It answers nothing the kernel asks.
  std::atomic<bool> hangs = false;

private:
  void create(std::uint16_t product);
  void run();
  void answer();
  void answerUpload(std::int32_t request);
  void answerErase(std::int32_t request);
  void say(std::uint16_t type, std::uint16_t code, std::int32_t value) const;
  void showHandle();

  int file_ = -1;
  std::mutex mutex_;
  VirtualDriver driver_;
  VirtualDriver::Axes shown_{ -2.0, -2.0 };
  std::atomic<std::int64_t> time_ms_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

} // namespace palpate::test
