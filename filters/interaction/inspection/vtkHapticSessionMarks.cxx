// SPDX-License-Identifier: GPL-3.0-or-later
// The marks that are set at contacts, and whether they still lie on what they were set on.
#include <algorithm>

#include "vtkCommand.h"
#include "vtkHapticContactState.h"
#include "vtkHapticInspection.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

int vtkHapticSession::Internals::StateOf(const vtkHapticMarkRecord& mark) const
{
  const auto origin = this->Surfaces.SourceNamed(mark.Source);
  if (!origin)
  {
    return vtkHapticInspection::MarkUnseen;
  }
  const Vec3 p_W(mark.Number("X"), mark.Number("Y"), mark.Number("Z"));
  const auto cell = static_cast<vtkIdType>(mark.Number("Cell"));
  return vtkHapticSourceProbe::Holds(origin->Data, cell, origin->W_from_D.inverse() * p_W)
           ? vtkHapticInspection::MarkHolds
           : vtkHapticInspection::MarkStale;
}

void vtkHapticSession::Internals::JudgeMarks()
{
  this->Contact.MarkStates.clear();
  this->Contact.MarksNote.clear();
  for (const vtkHapticMarkRecord& mark : this->Contact.Marks.Records)
  {
    this->Contact.MarkStates.push_back(this->StateOf(mark));
    if (this->Contact.MarkStates.back() == vtkHapticInspection::MarkStale)
    {
      this->Contact.MarksNote += "mark " + std::to_string(this->Contact.MarkStates.size()) +
                                 " is stale: " + mark.Source + " has changed or moved since; set the mark again\n";
    }
  }
}

void vtkHapticSession::Internals::KeepMarks(vtkHapticMarkRecords marks)
{
  this->Contact.Marks = std::move(marks);
  this->Settings.put("MarksText", this->Contact.Marks.ToText());
  this->JudgeMarks();
  this->Session.Modified();
}

bool vtkHapticSession::AddMark()
{
  if (!this->InspectContact())
  {
    this->Impl->Refuse("a mark needs a contact; touch a surface first");
    this->Impl->ProblemOf = "mark";
    return false;
  }
  this->Impl->Follow("mark", "");
  vtkHapticMarkRecords marks = this->Impl->Contact.Marks;
  marks.Records.push_back(*this->Impl->Contact.Found);
  this->Impl->KeepMarks(std::move(marks));
  this->Mark();
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  return true;
}

void vtkHapticSession::ClearMarks()
{
  this->Impl->KeepMarks({});
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

std::string vtkHapticSession::Internals::FollowMarksText()
{
  vtkHapticMarkRecords marks;
  std::string problem = marks.FromText(this->Settings.text("MarksText"));
  if (problem.empty())
  {
    this->KeepMarks(std::move(marks));
  }
  return problem;
}
