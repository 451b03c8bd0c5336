// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that laws join, one of them in the hand.
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

void vtkHapticSession::Internals::HoldMechanism(const std::string& problem)
{
  this->Refuse(problem);
  this->Follow("mechanism", problem);
  this->Core.setMechanism(this->Mechanism.Choice(this->Soft.Rate_Hz));
  this->Mechanism.Follow(this->Core, this->State);
}

bool vtkHapticSession::AddMechanism(const char* name, vtkDataObject* data, const char* reason)
{
  const std::string problem = this->Impl->Mechanism.Take(name ? name : "", data, reason ? reason : "");
  this->Impl->HoldMechanism(problem);
  return problem.empty();
}

std::string vtkHapticSession::Internals::FollowMechanismLaws()
{
  const std::string& laws = this->Settings.text("MechanismLaws");
  std::string problem = this->Mechanism.Refusal(laws, this->Core); // what is held stays as it is
  if (problem.empty())
  {
    this->Mechanism.Laws = laws;
    this->HoldMechanism(this->Mechanism.TakeAgain());
  }
  return problem;
}

std::string vtkHapticSession::Internals::FollowMechanismSource()
{
  this->Mechanism.Source = this->Settings.text("MechanismSource");
  this->Session.AddMechanism(nullptr, nullptr);
  this->MaterialTime.Modified(); // who follows a view adds its surfaces again, all but this one
  return {};
}
