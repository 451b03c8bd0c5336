// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/DeviceNotes.h"

namespace palpate
{
namespace
{

void add(std::string& text, bool applies, const char* sentence)
{
  if (applies)
  {
    text += (text.empty() ? "" : " ") + std::string(sentence);
  }
}

/// Of the directions in which the hand is pushed.
const char* missingDirections(DeviceClass deviceClass) noexcept
{
  switch (deviceClass)
  {
    case DeviceClass::Vibration0D:
      return "It pushes in no direction: contact and sliding are felt as vibration.";
    case DeviceClass::Wheel1D:
      return "It pushes along x only: what pushes along y and z is not felt.";
    case DeviceClass::Joystick2D:
      return "It pushes along x and y only: what pushes along z is not felt.";
    case DeviceClass::Point3D:
    case DeviceClass::Rigid6D:
      break;
  }
  return "";
}

} // namespace

std::string shortcomings(const DeviceInfo& device)
{
  std::string text;
  if (!device.rendersForce)
  {
    add(text, true, "It gives no force: contact is seen, not felt.");
  }
  else
  {
    const char* const directions = missingDirections(device.deviceClass);
    add(text, *directions != '\0', directions);
  }
  const DeviceAbilities& abilities = device.abilities;
  add(text, abilities.sensedAxes == 1, "It moves along x only.");
  add(text, abilities.sensedAxes == 2, "It moves along x and y only.");
  const bool real = device.rendersForce && !device.simulated;
  const bool pushes = device.deviceClass != DeviceClass::Vibration0D;
  add(text, real && pushes && !abilities.holdsWalls, "It holds no walls by itself: the program closes them, softer.");
  add(text, real && pushes && abilities.holdsWalls && !abilities.viscous,
    "It holds walls without viscosity, in which corridors shake: the program closes them, softer.");
  add(text, real && pushes && !abilities.holdsWalls && !abilities.viscous, "It has no viscosity.");
  add(text, real && pushes && !abilities.signals, "It cannot shake.");
  return text;
}

std::string kindOf(const DeviceInfo& device)
{
  if (!device.rendersForce)
  {
    return device.abilities.sensedAxes == 6 ? "6 axes of motion, no force" : "motion, no force";
  }
  switch (device.deviceClass)
  {
    case DeviceClass::Vibration0D:
      return "vibration only";
    case DeviceClass::Wheel1D:
      return "1 axis of force";
    case DeviceClass::Joystick2D:
      return "2 axes of force";
    case DeviceClass::Point3D:
      return "3 axes of force";
    case DeviceClass::Rigid6D:
      return "6 axes of force and torque";
  }
  return "unknown";
}

} // namespace palpate
