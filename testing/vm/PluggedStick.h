// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "testing/devices/hid/VirtualPidDevice.h"
#include "testing/vm/PluggedDevice.h"

namespace palpate::test
{

/// Of a layout whose controls are numbers: the report that ends all effects.
[[nodiscard]] inline std::vector<std::uint8_t> stopOrder(const PidLayout& layout)
{
  const auto at = std::find(layout.controls.begin(), layout.controls.end(), 0x99);
  return { layout.controlId, static_cast<std::uint8_t>(at - layout.controls.begin() + 1) };
}

/// The firmware of a plugged stick. A base, so that it is there before the transport and after it.
class StickFirmware
{
protected:
  explicit StickFirmware(const PidLayout& is) : layout_(is), stick_(is) {}

  PidLayout layout_;
  VirtualPidDevice stick_;
};

/// A virtual joystick of the PID class on some transport.
template<class Transport>
class PluggedStick final
  : private StickFirmware
  , public Transport
{
public:
  PluggedStick(const PidLayout& layout, std::string serial)
    : StickFirmware(layout),
      Transport(this->stick_, { layout.name, std::move(serial), PlugIdentity{}.vendor, PlugIdentity{}.product,
                                PlugIdentity{}.release, descriptorOf(layout), stopOrder(layout) })
  {
  }
  ~PluggedStick() override { this->unplug(); }

  /// Reads or changes the firmware while it stands still.
  template<class Body>
  auto alone(Body body)
  {
    return this->still([&] { return body(this->stick_); });
  }
  /// Of all effects now along x [share].
  [[nodiscard]] double forceX()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.force()[0]; });
  }
  [[nodiscard]] int effectsPlaying()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.effectsPlaying(); });
  }
  [[nodiscard]] int badReports()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.badReports; });
  }
  /// Orders to stop all effects that it has taken.
  [[nodiscard]] int stopAlls()
  {
    return this->alone([](VirtualPidDevice& stick) { return stick.stopAlls; });
  }
  [[nodiscard]] const PidLayout& layout() const noexcept { return this->layout_; }

private:
  void powerOn() override { this->stick_ = VirtualPidDevice(this->layout_); }
};

} // namespace palpate::test
