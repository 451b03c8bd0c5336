// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of surfaces, from their arrays.
#include "vtkHapticPathData.h"
#include "vtkHapticSceneSurfaces.h"
#include <algorithm>
#include <vector>

#include "haptics/session/settings/Setting.h"
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

const char* vtkHapticSession::Internals::SayMaterialText()
{
  const std::vector<double>& felt = this->Settings.of("StiffnessFeltRange").numbers;
  const double most_N_per_m = std::max(felt[0], felt[1]), spring_N_per_m = this->FeltStiffness();
  const bool cut = !this->Settings.text("StiffnessArray").empty() && most_N_per_m > spring_N_per_m;
  this->MaterialText = cut ? "data of up to " + palpate::quantity(most_N_per_m, "N/m") + " feel like the spring of " +
                               palpate::quantity(spring_N_per_m, "N/m") + ": raise Stiffness, or lower Feels like"
                           : "";
  return this->MaterialText.c_str();
}
