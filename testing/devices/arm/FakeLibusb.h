// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "devices/arm/link/FtdiPort.h"

namespace palpate::test
{

/// The chip behind the functions of libusb that FakeLibusb.cpp puts in the place of the library's, for as long as this
/// object lives. One at a time: a C interface has no other place for it. A read of a chip that has nothing takes a
/// millisecond, as its latency is.
class FakeLibusb
{
public:
  explicit FakeLibusb(FtdiPort& chip) noexcept;
  ~FakeLibusb();
  FakeLibusb(const FakeLibusb&) = delete;
  FakeLibusb& operator=(const FakeLibusb&) = delete;

  /// Does something with the chip while no function of libusb does.
  template<class Body>
  auto alone(Body body)
  {
    const std::lock_guard lock(this->mutex_);
    return body(this->chip_);
  }
  /// How often a program has opened the chip.
  [[nodiscard]] int opened()
  {
    return this->alone([this](FtdiPort&) { return this->opened_; });
  }

  /// Used by the functions of libusb.
  void open()
  {
    this->alone([this](FtdiPort&) { ++this->opened_; });
  }
  /// False: another program has it.
  [[nodiscard]] bool claim();
  void release()
  {
    this->alone([this](FtdiPort&) { this->claimed_ = false; });
  }

private:
  std::mutex mutex_;
  FtdiPort& chip_;
  int opened_ = 0;
  bool claimed_ = false;
};

} // namespace palpate::test
