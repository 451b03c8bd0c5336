// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that constraints join, one of them in the hand.
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

bool vtkHapticSession::AddMechanism(const char* name, vtkDataObject* data, const char* reason)
{
  return this->Impl->AddFelt(this->Impl->Mechanism, name, data, reason);
}

std::string vtkHapticSession::Internals::FollowMechanismConstraints()
{
  const std::string& laws = this->Settings.text("MechanismConstraints");
  std::string problem = this->Mechanism.RefusalOf(laws, this->Core); // the held mechanism stays as it is
  if (problem.empty())
  {
    this->Mechanism.Constraints = laws;
    this->Feel(this->Mechanism, this->Mechanism.TakeAgain());
  }
  return problem;
}
