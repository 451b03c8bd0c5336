// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliMaterials.h"

#include <string>

#include "vtkHapticCliProblem.h"

namespace
{
void AddRange(CLI::App& command, const std::string& option, std::array<double, 2>& range, const std::string& what)
{
  command.add_option(option, range, what)->delimiter(',')->type_name("LOW,HIGH");
}

void AddTransfer(CLI::App& command, const std::string& name, vtkHapticTransfer& transfer, const std::string& felt)
{
  const std::string option = "--" + name;
  command.add_option(option + "-array", transfer.Array, "array of points or cells that gives the " + name);
  command.add_option(option + "-component", transfer.Component, "of that array; -1: the length of a vector")
    ->capture_default_str();
  AddRange(command, option + "-range", transfer.DataRange, "its values between which the " + name + " changes; all");
  AddRange(command, option + "-to", transfer.FeltRange, felt);
}
} // namespace

void vtkHapticCliAddMaterials(CLI::App& command, vtkHapticMaterialSettings& settings)
{
  AddTransfer(command, "stiffness", settings.Stiffness, "what they feel like [N/m]; 100,1000");
  AddTransfer(command, "friction", settings.Friction, "what they feel like, 0 to 10, at rest and sliding; 0,1");
  AddTransfer(command, "texture", settings.Texture,
    "how high they feel [scene units]: the highest is the surface itself, lower ones are hollows; 0,1");
}

void vtkHapticCliCheckMaterials(const vtkHapticMaterialSettings& settings)
{
  if (const std::string problem = settings.Check(); !problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
}
