// SPDX-License-Identifier: GPL-3.0-or-later
// How each source is touched by itself, and clouds of points.
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

namespace
{
std::string NameOf(const char* name)
{
  return name ? name : "";
}
} // namespace

void vtkHapticSession::SetSourceTouched(const char* name, bool touched)
{
  vtkHapticSourceStyle style = this->Impl->Surfaces.Styles().Of(NameOf(name));
  if (style.Touched != touched)
  {
    style.Touched = touched;
    this->Impl->Surfaces.Styles().Set(NameOf(name), style);
    this->FollowSources();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

bool vtkHapticSession::GetSourceTouched(const char* name) const
{
  return this->Impl->Surfaces.Styles().Of(NameOf(name)).Touched;
}

bool vtkHapticSession::SetSourceMaterial(
  const char* name, double stiffness_N_per_m, double frictionStatic, double frictionKinetic)
{
  vtkHapticSourceStyle style = this->Impl->Surfaces.Styles().Of(NameOf(name));
  const palpate::Material material{ stiffness_N_per_m, frictionStatic, frictionKinetic };
  std::string problem = material.validate();
  problem = problem.empty() ? problem : NameOf(name) + ": " + problem;
  this->Refuse(problem);
  this->Impl->Follow("material of " + NameOf(name), problem);
  if (problem.empty() && style.Material != material)
  {
    style.Material = material;
    this->Impl->Surfaces.Styles().Set(NameOf(name), style);
    this->FollowSources();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
  return problem.empty();
}

void vtkHapticSession::GetSourceMaterial(const char* name, double material[3]) const
{
  const palpate::Material found = this->Impl->Surfaces.Styles().Of(NameOf(name)).Material;
  material[0] = found.stiffness_N_per_m;
  material[1] = found.frictionStatic;
  material[2] = found.frictionKinetic;
}

void vtkHapticSession::FollowSources()
{
  this->Impl->SourcesText = this->Impl->Surfaces.Styles().ToText();
  this->Impl->MaterialTime.Modified();
  this->Modified();
}

void vtkHapticSession::SetSourcesText(const char* text)
{
  if (this->Impl->SourcesText == NameOf(text))
  {
    return;
  }
  const std::string problem = this->Impl->Surfaces.Styles().FromText(NameOf(text));
  this->Refuse(problem);
  this->Impl->Follow("sources", problem);
  if (problem.empty())
  {
    this->FollowSources();
  }
}

const char* vtkHapticSession::GetSourcesText() const
{
  return this->Impl->SourcesText.c_str();
}

void vtkHapticSession::SetPointRadius(double radius_u)
{
  if (this->Allows("PointRadius", { radius_u }) && radius_u != this->Impl->PointRadius_u)
  {
    this->Impl->PointRadius_u = radius_u;
    this->Impl->Surfaces.SetPointRadius(radius_u);
    this->Impl->MaterialTime.Modified();
    this->Modified();
  }
}

double vtkHapticSession::GetPointRadius() const
{
  return this->Impl->PointRadius_u;
}
