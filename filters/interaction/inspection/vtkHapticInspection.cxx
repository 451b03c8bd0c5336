// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticInspection.h"

#include <algorithm>
#include <limits>

#include "vtkHapticContactState.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

vtkSmartPointer<vtkHapticInspection> vtkHapticInspection::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticInspection>::Take(new vtkHapticInspection(session));
}

int vtkHapticInspection::GetMarkState(int mark) const
{
  return mark >= 0 && mark < this->Session->GetNumberOfMarks() ? this->Behind().Contact.MarkStates[mark] : MarkUnseen;
}

bool vtkHapticInspection::WriteMarks(const char* file)
{
  const std::string problem = file ? this->Behind().Contact.Marks.Write(file) : "marks need a file name";
  this->Behind().Refuse(problem);
  this->Behind().Follow("marks' file", problem);
  this->Behind().Contact.SavedMarks =
    problem.empty() ? this->Behind().Contact.Marks.ToText() : this->Behind().Contact.SavedMarks;
  return problem.empty();
}

void vtkHapticInspection::GetMarks(vtkPolyData* points) const
{
  this->Behind().Contact.Marks.FillPoints(points);
}

void vtkHapticInspection::GetMarksTable(vtkTable* table) const
{
  this->Behind().Contact.Marks.FillTable(table);
}

void vtkHapticInspection::GetContactInData(double position[3]) const
{
  const auto& found = this->Behind().Contact.Found;
  const auto source = found ? this->Behind().Surfaces.SourceNamed(found->Source) : std::nullopt;
  palpate::Vec3 p = palpate::Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  if (source)
  {
    p = source->Placement.inverse() * palpate::Vec3(found->Number("X"), found->Number("Y"), found->Number("Z"));
  }
  std::copy(p.begin(), p.end(), position);
}

double vtkHapticInspection::GetValue(const char* name) const
{
  return this->Behind().Contact.Found && name ? this->Behind().Contact.Found->Number(name)
                                              : std::numeric_limits<double>::quiet_NaN();
}
