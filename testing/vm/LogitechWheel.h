// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "testing/devices/hid/VirtualHid.h"
#include "testing/vm/UsbDevice.h"

namespace palpate::test
{

/// The firmware of a wheel that takes Logitech's orders of seven bytes, as far as the kernel's driver gives them
/// (drivers/hid/hid-lg4ff.c): 11 08 F 80, a force F in slot 1, below 80 to the right, 80 none; 13, no force in slot 1;
/// f5, its own spring off; fe 0d .., how strong that is, and 14, on; f8 81 and two bytes, its range in degrees.
class LogitechWheel final : public VirtualHid
{
public:
  bool take(HidReportKind kind, std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t) override { return {}; }
  [[nodiscard]] std::vector<std::uint8_t> nextInput() override;
  void advance(int duration_ms) override;

  /// To the right [share of the largest].
  [[nodiscard]] double force() const noexcept { return (0x80 - this->level) / 128.0; }

  double position = 0.0; ///< share, -1 .. 1
  std::uint32_t buttons = 0;
  int level = 0x80;
  bool ownSpring = true; ///< a wheel wakes with it
  int range_deg = 0;
  int orders = 0, unknown = 0;

private:
  std::deque<std::vector<std::uint8_t>> inputs_;
  std::vector<std::uint8_t> shown_;
};

/// Its own description, written for these tests: a wheel of 16 bits, three pedals, 24 buttons, seven bytes out.
[[nodiscard]] std::vector<std::uint8_t> wheelDescriptor();

/// A base, so that it is there before the transport and after it.
class WheelFirmware
{
protected:
  LogitechWheel wheel_;
};

/// A G29 on the virtual bus: only the kernel's own driver knows its commands. That driver takes no other transport.
class UsbWheel final
  : private WheelFirmware
  , public UsbTransport
{
public:
  UsbWheel();
  ~UsbWheel() override { this->unplug(); }

  template<class Body>
  auto alone(Body body)
  {
    return this->still([&] { return body(this->wheel_); });
  }
  [[nodiscard]] double forceX()
  {
    return this->alone([](LogitechWheel& wheel) { return wheel.force(); });
  }

private:
  void powerOn() override { this->wheel_ = LogitechWheel(); }
};

} // namespace palpate::test
