// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms: bodies and the constraints that join them, from a scene file.
#include <iostream>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticJson.h"
#include "vtkHapticMechanismData.h"

namespace
{
nlohmann::ordered_json DescribedWire(const palpate::WireCheck& check)
{
  return { { "beams", check.beams }, { "most_contacts", check.contacts }, { "tightest_bend", check.tightest_u },
    { "clearance", check.clearance_u }, { "work", check.work } };
}

nlohmann::ordered_json DescribedConstraints(const palpate::MechanismCheck& check)
{
  return { { "rows", check.rows }, { "rank", check.rank }, { "free_turns", check.freeTurns },
    { "condition", check.condition }, { "redundant", check.redundant }, { "free", check.free } };
}
} // namespace

int vtkHapticCliCheckMechanism(const vtkHapticCliCheckOptions& options)
{
  const std::string& file = options.File;
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
    nlohmann::ordered_json described{ { "file", file }, { "touchable", true } };
    described.update(check.wire ? DescribedWire(*check.wire) : DescribedConstraints(check));
    described["remarks"] = check.remarks;
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
