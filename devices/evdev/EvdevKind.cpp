// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevKind.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr std::size_t mostButtons = 32;
constexpr std::uint16_t logitech = 0x046D, thrustmaster = 0x044F;

struct Number
{
  std::uint16_t vendor = 0, product = 0;
};

/// Wheels that the drivers hid-logitech, hid-logitech-hidpp and hid-tmff push.
constexpr std::array wheels{ Number{ logitech, 0xC24F },                              // G29
  Number{ logitech, 0xC262 },                                                         // G920
  Number{ logitech, 0xC266 }, Number{ logitech, 0xC267 }, Number{ logitech, 0xC26D }, // G923
  Number{ logitech, 0xC26E }, Number{ logitech, 0xC294 },                             // Driving Force
  Number{ logitech, 0xC295 }, Number{ logitech, 0xCA03 },                             // Momo
  Number{ logitech, 0xC298 }, Number{ logitech, 0xC299 },                             // Driving Force Pro, G25
  Number{ logitech, 0xC29A }, Number{ logitech, 0xC29B }, Number{ logitech, 0xC29C }, // GT, G27, Wii
  Number{ thrustmaster, 0xB605 }, Number{ thrustmaster, 0xB651 }, Number{ thrustmaster, 0xB653 },
  Number{ thrustmaster, 0xB654 }, Number{ thrustmaster, 0xB65A } };

bool isWheel(const EvdevTraits& traits, const HidEntry& entry) noexcept
{
  return traits.axes[ABS_WHEEL] || traits.keys[BTN_GEAR_DOWN] || traits.keys[BTN_GEAR_UP] ||
         std::any_of(wheels.begin(), wheels.end(),
           [&](const Number& wheel) { return wheel.vendor == entry.vendor && wheel.product == entry.product; });
}

constexpr bool isButton(std::size_t code) noexcept
{
  return (code >= BTN_MISC && code < KEY_OK) || (code >= BTN_TRIGGER_HAPPY1 && code <= BTN_TRIGGER_HAPPY40);
}

/// Those of joysticks, pads and wheels; mice and tablets have others.
constexpr bool isOfHands(std::size_t code) noexcept
{
  return (code >= BTN_JOYSTICK && code < BTN_DIGI) || code == BTN_GEAR_DOWN || code == BTN_GEAR_UP;
}

std::vector<std::uint16_t> buttonsOf(const EvdevTraits& traits)
{
  std::vector<std::uint16_t> buttons;
  for (std::size_t code = 0; code < traits.keys.size() && buttons.size() < mostButtons; ++code)
  {
    if (traits.keys[code] && isButton(code))
    {
      buttons.push_back(static_cast<std::uint16_t>(code));
    }
  }
  return buttons;
}

std::string problemOf(const EvdevTraits& traits, const PidKind& kind)
{
  return traits.forces.none()          ? "no force: the kernel driver of the device has no force feedback"
         : !traits.forces[FF_CONSTANT] ? "vibration only: the kernel driver of the device has no constant force"
         : kind.sensedAxes == 0        ? "the device has no axis that reports the position of the hand"
                                       : "";
}

} // namespace

EvdevKind evdevKind(const EvdevTraits& traits, const HidEntry& entry)
{
  const bool wheel = isWheel(traits, entry);
  const auto x = static_cast<std::uint16_t>(traits.axes[ABS_WHEEL] ? ABS_WHEEL : ABS_X);
  EvdevKind kind{ {}, { x, ABS_Y }, buttonsOf(traits) };
  PidKind& pushes = kind.pushes;
  pushes.sensedAxes = !traits.axes[x] ? 0 : wheel || !traits.axes[ABS_Y] ? 1 : 2;
  pushes.pushedAxes = traits.forces[FF_CONSTANT] ? pushes.sensedAxes : 0;
  pushes.deviceClass = pushes.pushedAxes == 1 ? DeviceClass::Wheel1D : DeviceClass::Joystick2D;
  if (traits.forces[FF_PERIODIC] && traits.forces[FF_SINE])
  {
    pushes.shaking = pid::sine;
  }
  if (traits.forces[FF_SPRING])
  {
    pushes.conditions = { true, true, true };
  }
  pushes.damper = traits.forces[FF_DAMPER];
  pushes.problem = problemOf(traits, pushes);
  return kind;
}

bool isForHands(const EvdevTraits& traits) noexcept
{
  bool hasButtons = false;
  for (std::size_t code = 0; code < traits.keys.size(); ++code)
  {
    hasButtons = hasButtons || (traits.keys[code] && isOfHands(code));
  }
  return hasButtons && (traits.axes[ABS_X] || traits.axes[ABS_WHEEL]);
}

} // namespace palpate
