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
      return "the device sent values that are not finite: check its cable, then engage again";
    case Fault::LateServo:
      return "the servo loop ran too late: close other programs or grant real-time priority, then engage again";
    case Fault::DeviceLost:
      return "the device stopped answering: plug the device in again, then engage again";
    case Fault::EnergyLatch:
      return "the device received more energy than allowed: lower the stiffness, then engage again";
    case Fault::VelocityCut:
      return "the handle moved too fast: hold the handle, then engage again";
    case Fault::SceneRefused:
      return "no touchable data are visible: show a surface";
    case Fault::PlacementFailed:
      return "the proxy sphere does not fit at its position: move the hand out of the surface or use a smaller radius";
    case Fault::NoHand:
      return "there is no hand position yet: move the device or the pointer, or set HandPosition";
    case Fault::ToolWaits:
      return "the tool overlaps the scene at the hand: move the hand to a position at which the tool is free";
    case Fault::BodyLate:
      return "the soft body is no longer solved in time: use fewer tetrahedra, then engage again";
  }
  return "unknown fault";
}

} // namespace palpate
