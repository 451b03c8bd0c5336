// SPDX-License-Identifier: GPL-3.0-or-later
// The marks that are set at contacts, and whether they still lie on what they were set on.
#include <algorithm>

#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

int vtkHapticSession::Internals::StateOf(const vtkHapticMarkRecord& mark) const
{
  const auto origin = this->Surfaces.SourceNamed(mark.Source);
  if (!origin)
  {
    return MarkUnseen;
  }
  const Vec3 p_W(mark.Number("X"), mark.Number("Y"), mark.Number("Z"));
  const auto cell = static_cast<vtkIdType>(mark.Number("Cell"));
  return vtkHapticSourceProbe::Holds(origin->Data, cell, origin->W_from_D.inverse() * p_W) ? MarkHolds : MarkStale;
}

void vtkHapticSession::Internals::JudgeMarks()
{
  this->MarkStates.clear();
  this->MarksNote.clear();
  for (const vtkHapticMarkRecord& mark : this->Marks.Records)
  {
    this->MarkStates.push_back(this->StateOf(mark));
    if (this->MarkStates.back() == MarkStale)
    {
      this->MarksNote += "mark " + std::to_string(this->MarkStates.size()) + " is stale: " + mark.Source +
                         " has changed or moved since; mark there anew\n";
    }
  }
}

void vtkHapticSession::KeepMarks(vtkHapticMarkRecords marks)
{
  this->Impl->Marks = std::move(marks);
  this->Impl->MarksText = this->Impl->Marks.ToText();
  this->Impl->JudgeMarks();
  this->Modified();
}

bool vtkHapticSession::AddMark()
{
  if (!this->InspectContact())
  {
    this->Refuse("a mark is set at a contact, and nothing is touched; touch a surface first");
    this->Impl->ProblemOf = "mark";
    return false;
  }
  this->Impl->Follow("mark", "");
  vtkHapticMarkRecords marks = this->Impl->Marks;
  marks.Records.push_back(*this->Impl->Contact);
  this->KeepMarks(std::move(marks));
  this->Mark();
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  return true;
}

void vtkHapticSession::ClearMarks()
{
  this->KeepMarks({});
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

void vtkHapticSession::SetMarksText(const char* text)
{
  const std::string wanted = text ? text : "";
  if (wanted == this->Impl->MarksText)
  {
    return;
  }
  vtkHapticMarkRecords marks;
  const std::string problem = marks.FromText(wanted);
  this->Refuse(problem);
  this->Impl->Follow("marks' text", problem);
  if (problem.empty())
  {
    this->KeepMarks(std::move(marks));
  }
}

const char* vtkHapticSession::GetMarksText() const
{
  return this->Impl->MarksText.c_str();
}

const char* vtkHapticSession::GetMarksNote() const
{
  return this->Impl->MarksNote.c_str();
}

int vtkHapticSession::GetNumberOfMarks() const
{
  return static_cast<int>(this->Impl->Marks.Records.size());
}

int vtkHapticSession::GetMarkState(int mark) const
{
  return mark >= 0 && mark < this->GetNumberOfMarks() ? this->Impl->MarkStates[mark] : MarkUnseen;
}

bool vtkHapticSession::WriteMarks(const char* file)
{
  const std::string problem = file ? this->Impl->Marks.Write(file) : "a file is needed to write marks into";
  this->Refuse(problem);
  this->Impl->Follow("marks' file", problem);
  return problem.empty();
}

void vtkHapticSession::GetMarks(vtkPolyData* points) const
{
  this->Impl->Marks.FillPoints(points);
}

void vtkHapticSession::GetMarksTable(vtkTable* table) const
{
  this->Impl->Marks.FillTable(table);
}
