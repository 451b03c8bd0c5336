// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "testing/devices/arm/WoodenHapticsModel.h"
#include "testing/vm/UhidDevice.h"

namespace palpate::test
{

/// A base, so that it is there before the transport and after it.
class WoodenHapticsFirmware
{
protected:
  WoodenHapticsModel arm_;
};

/// A WoodenHaptics behind /dev/uhid, in its pose when its power comes: reports of 14 bytes each way, as its mbed has.
class UhidWoodenHaptics final
  : private WoodenHapticsFirmware
  , public UhidTransport
{
public:
  explicit UhidWoodenHaptics(std::string serial)
    : UhidTransport(this->arm_, { "WoodenHaptics", std::move(serial), WoodenHapticsModel::vendor,
                                  WoodenHapticsModel::product, PlugIdentity{}.release, descriptor() })
  {
  }
  ~UhidWoodenHaptics() override { this->unplug(); }

  template<class Body>
  auto alone(Body body)
  {
    return this->still([&] { return body(this->arm_); });
  }

private:
  static std::vector<std::uint8_t> descriptor()
  {
    return { 0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01,      // its maker's own
      0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x0E, // 14 bytes
      0x09, 0x02, 0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0 };
  }
  void powerOn() override { this->arm_ = WoodenHapticsModel(); }
};

} // namespace palpate::test
