// SPDX-License-Identifier: GPL-3.0-or-later
// What the surface is made of, from its arrays.
#include "vtkHapticMaterialArrays.h"
#include "vtkTouchAlongPath.h"

/// What cannot be used is an error when the filter runs.
void vtkTouchAlongPath::ChangeMaterial(const std::function<void(vtkHapticMaterialSettings&)>& change)
{
  const vtkHapticMaterialSettings before = *this->Materials;
  change(*this->Materials);
  if (before != *this->Materials)
  {
    this->Modified();
  }
}

void vtkTouchAlongPath::SetStiffnessArray(const char* name)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Stiffness.Array = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetStiffnessArray() const
{
  return this->Materials->Stiffness.Array.c_str();
}

void vtkTouchAlongPath::SetStiffnessComponent(int component)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Stiffness.Component = component; });
}

int vtkTouchAlongPath::GetStiffnessComponent() const
{
  return this->Materials->Stiffness.Component;
}

void vtkTouchAlongPath::SetStiffnessDataRange(double low, double high)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Stiffness.DataRange = { low, high }; });
}

double* vtkTouchAlongPath::GetStiffnessDataRange()
{
  return this->Materials->Stiffness.DataRange.data();
}

void vtkTouchAlongPath::SetStiffnessFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Stiffness.FeltRange = { atLow, atHigh }; });
}

double* vtkTouchAlongPath::GetStiffnessFeltRange()
{
  return this->Materials->Stiffness.FeltRange.data();
}

void vtkTouchAlongPath::SetFrictionArray(const char* name)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Friction.Array = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetFrictionArray() const
{
  return this->Materials->Friction.Array.c_str();
}

void vtkTouchAlongPath::SetFrictionComponent(int component)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Friction.Component = component; });
}

int vtkTouchAlongPath::GetFrictionComponent() const
{
  return this->Materials->Friction.Component;
}

void vtkTouchAlongPath::SetFrictionDataRange(double low, double high)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Friction.DataRange = { low, high }; });
}

double* vtkTouchAlongPath::GetFrictionDataRange()
{
  return this->Materials->Friction.DataRange.data();
}

void vtkTouchAlongPath::SetFrictionFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Friction.FeltRange = { atLow, atHigh }; });
}

double* vtkTouchAlongPath::GetFrictionFeltRange()
{
  return this->Materials->Friction.FeltRange.data();
}

void vtkTouchAlongPath::SetTextureArray(const char* name)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Texture.Array = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetTextureArray() const
{
  return this->Materials->Texture.Array.c_str();
}

void vtkTouchAlongPath::SetTextureComponent(int component)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Texture.Component = component; });
}

int vtkTouchAlongPath::GetTextureComponent() const
{
  return this->Materials->Texture.Component;
}

void vtkTouchAlongPath::SetTextureDataRange(double low, double high)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Texture.DataRange = { low, high }; });
}

double* vtkTouchAlongPath::GetTextureDataRange()
{
  return this->Materials->Texture.DataRange.data();
}

void vtkTouchAlongPath::SetTextureFeltRange(double atLow, double atHigh)
{
  this->ChangeMaterial([=](vtkHapticMaterialSettings& m) { m.Texture.FeltRange = { atLow, atHigh }; });
}

double* vtkTouchAlongPath::GetTextureFeltRange()
{
  return this->Materials->Texture.FeltRange.data();
}
