// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <algorithm>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

void vtkHapticSession::FitWorkspace()
{
  Internals& impl = *this->Impl;
  impl.FitAsked = impl.Scene.worker().building();
  const bool nothing = !impl.FitAsked && !impl.Scene.built().scene;
  const std::string problem = nothing ? "there is nothing to fit the hand to: show a surface that can be touched" : "";
  this->Refuse(problem);
  impl.Follow("FitWorkspace", problem);
  if (!nothing && !impl.FitAsked)
  {
    this->Fit();
  }
}

void vtkHapticSession::Fit()
{
  Internals& impl = *this->Impl;
  impl.FitAsked = false;
  const palpate::WorkspaceMap fitted = palpate::fittedMap(impl.Asked.asked().map, impl.Scene.built(), impl.InfoNow());
  impl.LastFitted = fitted;
  this->Change([&](palpate::HapticParameters& p) { p.map = fitted; });
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

void vtkHapticSession::SetFitOnTouch(bool on)
{
  if (on != this->Impl->FitOnTouch)
  {
    this->Impl->FitOnTouch = on;
    this->Modified();
  }
}

bool vtkHapticSession::GetFitOnTouch() const
{
  return this->Impl->FitOnTouch;
}
