// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms: bodies and the constraints that join them, from a scene file.
#include <iostream>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticJson.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticWireFile.h"

namespace
{
int CheckWire(const vtkHapticWireResult& read, const vtkHapticCliCheckOptions& options)
{
  const palpate::WireCheck check =
    read.Vessel ? palpate::planWire(read.Description, *read.Vessel, 1).check : palpate::WireCheck{};
  if (!read.Vessel || !check.faults.empty())
  {
    throw vtkHapticCliProblem(read.Vessel ? options.File + ": " + check.faults.front() : read.Problem);
  }
  if (options.Json)
  {
    const nlohmann::ordered_json described{ { "file", options.File }, { "touchable", true }, { "beams", check.beams },
      { "most_contacts", check.contacts }, { "tightest_bend", check.tightest_u }, { "clearance", check.clearance_u },
      { "work", check.work }, { "remarks", check.remarks } };
    std::cout << described.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return 0;
  }
  std::cout << options.File << ": it can be felt\n";
  for (const std::string& line : vtkHapticWireText(check))
  {
    std::cout << "  " << line << '\n';
  }
  return 0;
}
} // namespace

int vtkHapticCliCheckMechanism(const vtkHapticCliCheckOptions& options)
{
  const std::string& file = options.File;
  if (const vtkHapticWireResult wire = vtkHapticReadWire(file); wire.IsWire)
  {
    return CheckWire(wire, options);
  }
  const vtkHapticMechanismResult read = vtkHapticReadMechanism(file);
  if (!read.Inputs)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  palpate::MechanismHold hold = palpate::usualHold(read.Inputs->unit_m);
  hold.turning_N_m_per_rad = options.Settings.Number("MechanismTurning");
  std::string refusal;
  const auto touch = palpate::MechanismTouch::make(*read.Inputs, hold, refusal);
  if (!touch)
  {
    throw vtkHapticCliProblem(file + ": " + refusal);
  }
  const palpate::MechanismCheck& check = touch->check();
  if (options.Json)
  {
    nlohmann::ordered_json described{ { "file", file }, { "touchable", true }, { "rows", check.rows },
      { "rank", check.rank }, { "free_turns", check.freeTurns }, { "condition", check.condition },
      { "redundant", check.redundant }, { "free", check.free }, { "remarks", check.remarks } };
    for (const palpate::MechanismBody& body : read.Inputs->mechanism.bodies)
    {
      if (palpate::isLoose(body))
      {
        const vtkHapticLooseMass mass = vtkHapticMassOf(body, read.Inputs->unit_m);
        described["loose"].push_back(
          { { "name", body.name }, { "mass_kg", mass.Mass_kg }, { "density_kg_per_m3", mass.Density_kg_per_m3 } });
      }
    }
    std::cout << described.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return 0;
  }
  std::cout << file << ": it can be felt\n";
  for (const std::string& line : vtkHapticMechanismText(*read.Inputs, check))
  {
    std::cout << "  " << line << '\n';
  }
  return 0;
}
