// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that laws join, one of them in the hand.
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

void vtkHapticSession::Internals::HoldMechanism(vtkHapticSession& session, const std::string& problem)
{
  session.Refuse(problem);
  this->Follow("mechanism", problem);
  this->Core.setMechanism(this->Mechanism.Choice(this->Soft.Rate_Hz));
  this->Mechanism.Follow(this->Core, this->State);
}

bool vtkHapticSession::AddMechanism(const char* name, vtkDataObject* data, const char* reason)
{
  const std::string problem = this->Impl->Mechanism.Take(name ? name : "", data, reason ? reason : "");
  this->Impl->HoldMechanism(*this, problem);
  return problem.empty();
}

const char* vtkHapticSession::GetAddedMechanism() const
{
  return this->Impl->Mechanism.Taken().c_str();
}

void vtkHapticSession::SetMechanismMoved(bool moved)
{
  this->Impl->Mechanism.DrawnElsewhere = moved;
}

bool vtkHapticSession::MoveMechanism(vtkPolyData* shapes)
{
  return shapes && this->Impl->Mechanism.Move(*shapes);
}

void vtkHapticSession::GetMechanismTable(vtkTable* table) const
{
  this->Impl->Mechanism.FillTable(*table);
}

std::string vtkHapticSession::GetLawsWith(const char* law)
{
  std::string problem;
  const std::string laws = this->Impl->Mechanism.With(law ? law : "", problem);
  problem = laws.empty() ? problem : this->Impl->Mechanism.Refusal(laws, this->Impl->Core);
  this->Refuse(problem);
  return problem.empty() ? laws : "";
}

std::string vtkHapticSession::GetLawsWithout(const char* name)
{
  std::string problem;
  std::string laws = this->Impl->Mechanism.Without(name ? name : "", problem);
  this->Refuse(problem);
  return laws;
}

bool vtkHapticSession::BreakLaw(const char* name)
{
  const int law = this->Impl->Mechanism.IndexOf(name ? name : "");
  const bool felt = this->Impl->Mechanism.IsFelt(); // else the servo may number other laws
  this->Refuse(law < 0 ? std::string("there is no law \"") + (name ? name : "") + "\" to be broken"
               : felt  ? ""
                       : "these laws are not felt now: break one of them while the mechanism is touched with them");
  if (law >= 0 && felt)
  {
    this->Impl->Core.breakLaw(static_cast<std::uint32_t>(law));
  }
  return law >= 0 && felt;
}

void vtkHapticSession::SetMechanismLaws(const char* laws)
{
  const std::string asked = laws ? laws : "";
  if (asked != this->Impl->Mechanism.Laws)
  {
    if (const std::string problem = this->Impl->Mechanism.Refusal(asked, this->Impl->Core); !problem.empty())
    {
      this->Refuse(problem); // what is held stays as it is
      return;
    }
    this->Impl->Mechanism.Laws = asked;
    this->Impl->HoldMechanism(*this, this->Impl->Mechanism.TakeAgain());
    this->Modified();
  }
}

const char* vtkHapticSession::GetMechanismLaws() const
{
  return this->Impl->Mechanism.Laws.c_str();
}

void vtkHapticSession::SetMechanismSource(const char* name)
{
  const std::string source = name ? name : "";
  if (source != this->Impl->Mechanism.Source)
  {
    this->Impl->Mechanism.Source = source;
    this->AddMechanism(nullptr, nullptr);
    this->Impl->MaterialTime.Modified(); // who follows a view adds its surfaces again, all but this one
    this->Modified();
  }
}

const char* vtkHapticSession::GetMechanismSource() const
{
  return this->Impl->Mechanism.Source.c_str();
}

const char* vtkHapticSession::GetMechanismText() const
{
  return this->Impl->Mechanism.Text.c_str();
}

double vtkHapticSession::GetMechanismDepth() const
{
  return this->Impl->Mechanism.Depth;
}
