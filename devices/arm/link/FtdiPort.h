// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "haptics/core/Outcome.h"

namespace palpate
{

/// An open USB device whose chip is FTDI's, as far as an arm needs it. Calls may block; one thread.
class FtdiPort
{
public:
  static constexpr unsigned out = 0x02, in = 0x81; ///< bulk endpoints

  virtual ~FtdiPort() = default;

  /// A vendor request to the device. False: it was refused or the device is gone.
  [[nodiscard]] virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
  [[nodiscard]] virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// One transfer, which begins with two bytes of the chip's own: its length, 0 when none came, below 0 when the device
  /// is gone.
  [[nodiscard]] virtual int read(std::span<std::uint8_t> bytes, int timeout_ms) noexcept = 0;
  [[nodiscard]] virtual std::string error() const = 0;
  /// Of the open device, for a guard; below 0: there is none.
  [[nodiscard]] virtual int handle() const noexcept = 0;
};

/// Empty, or the reason why this build of the program opens no such device, and the remedy.
[[nodiscard]] std::string ftdiAbsence();
/// Opens the device at a path of the system, /dev/bus/usb/BBB/DDD, for this process alone, by libusb.
[[nodiscard]] Outcome<std::unique_ptr<FtdiPort>> openFtdi(const std::string& path);

} // namespace palpate
