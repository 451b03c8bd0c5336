// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "devices/evdev/EvdevBus.h"
#include "devices/hid/pid/PidKind.h"

namespace palpate
{

/// The kind of an event device with force feedback, and the axes of its hand.
struct EvdevKind
{
  PidKind pushes;                     ///< said as of a device of the PID class
  std::array<std::uint16_t, 2> axes;  ///< the codes of x and y; of a wheel the first alone counts
  std::vector<std::uint16_t> buttons; ///< the code of button 1, 2, ...: at most 32
};

/// A wheel has one motor however many axes its pedals have. The kernel says of none which axes it pushes: a wheel is
/// devices with a wheel's axis or gear buttons, or one of the known numbers of maker and product.
[[nodiscard]] EvdevKind evdevKind(const EvdevTraits& traits, const HidEntry& entry);

/// It is made for a hand to lead: a joystick, wheel or pad, with force or without.
[[nodiscard]] bool isForHands(const EvdevTraits& traits) noexcept;

} // namespace palpate
