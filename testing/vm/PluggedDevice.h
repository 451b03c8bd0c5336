// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "testing/devices/hid/VirtualHid.h"
#include "testing/vm/RunningDevice.h"

namespace palpate::test
{

/// Identity of a device, told to the kernel before it asks for anything.
struct PlugIdentity
{
  std::string name, serial;
  std::uint16_t vendor = 0x1209, product = 0x0001, release = 0x0100; ///< the numbers that pid.codes keeps for tests
  std::vector<std::uint8_t> descriptor;     ///< of HID's reports, or the configuration of a device of another kind
  std::vector<std::uint8_t> stopOrder = {}; ///< the report that ends all effects
};

/// A virtual device of the HID class.
class PluggedDevice : public RunningDevice
{
public:
  /// The firmware must outlive it.
  PluggedDevice(VirtualHid& firmware, PlugIdentity identity);

  [[nodiscard]] const PlugIdentity& identity() const noexcept { return this->identity_; }
  [[nodiscard]] const std::string& serial() const noexcept { return this->identity_.serial; }

protected:
  virtual void send(std::span<const std::uint8_t> input) = 0;
  /// Ends every millisecond.
  virtual void frame() {}

  [[nodiscard]] bool take(HidReportKind kind, std::span<const std::uint8_t> report);
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t id);

private:
  void passMillisecond() override;

  VirtualHid& firmware_;
  PlugIdentity identity_;
};

} // namespace palpate::test
