// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/ArmKit.h"
#include "testing/vm/Ticking.h"

namespace palpate::test
{

/// The kit of this computer whose devices' names begin so. A WoodenHaptics' file is written first.
[[nodiscard]] ArmKit systemKit(const std::string& road);

/// An arm of this computer with its own threads and guard, proven, and a servo that ticks it.
struct ArmServo : Ticking
{
  /// Waits for the arm with that serial number; throws std::runtime_error when it does not come.
  ArmServo(const std::string& road, const std::string& serial, const Clock* clock = nullptr);

  /// Presses the button of each step that has one, until a hand is read. False: none is.
  [[nodiscard]] bool prepare();
  /// Lets go of all force, then asks for this one. After a loss that is needed.
  void ask(const Vec3& force_N);

  ArmKit kit;
  HidEntry entry;
  ArmDevice device;
};

/// Pushes an arm until it is killed, whatever comes between. Returns with the reason where that cannot be.
[[nodiscard]] std::string pushArm(const std::string& road, const std::string& serial);

} // namespace palpate::test
