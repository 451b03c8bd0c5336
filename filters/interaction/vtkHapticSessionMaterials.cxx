// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces are made of, from their arrays.
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::ChangeMaterial(const char* setting, std::initializer_list<double> values,
  const std::function<void(vtkHapticMaterialSettings&)>& change)
{
  vtkHapticMaterialSettings settings = this->Impl->Materials;
  change(settings);
  if (!this->Allows(setting, values) || settings == this->Impl->Materials)
  {
    return;
  }
  if (const std::string problem = settings.Check(); !problem.empty())
  {
    this->Refuse(problem);
    this->Impl->Follow(setting, problem);
    return;
  }
  this->Impl->Materials = settings;
  this->Impl->Surfaces.SetMaterials(settings);
  this->Impl->MaterialTime.Modified();
  this->Modified();
}

void vtkHapticSession::SetLineRadius(double radius_u)
{
  if (!this->Allows("LineRadius", { radius_u }))
  {
    return;
  }
  if (radius_u != this->Impl->LineRadius_u)
  {
    this->Impl->LineRadius_u = radius_u;
    this->Impl->Surfaces.SetLineRadius(radius_u);
    this->Impl->MaterialTime.Modified();
    this->Modified();
  }
}

double vtkHapticSession::GetLineRadius() const
{
  return this->Impl->LineRadius_u;
}

vtkMTimeType vtkHapticSession::GetMaterialTime() const
{
  return this->Impl->MaterialTime.GetMTime();
}

bool vtkHapticSession::GetUsesMaterialArrays() const
{
  return !this->Impl->Materials.Empty();
}

void vtkHapticSession::SetStiffnessArray(const char* name)
{
  this->ChangeMaterial(
    "StiffnessArray", {}, [=](vtkHapticMaterialSettings& m) { m.Stiffness.Array = name ? name : ""; });
}

const char* vtkHapticSession::GetStiffnessArray() const
{
  return this->Impl->Materials.Stiffness.Array.c_str();
}

void vtkHapticSession::SetStiffnessComponent(int component)
{
  this->ChangeMaterial("StiffnessComponent", { static_cast<double>(component) },
    [=](vtkHapticMaterialSettings& m) { m.Stiffness.Component = component; });
}

int vtkHapticSession::GetStiffnessComponent() const
{
  return this->Impl->Materials.Stiffness.Component;
}

void vtkHapticSession::SetStiffnessDataRange(double low, double high)
{
  this->ChangeMaterial("StiffnessDataRange", { low, high },
    [=](vtkHapticMaterialSettings& m) {
      m.Stiffness.DataRange = { low, high };
    });
}

double* vtkHapticSession::GetStiffnessDataRange()
{
  return this->Impl->Materials.Stiffness.DataRange.data();
}

void vtkHapticSession::SetStiffnessFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial("StiffnessFeltRange", { atLow, atHigh },
    [=](vtkHapticMaterialSettings& m) {
      m.Stiffness.FeltRange = { atLow, atHigh };
    });
}

double* vtkHapticSession::GetStiffnessFeltRange()
{
  return this->Impl->Materials.Stiffness.FeltRange.data();
}

void vtkHapticSession::SetFrictionArray(const char* name)
{
  this->ChangeMaterial("FrictionArray", {}, [=](vtkHapticMaterialSettings& m) { m.Friction.Array = name ? name : ""; });
}

const char* vtkHapticSession::GetFrictionArray() const
{
  return this->Impl->Materials.Friction.Array.c_str();
}

void vtkHapticSession::SetFrictionComponent(int component)
{
  this->ChangeMaterial("FrictionComponent", { static_cast<double>(component) },
    [=](vtkHapticMaterialSettings& m) { m.Friction.Component = component; });
}

int vtkHapticSession::GetFrictionComponent() const
{
  return this->Impl->Materials.Friction.Component;
}

void vtkHapticSession::SetFrictionDataRange(double low, double high)
{
  this->ChangeMaterial("FrictionDataRange", { low, high },
    [=](vtkHapticMaterialSettings& m) {
      m.Friction.DataRange = { low, high };
    });
}

double* vtkHapticSession::GetFrictionDataRange()
{
  return this->Impl->Materials.Friction.DataRange.data();
}

void vtkHapticSession::SetFrictionFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial("FrictionFeltRange", { atLow, atHigh },
    [=](vtkHapticMaterialSettings& m) {
      m.Friction.FeltRange = { atLow, atHigh };
    });
}

double* vtkHapticSession::GetFrictionFeltRange()
{
  return this->Impl->Materials.Friction.FeltRange.data();
}

void vtkHapticSession::SetTextureArray(const char* name)
{
  this->ChangeMaterial("TextureArray", {}, [=](vtkHapticMaterialSettings& m) { m.Texture.Array = name ? name : ""; });
}

const char* vtkHapticSession::GetTextureArray() const
{
  return this->Impl->Materials.Texture.Array.c_str();
}

void vtkHapticSession::SetTextureComponent(int component)
{
  this->ChangeMaterial("TextureComponent", { static_cast<double>(component) },
    [=](vtkHapticMaterialSettings& m) { m.Texture.Component = component; });
}

int vtkHapticSession::GetTextureComponent() const
{
  return this->Impl->Materials.Texture.Component;
}

void vtkHapticSession::SetTextureDataRange(double low, double high)
{
  this->ChangeMaterial("TextureDataRange", { low, high },
    [=](vtkHapticMaterialSettings& m) {
      m.Texture.DataRange = { low, high };
    });
}

double* vtkHapticSession::GetTextureDataRange()
{
  return this->Impl->Materials.Texture.DataRange.data();
}

void vtkHapticSession::SetTextureFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial("TextureFeltRange", { atLow, atHigh },
    [=](vtkHapticMaterialSettings& m) {
      m.Texture.FeltRange = { atLow, atHigh };
    });
}

double* vtkHapticSession::GetTextureFeltRange()
{
  return this->Impl->Materials.Texture.FeltRange.data();
}
