// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces are made of, from their arrays.
#include "vtkHapticPathData.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

std::string vtkHapticSession::Internals::FollowMaterials()
{
  const vtkHapticMaterialSettings materials = vtkHapticMaterialsOf(this->Settings);
  std::string problem = materials.Check();
  if (problem.empty())
  {
    this->Materials = materials;
    this->Surfaces.SetMaterials(materials);
    this->MaterialTime.Modified();
  }
  return problem;
}

std::string vtkHapticSession::Internals::FollowRadii()
{
  this->Surfaces.SetLineRadius(this->Settings.number("LineRadius"));
  this->Surfaces.SetPointRadius(this->Settings.number("PointRadius"));
  this->MaterialTime.Modified();
  return {};
}
