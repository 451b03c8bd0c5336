// SPDX-License-Identifier: GPL-3.0-or-later
// A soft body.
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticSessionInternals.h"
#include "vtkUnstructuredGrid.h"

bool vtkHapticSession::AddSoftBody(const char* name, vtkDataObject* data)
{
  return this->Impl->AddFelt(this->Impl->Soft, name, data);
}

bool vtkHapticSession::BendSoftBody(vtkDataObject* body)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(body);
  return grid && this->Impl->Soft.Bend(*grid);
}

std::string vtkHapticSession::Internals::FollowSoftRate()
{
  this->Soft.Rate_Hz = this->Mechanism.Rate_Hz = this->Settings.number("SoftRate");
  this->Soft.Choose(this->Core);
  this->Mechanism.Choose(this->Core);
  return {};
}
