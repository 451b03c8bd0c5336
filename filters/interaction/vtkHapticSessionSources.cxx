// SPDX-License-Identifier: GPL-3.0-or-later
// How each source is touched by itself, and clouds of points.
#include "vtkCommand.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"

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
    this->Impl->FollowSources();
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
  this->Impl->Refuse(problem);
  this->Impl->Follow("material of " + NameOf(name), problem);
  if (problem.empty() && style.Material != material)
  {
    style.Material = material;
    this->Impl->Surfaces.Styles().Set(NameOf(name), style);
    this->Impl->FollowSources();
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

void vtkHapticSession::Internals::FollowSources()
{
  this->Settings.put("SourcesText", this->Surfaces.Styles().ToText());
  this->FollowLoose();
  this->MaterialTime.Modified();
  this->Session.Modified();
}

std::string vtkHapticSession::Internals::FollowSourcesText()
{
  std::string problem = this->Surfaces.Styles().FromText(this->Settings.text("SourcesText"));
  if (problem.empty())
  {
    this->FollowSources();
  }
  return problem;
}

// Sources that are felt as more than a surface ------------------------------------------------------------------------

void vtkHapticSession::Internals::FollowSource(vtkHapticFeltSource& felt, const palpate::Setting& setting)
{
  if (setting.name == felt.Setting())
  {
    felt.Source = this->Settings.text(felt.Setting());
    this->AddFelt(felt, nullptr, nullptr);
    if (felt.IsHeld())
    {
      this->MaterialTime.Modified(); // who follows a view adds its surfaces again, all but this one
    }
  }
}

bool vtkHapticSession::Internals::AddFelt(
  vtkHapticFeltSource& felt, const char* name, vtkDataObject* data, const char* reason)
{
  const auto isInHand = [this] { return this->Mechanism.Axis().has_value() || this->Tool.Axis().has_value(); };
  const bool before = isInHand();
  const std::string problem = felt.Take(NameOf(name), data, NameOf(reason));
  this->Feel(felt, problem);
  if (this->Core.running() && !before && isInHand()) // a held body must not begin inside of a surface
  {
    this->LeadMouseAnew();
  }
  return problem.empty();
}

void vtkHapticSession::Internals::Feel(vtkHapticFeltSource& felt, const std::string& problem)
{
  felt.Choose(this->Core);
  const std::string why = problem.empty() ? felt.Refusal(this->Core) : problem;
  this->Refuse(why);
  this->Follow(felt.Subject(), why);
  if (!felt.IsHeld() && this->Tool.Choice().tool) // on it a tool may not be held
  {
    const std::string ofTool = this->Tool.Refusal(this->Core);
    this->Refuse(ofTool);
    this->Follow(this->Tool.Subject(), ofTool);
  }
  this->JudgeStability();
  this->FollowFelt();
  this->Scene.follow(this->PlanNow());
}

void vtkHapticSession::Internals::FollowFelt()
{
  for (vtkHapticFeltSource* const felt : this->FeltSources)
  {
    felt->Follow(this->Core, this->State, this->Now());
  }
  const palpate::Vec3* const ofMechanism = this->Mechanism.SoftHand_W();
  this->Soft.Hand_W = ofMechanism ? *ofMechanism : this->Soft.Hand_W;
}
