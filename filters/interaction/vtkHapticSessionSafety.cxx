// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand must hold, and what is said without ending the force.
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::SetDeadManButtons(int mask)
{
  this->Change("DeadManButtons", { static_cast<double>(mask) },
    [=](palpate::HapticParameters& p) { p.safety.deadMan.buttons = static_cast<std::uint32_t>(mask); });
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
