// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "devices/common/LinkedDevice.h"
#include "devices/hid/HidConnection.h"
#include "devices/hid/report/InputReport.h"

namespace palpate
{

/// A device that may be unplugged and plugged in again, shared by the threads of its link, with the last message about
/// the device. Any thread but the servo's.
template<class Attached>
class AttachedDevice
{
public:
  /// Null: there is no device. A pointer stays valid for its owner when the device is released.
  [[nodiscard]] std::shared_ptr<Attached> get() const
  {
    const std::lock_guard lock(this->mutex_);
    return this->device_;
  }
  /// Stores the device, and calls found() before any other thread can get it.
  template<class Found>
  void hold(std::shared_ptr<Attached> device, Found found)
  {
    const std::lock_guard lock(this->mutex_);
    this->device_ = std::move(device);
    this->message_ = this->lostFor_; // the reason for its loss, not for its absence since
    found();
  }
  /// Calls act() while `device` cannot be released; does nothing if the device was released before.
  template<class Act>
  void with(const std::shared_ptr<Attached>& device, Act act)
  {
    const std::lock_guard lock(this->mutex_);
    if (this->device_ == device)
    {
      act();
    }
  }
  void letGo() noexcept
  {
    const std::lock_guard lock(this->mutex_);
    this->device_.reset();
  }
  /// Releases `device` and calls lost(). False: the device was released before; another one stored by now stays.
  template<class Lost>
  bool letGo(const std::shared_ptr<Attached>& device, const std::string& why, Lost lost)
  {
    const std::lock_guard lock(this->mutex_);
    const bool held = this->device_ == device;
    if (held)
    {
      this->message_ = this->lostFor_ = why;
      this->device_.reset();
      lost();
    }
    return held;
  }
  void say(std::string message)
  {
    const std::lock_guard lock(this->mutex_);
    this->message_ = std::move(message);
  }
  /// Reports whether there is a device, the message, and the reason for the last release.
  void reportTo(LinkReport& report) const
  {
    const std::lock_guard lock(this->mutex_);
    report.attached = this->device_ != nullptr;
    report.message = this->message_;
    report.lostFor = this->lostFor_;
  }

private:
  mutable std::mutex mutex_;
  std::shared_ptr<Attached> device_;
  std::string message_;
  std::string lostFor_; ///< reason for the last release
};

/// Decides when to search for a lost device again. One thread.
class SearchPause
{
public:
  /// True: search now; not again for half a second.
  [[nodiscard]] bool over(std::int64_t now_ns) noexcept
  {
    constexpr std::int64_t tryAgainAfter_ns = 500000000;
    const bool over = this->triedAt_ns_ == 0 || now_ns - this->triedAt_ns_ >= tryAgainAfter_ns;
    this->triedAt_ns_ = over ? now_ns : this->triedAt_ns_;
    return over;
  }

private:
  std::int64_t triedAt_ns_ = 0;
};

/// Passes each report that is queued to take(report), after waiting up to `timeout_ms` for the first one. Below 0: the
/// device is gone.
template<class Take>
int takeReports(HidConnection& connection, int timeout_ms, Take take)
{
  constexpr int mostQueued = 256; // more reports than any system keeps
  std::array<std::uint8_t, InputReport::longest> report;
  int length = connection.read(report, timeout_ms);
  for (int i = 0; length > 0 && i < mostQueued; ++i)
  {
    take(std::span<const std::uint8_t>(report.data(), static_cast<std::size_t>(length)));
    length = connection.read(report, 0);
  }
  return length;
}

} // namespace palpate
