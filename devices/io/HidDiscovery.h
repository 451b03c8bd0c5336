// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "devices/hid/HidConnection.h"
#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// A connected control for a hand, usable or not.
struct FoundHid
{
  enum class Kind : std::uint8_t
  {
    ForceFeedback, ///< of the PID class
    SpaceMouse,    ///< six axes, no force
    Unusable,      ///< a joystick, wheel or pad without force, or a device that cannot be identified
  };
  Kind kind = Kind::ForceFeedback;
  std::string name; ///< for the factory: the same as long as the same devices are plugged in
  HidEntry entry;
  ReportDescriptor descriptor;
  std::string problem;  ///< empty, or the reason why it cannot be used, and the remedy
  bool hasTwin = false; ///< another device of the same kind and serial number is plugged in
};

/// True if the descriptor promises force feedback of the PID class, usable or not.
[[nodiscard]] bool speaksPid(const ReportDescriptor& descriptor) noexcept;

/// The force-feedback devices and SpaceMice on a bus, and other controls for a hand, such as a joystick without force;
/// mice and keyboards are left out. A usable device is opened for a moment to check the permission.
[[nodiscard]] std::vector<FoundHid> findHidDevices(HidBus& bus);

} // namespace palpate
