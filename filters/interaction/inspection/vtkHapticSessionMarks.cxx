// SPDX-License-Identifier: GPL-3.0-or-later
// The marks that are set at contacts, and whether they still lie on their cells.
#include <algorithm>

#include "vtkCommand.h"
#include "vtkHapticContactState.h"
#include "vtkHapticInspection.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

int vtkHapticSession::Internals::StateOf(const vtkHapticMarkRecord& mark) const
{
  if (mark.Source.empty())
  {
    return vtkHapticInspection::MarkHolds; // a place in space stays
  }
  const auto origin = this->Surfaces.SourceNamed(mark.Source);
  if (!origin)
  {
    return vtkHapticInspection::MarkUnseen;
  }
  const Vec3 p_W(mark.Number("X"), mark.Number("Y"), mark.Number("Z"));
  const auto cell = static_cast<vtkIdType>(mark.Number("Cell"));
  return vtkHapticSourceProbe::Holds(origin->Data, cell, origin->Placement.inverse() * p_W)
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

// Changes by a person -------------------------------------------------------------------------------------------------

void vtkHapticInspection::Keep(vtkHapticMarkRecords marks)
{
  this->Behind().KeepMarks(std::move(marks));
  this->Session->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

bool vtkHapticInspection::Refuses(int mark)
{
  const int count = this->Session->GetNumberOfMarks();
  const std::string problem =
    mark >= 0 && mark < count ? ""
                              : "there is no mark " + std::to_string(mark + 1) + "; there are " + std::to_string(count);
  this->Behind().Refuse(problem);
  this->Behind().Follow("mark", problem);
  return !problem.empty();
}

bool vtkHapticInspection::AddMarkAt(const char* name, double x, double y, double z)
{
  vtkHapticMarkRecords marks = this->Behind().Contact.Marks;
  marks.Records.push_back({ "", { { "X", x }, { "Y", y }, { "Z", z } }, name ? name : "" });
  const std::string problem = Vec3(x, y, z).allFinite() ? "" : "a mark needs three finite coordinates";
  this->Behind().Refuse(problem);
  this->Behind().Follow("mark", problem);
  if (problem.empty())
  {
    this->Keep(std::move(marks));
  }
  return problem.empty();
}

bool vtkHapticInspection::RemoveMark(int mark)
{
  if (this->Refuses(mark))
  {
    return false;
  }
  vtkHapticMarkRecords marks = this->Behind().Contact.Marks;
  marks.Records.erase(marks.Records.begin() + mark);
  this->Keep(std::move(marks));
  return true;
}

bool vtkHapticInspection::RenameMark(int mark, const char* name)
{
  if (this->Refuses(mark))
  {
    return false;
  }
  vtkHapticMarkRecords marks = this->Behind().Contact.Marks;
  marks.Records[static_cast<std::size_t>(mark)].Name = name ? name : "";
  this->Keep(std::move(marks));
  return true;
}

bool vtkHapticInspection::ReadMarks(const char* file)
{
  vtkHapticMarkRecords marks;
  const std::string problem = file ? marks.Read(file) : "marks need a file name";
  this->Behind().Refuse(problem);
  this->Behind().Follow("marks' file", problem);
  if (problem.empty())
  {
    this->Behind().Contact.SavedMarks = marks.ToText();
    this->Keep(std::move(marks));
  }
  return problem.empty();
}

std::string vtkHapticInspection::GetSavedMarks() const
{
  return this->Behind().Contact.SavedMarks;
}

std::string vtkHapticInspection::GetMarkName(int mark) const
{
  const auto& records = this->Behind().Contact.Marks.Records;
  return mark >= 0 && mark < this->Session->GetNumberOfMarks() ? records[static_cast<std::size_t>(mark)].Name : "";
}

void vtkHapticInspection::GetMarkPosition(int mark, double position[3]) const
{
  const auto& records = this->Behind().Contact.Marks.Records;
  const bool there = mark >= 0 && mark < this->Session->GetNumberOfMarks();
  const vtkHapticMarkRecord record = there ? records[static_cast<std::size_t>(mark)] : vtkHapticMarkRecord();
  const char* const axes[] = { "X", "Y", "Z" };
  for (int k = 0; k < 3; ++k)
  {
    position[k] = record.Number(axes[k]);
  }
}
