// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTouchedField.h"

#include <vector>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"

vtkHapticTouchedField::vtkHapticTouchedField() : Parameters(palpate::sessionDefaults()) {}

bool vtkHapticTouchedField::IsAskedFor() const
{
  return this->Arrays.Any() || palpate::isOn(this->Parameters.field);
}

std::string vtkHapticTouchedField::Check() const
{
  const std::vector<double> component{ 1.0 * this->Arrays.Component }, smoothing{ 1.0 * this->Arrays.Smoothing };
  std::string problem;
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const bool field = setting.name.starts_with("Field") && setting.kind != palpate::SettingKind::Text;
    if (field && problem.empty())
    {
      const std::vector<double> values = !setting.at.field.empty()          ? fieldOf(this->Parameters, setting)
                                         : setting.name == "FieldSmoothing" ? smoothing
                                                                            : component;
      problem = palpate::refuse(setting, values, setting.name);
    }
  }
  if (problem.empty() && this->IsAskedFor() && !(this->Arrays.Any() && palpate::isOn(this->Parameters.field)))
  {
    problem = this->Arrays.Any()
                ? "an array is felt as a field, but in no way: give FieldIsosurface, FieldFollow or another one"
                : "a field is to be felt, but no array of it: give FieldArray, FieldVectors or FieldResistance";
  }
  return problem;
}
