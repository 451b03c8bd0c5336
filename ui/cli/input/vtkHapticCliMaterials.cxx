// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliMaterials.h"

#include <string>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkHapticCliProblem.h"

namespace
{
/// `property`: what the names of the session's settings begin with.
void AddTransfer(CLI::App& command, const std::string& name, const std::string& property, vtkHapticTransfer& transfer)
{
  const std::string option = "--" + name;
  const auto said = [&](const char* part)
  {
    const palpate::Setting& setting = palpate::sessionSetting(property + part);
    return std::string(setting.sentence) + "; " + palpate::defaultWords(setting);
  };
  CLI::Option* array = command.add_option(option + "-array", transfer.Array, said("Array"));
  command.add_option(option + "-component", transfer.Component, said("Component"))->needs(array);
  const auto addRange = [&](const char* of, std::array<double, 2>& range, const char* part)
  { command.add_option(option + of, range, said(part))->delimiter(',')->type_name("LOW,HIGH")->needs(array); };
  addRange("-range", transfer.DataRange, "DataRange");
  addRange("-to", transfer.FeltRange, "FeltRange");
}
} // namespace

void vtkHapticCliAddMaterials(CLI::App& command, vtkHapticMaterialSettings& settings)
{
  AddTransfer(command, "stiffness", "Stiffness", settings.Stiffness);
  AddTransfer(command, "friction", "Friction", settings.Friction);
  AddTransfer(command, "texture", "Texture", settings.Texture);
}

void vtkHapticCliCheckMaterials(const vtkHapticMaterialSettings& settings)
{
  if (const std::string problem = settings.Check(); !problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
}
