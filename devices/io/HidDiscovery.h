// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "devices/hid/HidConnection.h"
#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// A device for a hand that is plugged in, usable or not.
struct FoundHid
{
  enum class Kind : std::uint8_t
  {
    ForceFeedback, ///< of the PID class
    SpaceMouse,    ///< six axes, no force
    Unusable,      ///< a joystick, wheel or pad without force, or one that cannot be told what it is
  };
  Kind kind = Kind::ForceFeedback;
  std::string name; ///< for the factory: the same as long as the same devices are plugged in
  HidEntry entry;
  ReportDescriptor descriptor;
  std::string problem;  ///< empty, or why it cannot be used and what to do
  bool hasTwin = false; ///< another one is plugged in that neither kind nor serial number tells apart
};

/// It promises force feedback of the PID class, usable or not.
[[nodiscard]] bool speaksPid(const ReportDescriptor& descriptor) noexcept;

/// The force-feedback devices and SpaceMice on a bus, and what else is made for a hand to lead, such as a joystick
/// without force; mice and keyboards are left out. What can be used is opened for a moment to see whether it may be.
[[nodiscard]] std::vector<FoundHid> findHidDevices(HidBus& bus);

} // namespace palpate
