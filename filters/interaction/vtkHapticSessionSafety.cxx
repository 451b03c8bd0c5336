// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand must hold, and what is said without ending the force.
#include <string>

#include "vtkHapticSessionInternals.h"

void vtkHapticSession::SetDeadManButtons(int mask)
{
  if (mask < 0)
  {
    this->Refuse(
      "dead-man buttons: bit i stands for button i + 1, so the mask is 0 (none) or more, not " + std::to_string(mask));
    return;
  }
  this->Change([=](palpate::HapticParameters& p) { p.safety.deadMan.buttons = static_cast<std::uint32_t>(mask); });
}

int vtkHapticSession::GetDeadManButtons() const
{
  return static_cast<int>(this->Impl->Parameters.safety.deadMan.buttons);
}

void vtkHapticSession::SetDeadManGrip(bool on)
{
  this->Change([=](palpate::HapticParameters& p) { p.safety.deadMan.grip = on; });
}

bool vtkHapticSession::GetDeadManGrip() const
{
  return this->Impl->Parameters.safety.deadMan.grip;
}

const char* vtkHapticSession::GetWarning() const
{
  return this->Impl->Warning.c_str();
}
