// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iostream>
#include <string>

#include "testing/devices/hid/PidLayout.h"
#include "testing/vm/Servo.h"

namespace palpate::test
{

/// By when an effect is seen to have ended that nobody arms again: it expires by itself, and a look, one a millisecond,
/// may come a quarter of that late on a machine that is shared. On the firmware's clock.
[[nodiscard]] inline int expired_ms()
{
  const int expiry_ms = PidOutputOptions().duration_ms;
  return expiry_ms + expiry_ms / 4;
}

/// A plain joystick that is plugged in and a servo that pushes it with 2 N.
template<class Device>
struct Pushing
{
  explicit Pushing(const std::string& serial) : device(plainLayout(), serial), servo(plugged(device).serial()) {}

  /// Opens it and waits for the force. False: it has not come, with the reason on the console.
  bool begin()
  {
    if (const std::string problem = this->servo.device.open(); !problem.empty())
    {
      std::cerr << problem << "\n";
      return false;
    }
    return this->push();
  }
  /// Asks for the force and waits for it.
  bool push()
  {
    this->servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    return this->servo.runUntil([this] { return this->device.forceX() > 0.3; });
  }

  Device device;
  Servo servo;

private:
  static Device& plugged(Device& device)
  {
    device.plug();
    return device;
  }
};

} // namespace palpate::test
