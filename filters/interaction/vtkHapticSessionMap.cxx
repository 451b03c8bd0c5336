// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <sstream>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticRecordings.h"
#include "vtkHapticSessionInternals.h"

namespace
{
std::vector<std::string> LinesOf(const char* text)
{
  std::istringstream in(text ? text : "");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
  {
    lines.push_back(line);
  }
  return lines;
}
} // namespace

void vtkHapticSession::FitWorkspace()
{
  Internals& impl = *this->Impl;
  this->InvokeEvent(vtkCommand::UpdateDataEvent);
  impl.FitAsked = impl.Scene.worker().building();
  const bool nothing = !impl.FitAsked && !impl.IsFittable();
  const std::string problem = nothing ? "no touchable data to fit the workspace to: show a surface" : "";
  this->Impl->Refuse(problem);
  impl.Follow("FitWorkspace", problem);
  if (!nothing && !impl.FitAsked)
  {
    this->Impl->Fit();
  }
}

bool vtkHapticSession::Internals::FitsNow() const
{
  return this->Settings.isOn("FitOnTouch") && !this->Recorded.Played &&
         palpate::isSame(this->Asked.asked().map, this->LastFitted);
}

void vtkHapticSession::Internals::Fit()
{
  this->FitAsked = false;
  this->FitTo(this->Fittable());
}

void vtkHapticSession::Internals::FitTo(const palpate::BuiltScene& scene)
{
  const palpate::WorkspaceMap fitted = palpate::fittedMap(this->Asked.asked().map, scene, this->InfoNow());
  this->LastFitted = fitted;
  this->HandMap.reset();
  this->LetButtonsGo();
  this->Change(
    [&](palpate::HapticParameters& p)
    {
      p.map = fitted;
      p.clutch = false;
    });
  this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

void vtkHapticSession::FitToSources(const char* names)
{
  Internals& impl = *this->Impl;
  const std::vector<std::string> wanted = LinesOf(names);
  if (wanted.empty())
  {
    return;
  }
  palpate::BuiltScene chosen = impl.Scene.built();
  const std::string missing = palpate::boundsOf(chosen.scene.get(), wanted, chosen.bounds);
  const std::string problem =
    missing.empty() ? "" : missing + " is not touchable: show this source, or choose another one for the workspace";
  this->Impl->Refuse(problem);
  impl.Follow("FitWorkspace", problem);
  if (problem.empty())
  {
    this->Impl->FitTo(chosen);
  }
}

void vtkHapticSession::Internals::LetButtonsGo()
{
  this->Settings.put("Precision", 0.0);
  this->Settings.put("Clutch", 0.0);
}
