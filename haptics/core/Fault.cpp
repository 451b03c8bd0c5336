// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/core/Fault.h"

namespace palpate
{

const char* describe(Fault fault) noexcept
{
  switch (fault)
  {
    case Fault::None:
      return "no fault";
    case Fault::NonFiniteSample:
      return "the device sent numbers that are not finite: check its cable, then engage again";
    case Fault::LateServo:
      return "the servo loop ran too late: close other programs or grant real-time priority, then engage again";
    case Fault::DeviceLost:
      return "the device stopped answering: plug it in again, then engage again";
    case Fault::EnergyLatch:
      return "the device was given more energy than allowed: lower the stiffness, then engage again";
    case Fault::VelocityCut:
      return "the handle moved too fast: hold it, then engage again";
    case Fault::SceneRefused:
      return "nothing that can be touched is shown: show a surface";
    case Fault::Seated:
      return "the ball does not fit where it is: move the hand out of the surface or use a smaller radius";
    case Fault::NoHand:
      return "there is no hand yet: move the device or the pointer, or tell the session where the hand is";
    case Fault::ToolWaits:
      return "the tool meets the scene where the hand is: move the hand to where the tool is free";
    case Fault::BodyLate:
      return "the soft body is not computed any more: give it fewer tetrahedra, then engage again";
  }
  return "unknown fault";
}

} // namespace palpate
