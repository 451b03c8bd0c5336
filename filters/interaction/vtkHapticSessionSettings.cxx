// SPDX-License-Identifier: GPL-3.0-or-later
// Settings by their name: which values are taken, where they are kept, and their effects.
#include <limits>
#include <map>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkHapticSessionInternals.h"

namespace
{
const palpate::Setting* Find(const char* name)
{
  return palpate::findSetting(name ? name : "");
}
} // namespace

const std::map<std::string_view, vtkHapticSession::Internals::Follower>& vtkHapticSession::Internals::Followers()
{
  using I = Internals;
  static const std::map<std::string_view, Follower> followers = {
    { "CompareSource", &I::FollowFieldArrays },
    { "DeviceName", &I::FollowDeviceName },
    { "FeltSource", &I::FollowFieldArrays },
    { "FieldArray", &I::FollowFieldArrays },
    { "FieldComponent", &I::FollowFieldArrays },
    { "FieldDetentLevels", &I::FollowDetentLevels },
    { "FieldEigenvector", &I::FollowFieldArrays },
    { "FieldOther", &I::FollowFieldArrays },
    { "FieldResistance", &I::FollowFieldArrays },
    { "FieldSmoothing", &I::FollowFieldArrays },
    { "FieldVectors", &I::FollowFieldArrays },
    { "FrictionArray", &I::FollowMaterials },
    { "FrictionComponent", &I::FollowMaterials },
    { "FrictionDataRange", &I::FollowMaterials },
    { "FrictionFeltRange", &I::FollowMaterials },
    { "FrictionKinetic", &I::FollowFriction },
    { "FrictionStatic", &I::FollowFriction },
    { "Hand", &I::FollowHolder },
    { "Gravity", &I::FollowLooseSettings },
    { "HoldWalls", &I::FollowPlaneWishes },
    { "LimitRadius", &I::FollowRadiusLimit },
    { "LineRadius", &I::FollowRadii },
    { "LinesAsWalls", &I::FollowLinesAsWalls },
    { "MarksText", &I::FollowMarksText },
    { "MechanismConstraints", &I::FollowMechanismConstraints },
    { "PlaneGuide", &I::FollowPlaneWishes },
    { "PointRadius", &I::FollowRadii },
    { "Recording", &I::FollowRecordingWish },
    { "SceneUnit", &I::FollowLooseSettings },
    { "ServerLimit", &I::FollowServerLimit },
    { "Simplify", &I::FollowSimplify },
    { "SoftRate", &I::FollowSoftRate },
    { "SourcesText", &I::FollowSourcesText },
    { "StiffnessArray", &I::FollowMaterials },
    { "StiffnessComponent", &I::FollowMaterials },
    { "StiffnessDataRange", &I::FollowMaterials },
    { "StiffnessFeltRange", &I::FollowMaterials },
    { "TextureArray", &I::FollowMaterials },
    { "TextureComponent", &I::FollowMaterials },
    { "TextureDataRange", &I::FollowMaterials },
    { "TextureFeltRange", &I::FollowMaterials },
    { "ToolHandle", &I::FollowToolHandle },
    { "ToolHandlePoint", &I::FollowToolHandle },
    { "ToolLever", &I::FollowToolHandle },
    { "ToolTipPoint", &I::FollowToolHandle },
    { "Touching", &I::FollowTouching },
    { "WallRate", &I::FollowWallRate },
    { "Wheel", &I::FollowWheel },
  };
  return followers;
}

std::string vtkHapticSession::Internals::Take(const palpate::Setting& setting, const palpate::SettingValue& value)
{
  const palpate::SettingValue was = this->ValueOf(setting);
  if (!setting.at.field.empty())
  {
    this->Change(
      [&](palpate::HapticParameters& p) { palpate::setField(p, setting, std::span<const double>(value.numbers)); });
    return {};
  }
  if (value == was)
  {
    return {};
  }
  this->Settings.put(setting.name, value);
  for (vtkHapticFeltSource* const felt : this->FeltSources)
  {
    this->FollowSource(*felt, setting);
  }
  const auto found = Followers().find(setting.name);
  const std::string problem = found == Followers().end() ? "" : (this->*found->second)();
  if (!problem.empty())
  {
    this->Settings.put(setting.name, was);
    return problem;
  }
  this->Session.Modified();
  return {};
}

palpate::SettingValue& vtkHapticSession::Internals::ValueOf(const palpate::Setting& setting)
{
  if (!setting.at.field.empty())
  {
    this->Settings.put(setting.name, { palpate::fieldOf(this->Asked.asked(), setting), {} });
  }
  else if (setting.name == "Touching")
  {
    this->Settings.put(setting.name, this->Core.running() ? 1.0 : 0.0);
  }
  return this->Settings.of(setting.name);
}

void vtkHapticSession::Internals::Put(const char* name, const palpate::SettingValue& value)
{
  const palpate::Setting* const setting = Find(name);
  if (!setting)
  {
    this->Refuse(std::string("no setting is called \"") + (name ? name : "") + "\"; GetDescribed() has their names");
    return;
  }
  std::string problem = palpate::refuse(*setting, value);
  this->Refuse(problem);
  this->Follow(name, problem);
  if (problem.empty() && !(problem = this->Take(*setting, value)).empty())
  {
    this->Refuse(problem);
    this->Follow(name, problem);
  }
}

void vtkHapticSession::SetSetting(const char* name, double value)
{
  this->Impl->Put(name, { { value }, {} });
}

void vtkHapticSession::SetSetting(const char* name, int value)
{
  this->SetSetting(name, static_cast<double>(value));
}

void vtkHapticSession::SetSetting(const char* name, double low, double high)
{
  this->Impl->Put(name, { { low, high }, {} });
}

void vtkHapticSession::SetSetting(const char* name, double x, double y, double z)
{
  this->Impl->Put(name, { { x, y, z }, {} });
}

void vtkHapticSession::SetSetting(const char* name, double w, double x, double y, double z)
{
  this->Impl->Put(name, { { w, x, y, z }, {} });
}

void vtkHapticSession::SetSetting(const char* name, const char* text)
{
  this->Impl->Put(name, { {}, text ? text : "" });
}

double vtkHapticSession::GetSetting(const char* name) const
{
  return this->GetSettingSize(name) > 0 ? *this->GetSettingNumbers(name) : std::numeric_limits<double>::quiet_NaN();
}

bool vtkHapticSession::IsOn(const char* name) const
{
  return this->GetSetting(name) == 1.0;
}

const char* vtkHapticSession::GetSettingText(const char* name) const
{
  const palpate::Setting* const setting = Find(name);
  return setting ? this->Impl->ValueOf(*setting).text.c_str() : nullptr;
}

int vtkHapticSession::GetSettingSize(const char* name) const
{
  const palpate::Setting* const setting = Find(name);
  return setting ? static_cast<int>(this->Impl->ValueOf(*setting).numbers.size()) : 0;
}

double* vtkHapticSession::GetSettingNumbers(const char* name) const
{
  const palpate::Setting* const setting = Find(name);
  return setting ? this->Impl->ValueOf(*setting).numbers.data() : nullptr;
}
