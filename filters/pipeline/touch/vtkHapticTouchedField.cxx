// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTouchedField.h"

#include <map>
#include <string_view>
#include <vector>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"

vtkHapticTouchedField::vtkHapticTouchedField() : Parameters(palpate::sessionDefaults()) {}

palpate::FieldPlan vtkHapticTouchedField::Plan() const
{
  palpate::FieldPlan plan = this->Parameters.field;
  static_cast<void>(palpate::setLevels(plan.detent, this->Levels));
  return plan;
}

bool vtkHapticTouchedField::IsAskedFor() const
{
  return this->Arrays.Any() || palpate::isOn(this->Parameters.field);
}

std::string vtkHapticTouchedField::Check() const
{
  const std::map<std::string_view, double> ofArrays{ { "FieldComponent", this->Arrays.Component },
    { "FieldSmoothing", this->Arrays.Smoothing }, { "FieldEigenvector", this->Arrays.Eigenvector } };
  palpate::DetentPlan detent = this->Parameters.field.detent;
  std::string problem = palpate::setLevels(detent, this->Levels);
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const bool field = setting.name.starts_with("Field") && setting.kind != palpate::SettingKind::Text;
    if (field && problem.empty())
    {
      const std::vector<double> values =
        setting.at.field.empty() ? std::vector{ ofArrays.at(setting.name) } : fieldOf(this->Parameters, setting);
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
