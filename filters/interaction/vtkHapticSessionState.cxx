// SPDX-License-Identifier: GPL-3.0-or-later
// The status texts of a session.
#include "devices/common/LinkNotes.h"
#include "vtkHapticSessionInternals.h"

int vtkHapticSession::GetEngageState() const
{
  return static_cast<int>(this->Impl->State.engage);
}

double* vtkHapticSession::GetHandPosition()
{
  return this->Impl->Hand;
}

const char* vtkHapticSession::Internals::SayFaultText()
{
  if (this->Report.ended)
  {
    return "The hand's path has ended: start touching again.";
  }
  const palpate::Fault fault = this->Core.running() ? this->State.fault : palpate::Fault::None;
  this->FaultText = fault == palpate::Fault::None ? "" : palpate::describeFault(fault, this->Link());
  return this->FaultText.c_str();
}
