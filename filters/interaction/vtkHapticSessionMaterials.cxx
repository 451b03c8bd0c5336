// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces are made of, from their arrays.
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

namespace
{
vtkHapticTransfer TransferOf(const palpate::SettingStore& settings, const std::string& quantity)
{
  const auto range = [&](const char* name)
  {
    const std::vector<double>& ends = settings.of(quantity + name).numbers;
    return std::array<double, 2>{ ends.at(0), ends.at(1) };
  };
  return { settings.text(quantity + "Array"), settings.whole(quantity + "Component"), range("DataRange"),
    range("FeltRange") };
}
} // namespace

std::string vtkHapticSession::Internals::FollowMaterials()
{
  vtkHapticMaterialSettings materials;
  materials.Stiffness = TransferOf(this->Settings, "Stiffness");
  materials.Friction = TransferOf(this->Settings, "Friction");
  materials.Texture = TransferOf(this->Settings, "Texture");
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
