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
      return "The device has no directed force: contact and sliding are rendered as vibration.";
    case DeviceClass::Wheel1D:
      return "The device renders force along x only: force along y and z is not felt.";
    case DeviceClass::Joystick2D:
      return "The device renders force along x and y only: force along z is not felt.";
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
      return "no device check has measured them yet";
    case HeldProof::Felt:
      return "";
    case HeldProof::WrongWay:
      return "the check measured a wall that pulls the hand through";
    case HeldProof::NoForce:
      return "the check measured a wall without force";
    case HeldProof::WrongSize:
      return "the check measured a wall more than 25 % softer or stiffer than requested";
    case HeldProof::Drives:
      return "the check measured a viscosity that drives the hand";
    case HeldProof::NoBrake:
      return "the check measured no viscosity";
    case HeldProof::Unclear:
      return "the check was inconclusive: the grip of the hand changed";
    case HeldProof::Misplaced:
      return "the check measured a wall at the wrong position";
    case HeldProof::NoLimit:
      return "the check measured a wall with too much force";
  }
  return "";
}

std::string shortcomings(const DeviceInfo& device)
{
  std::string text;
  if (!device.rendersForce)
  {
    add(text, true, "The device renders no force: contact is visible, not felt.");
  }
  else
  {
    const char* const directions = missingDirections(device.deviceClass);
    add(text, *directions != '\0', directions);
  }
  const DeviceAbilities& abilities = device.abilities;
  add(text, abilities.sensedAxes == 1, "The device moves along x only.");
  add(text, abilities.sensedAxes == 2, "The device moves along x and y only.");
  const bool real = device.rendersForce && !device.simulated;
  const bool pushes = device.deviceClass != DeviceClass::Vibration0D;
  const bool doubted = device.offersWalls && !device.closesWalls();
  add(text, real && pushes && !abilities.holdsWalls && !doubted,
    "The device holds no walls itself: the program renders them, softer.");
  add(text, real && pushes && abilities.holdsWalls && !abilities.viscous,
    "The device holds walls without viscosity, so that corridors vibrate: the program renders them, softer.");
  add(text, real && pushes && !abilities.holdsWalls && !abilities.viscous && !doubted, "The device has no viscosity.");
  if (real && pushes && doubted)
  {
    text += (text.empty() ? "" : " ") + std::string("The device offers walls of its own, but ") +
            whyNotHeld(device.heldProof) + ": the program renders them, softer.";
  }
  add(text, real && pushes && !abilities.signals, "The device cannot vibrate.");
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
