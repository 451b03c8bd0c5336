// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// One HID device as the system lists it.
struct HidEntry
{
  std::string path; ///< where it is now; another one after it was plugged in again
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string serial; ///< empty where it has none
  std::string name;   ///< the maker's name for it
  HidUsage usage = 0; ///< its purpose, if the system reports it
};

/// An open HID device. Calls may block: on USB a write takes a frame, and seconds once the device has stopped
/// answering, so none of this runs on the servo thread. read() may run in one thread while another does the rest. A
/// report begins with its ID, 0 where the device has none; read() alone leaves that 0 out.
class HidConnection
{
public:
  virtual ~HidConnection() = default;

  /// The next input report within `timeout_ms`: its length [bytes], 0 when none came, -1 when the device is gone.
  [[nodiscard]] virtual int read(std::span<std::uint8_t> report, int timeout_ms) noexcept = 0;
  /// False: the device is gone or has not taken it in time.
  [[nodiscard]] virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
  [[nodiscard]] virtual bool setFeature(std::span<const std::uint8_t> report) noexcept = 0;
  /// The report whose ID stands in report[0]: its length [bytes], -1 when it did not come.
  [[nodiscard]] virtual int getFeature(std::span<std::uint8_t> report) noexcept = 0;
  /// The system's message for the last failure, for a person.
  [[nodiscard]] virtual std::string error() const = 0;
  /// Lets time pass.
  virtual void wait(int duration_ms) noexcept = 0;
};

/// Which devices there are, and how one is told from another.
class DeviceListing
{
public:
  virtual ~DeviceListing() = default;

  /// Every device that is there now, each once.
  [[nodiscard]] virtual std::vector<HidEntry> devices() = 0;

  using Descriptor = Outcome<std::vector<std::uint8_t>>;
  /// Needs no permission on Linux.
  [[nodiscard]] virtual Descriptor descriptor(const HidEntry& entry) = 0;
};

/// Where HID devices come from: the system, or a test.
class HidBus : public DeviceListing
{
public:
  using Opened = Outcome<std::unique_ptr<HidConnection>>; ///< or why it cannot be opened, and the remedy
  [[nodiscard]] virtual Opened open(const HidEntry& entry) = 0;
};

} // namespace palpate
