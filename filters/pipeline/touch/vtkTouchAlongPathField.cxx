// SPDX-License-Identifier: GPL-3.0-or-later
// Which numbers in space are felt, and how.
#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkHapticTouchedField.h"
#include "vtkTouchAlongPath.h"

/// What cannot be used is an error when the filter runs.
void vtkTouchAlongPath::ChangeField(const std::function<void(vtkHapticFieldArrays&)>& change)
{
  const vtkHapticFieldArrays before = this->Field->Arrays;
  change(this->Field->Arrays);
  if (before != this->Field->Arrays)
  {
    this->Modified();
  }
}

void vtkTouchAlongPath::SetField(const char* name, double value)
{
  if (this->GetField(name) != value)
  {
    palpate::setField(this->Field->Parameters, palpate::sessionSetting(name), { &value, 1 });
    this->Modified();
  }
}

double vtkTouchAlongPath::GetField(const char* name) const
{
  return palpate::fieldOf(this->Field->Parameters, palpate::sessionSetting(name)).front();
}

void vtkTouchAlongPath::SetFieldConnection(vtkAlgorithmOutput* field)
{
  this->SetInputConnection(2, field);
}

void vtkTouchAlongPath::SetFieldData(vtkDataObject* field)
{
  this->SetInputDataObject(2, field);
}

void vtkTouchAlongPath::SetComparedConnection(vtkAlgorithmOutput* compared)
{
  this->SetInputConnection(4, compared);
}

void vtkTouchAlongPath::SetComparedData(vtkDataObject* compared)
{
  this->SetInputDataObject(4, compared);
}

void vtkTouchAlongPath::SetSnapConnection(vtkAlgorithmOutput* snap)
{
  this->SetInputConnection(5, snap);
}

void vtkTouchAlongPath::SetSnapData(vtkDataObject* snap)
{
  this->SetInputDataObject(5, snap);
}

void vtkTouchAlongPath::SetFieldArray(const char* name)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Scalar = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetFieldArray() const
{
  return this->Field->Arrays.Scalar.c_str();
}

void vtkTouchAlongPath::SetFieldComponent(int component)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Component = component; });
}

int vtkTouchAlongPath::GetFieldComponent() const
{
  return this->Field->Arrays.Component;
}

void vtkTouchAlongPath::SetFieldVectors(const char* name)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Vector = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetFieldVectors() const
{
  return this->Field->Arrays.Vector.c_str();
}

void vtkTouchAlongPath::SetFieldEigenvector(int which)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Eigenvector = which; });
}

int vtkTouchAlongPath::GetFieldEigenvector() const
{
  return this->Field->Arrays.Eigenvector;
}

void vtkTouchAlongPath::SetFieldDetentLevels(const char* levels)
{
  const std::string asked = levels ? levels : "";
  if (asked != this->Field->Levels)
  {
    this->Field->Levels = asked;
    this->Modified();
  }
}

const char* vtkTouchAlongPath::GetFieldDetentLevels() const
{
  return this->Field->Levels.c_str();
}

void vtkTouchAlongPath::SetFieldResistance(const char* name)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Resistance = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetFieldResistance() const
{
  return this->Field->Arrays.Resistance.c_str();
}

void vtkTouchAlongPath::SetFieldOther(const char* name)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Other = name ? name : ""; });
}

const char* vtkTouchAlongPath::GetFieldOther() const
{
  return this->Field->Arrays.Other.c_str();
}

void vtkTouchAlongPath::SetFieldSmoothing(int times)
{
  this->ChangeField([=](vtkHapticFieldArrays& a) { a.Smoothing = times; });
}

int vtkTouchAlongPath::GetFieldSmoothing() const
{
  return this->Field->Arrays.Smoothing;
}
