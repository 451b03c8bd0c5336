// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/DeviceNotes.h"

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

const char* whyNotHeld(HeldProof proof) noexcept
{
  switch (proof)
  {
    case HeldProof::Unfelt:
      return "no check of the device has felt them yet";
    case HeldProof::Felt:
      return "";
    case HeldProof::WrongWay:
      return "its check felt one that pulls the hand through";
    case HeldProof::NoForce:
      return "its check felt one that does nothing";
    case HeldProof::WrongSize:
      return "its check felt one that is more than a quarter softer or stiffer than asked for";
    case HeldProof::Drives:
      return "its check felt its viscosity drive the hand on";
    case HeldProof::NoBrake:
      return "its check felt no viscosity";
    case HeldProof::Unclear:
      return "its check could not tell: the hand did not stay the same";
    case HeldProof::Misplaced:
      return "its check felt one that does not stand where it was asked to";
    case HeldProof::NoLimit:
      return "its check felt one that pushes harder than it may";
  }
  return "";
}

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
  const bool doubted = device.offersWalls && !device.closesWalls();
  add(text, real && pushes && !abilities.holdsWalls && !doubted,
    "It holds no walls by itself: the program closes them, softer.");
  add(text, real && pushes && abilities.holdsWalls && !abilities.viscous,
    "It holds walls without viscosity, in which corridors shake: the program closes them, softer.");
  add(text, real && pushes && !abilities.holdsWalls && !abilities.viscous && !doubted, "It has no viscosity.");
  if (real && pushes && doubted)
  {
    text += (text.empty() ? "" : " ") + std::string("It offers to hold walls by itself, but ") +
            whyNotHeld(device.heldProof) + ": the program closes them, softer.";
  }
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
