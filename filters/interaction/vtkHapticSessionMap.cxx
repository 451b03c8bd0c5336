// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <algorithm>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

void vtkHapticSession::FitWorkspace()
{
  const palpate::BuiltScene& scene = this->Impl->Scene.built();
  if (!scene.scene)
  {
    this->Refuse("there is no scene to fit the workspace to; add a surface and commit it");
    return;
  }
  const palpate::WorkspaceMap fitted = palpate::fittedMap(this->Impl->Asked.asked().map, scene, this->Impl->InfoNow());
  this->Change([&](palpate::HapticParameters& p) { p.map = fitted; });
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}
