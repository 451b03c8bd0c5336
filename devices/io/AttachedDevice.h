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

/// A device that comes and goes, held by the threads of its link, with the last message about it. Any thread but the
/// servo's.
template<class Attached>
class AttachedDevice
{
public:
  /// Null: no device is there. A pointer stays valid for its holder when the device is let go.
  [[nodiscard]] std::shared_ptr<Attached> get() const
  {
    const std::lock_guard lock(this->mutex_);
    return this->device_;
  }
  /// Holds the device from now on, and calls found() before anybody else can have it.
  template<class Found>
  void hold(std::shared_ptr<Attached> device, Found found)
  {
    const std::lock_guard lock(this->mutex_);
    this->device_ = std::move(device);
    this->message_ = this->lostFor_; // the reason for its loss, not for its absence since
    found();
  }
  /// Does something while nobody lets go of `device`; nothing if it has been let go of.
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
  /// The same of `device`, and calls lost(). False: it was let go already; another device that is held by now stays.
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
  /// Writes down whether it is there, the message, and why it was let go of last.
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
  std::string lostFor_; ///< why it was let go of last
};

/// Says when it is time to look for a lost device again. One thread.
class SearchPause
{
public:
  /// True: look now; not again for half a second.
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

/// Hands each report that waits to take(report); for the first one it waits up to `timeout_ms`. Below 0: the device is
/// gone.
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
