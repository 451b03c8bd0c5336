// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <iostream>

#include "devices/arm/kit/WireFile.h"
#include "haptics/arm/shown/ArmWorkSpaceMap.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticJson.h"

namespace
{
constexpr int Steps = 20; ///< along the diameter of the work space

std::string Describe(const palpate::ArmWire& wire)
{
  std::string devices;
  for (const std::string& id : palpate::numbersOf(wire.devices))
  {
    devices += (devices.empty() ? "" : ", ") + id;
  }
  return palpate::protocolOf(wire) + std::string(", USB ") + devices +
         (wire.devices.serial.empty() ? "" : ", serial number " + wire.devices.serial);
}

nlohmann::ordered_json ToJson(const palpate::ArmWire& wire)
{
  nlohmann::ordered_json json;
  json["protocol"] = palpate::protocolOf(wire);
  json["usb"] = palpate::numbersOf(wire.devices);
  json["serial"] = wire.devices.serial;
  return json;
}

nlohmann::ordered_json ToJson(const palpate::Arm& arm, const palpate::ArmRange& range,
  const std::optional<palpate::ArmWire>& wire, const std::string& note)
{
  nlohmann::ordered_json json;
  json["name"] = arm.plan().name;
  json["kind"] = palpate::nameOf(arm.plan().geometry);
  json["class"] = palpate::classOf(arm.plan());
  json["joints"] = arm.joints();
  json["motors"] = arm.motors();
  json["source"] = arm.plan().source;
  if (wire)
  {
    json["wire"] = ToJson(*wire);
  }
  if (range.usable > 0)
  {
    json["places"] = range.places;
    json["usable_places"] = range.usable;
    json["condition"] = { range.leastCondition, range.mostCondition };
    json["manipulability"] = { range.leastManipulability, range.mostManipulability };
    json["force_N"] = { range.leastForce_N, range.mostForce_N };
    json["apparent_mass_kg"] = { range.leastMass_kg, range.mostMass_kg };
    json["best_m"] = { range.best_D.x(), range.best_D.y(), range.best_D.z() };
  }
  json["note"] = note;
  return json;
}

void Print(const palpate::Arm& arm, const palpate::ArmRange& range, const std::optional<palpate::ArmWire>& wire,
  const std::string& note)
{
  std::cout << arm.plan().name << ": " << palpate::nameOf(arm.plan().geometry) << ", " << palpate::classOf(arm.plan())
            << ", " << arm.joints() << " joints, " << arm.motors() << " motors\n";
  if (!arm.plan().source.empty())
  {
    std::cout << "  source: " << arm.plan().source << '\n';
  }
  if (wire)
  {
    std::cout << "  wire: " << Describe(*wire) << '\n';
  }
  if (range.usable > 0)
  {
    std::cout << "  condition of the Jacobian: " << range.leastCondition << " to " << range.mostCondition << '\n'
              << "  manipulability, the product of its singular values: " << range.leastManipulability << " to "
              << range.mostManipulability << '\n'
              << "  largest force in the worst direction: " << range.leastForce_N << " to " << range.mostForce_N
              << " N\n"
              << "  apparent mass: " << range.leastMass_kg << " to " << range.mostMass_kg << " kg\n"
              << "  best place: " << 1e3 * range.best_D.x() << ", " << 1e3 * range.best_D.y() << ", "
              << 1e3 * range.best_D.z() << " mm\n";
  }
  if (!note.empty())
  {
    std::cout << "  note: " << note << '\n';
  }
}
} // namespace

int vtkHapticCliArm(const std::string& file, bool json)
{
  const palpate::Outcome<palpate::WiredArm> wired = palpate::wiredArmNamed(file);
  if (!wired.ok())
  {
    throw vtkHapticCliProblem(wired.problem);
  }
  const palpate::Arm arm(wired.value.plan);
  const palpate::ArmRange range = palpate::rangeOf(arm, palpate::mapWorkSpace(arm, Steps));
  const std::string note = palpate::noteOn(arm, range);
  if (json)
  {
    std::cout << ToJson(arm, range, wired.value.wire, note).dump(2) << '\n';
  }
  else
  {
    Print(arm, range, wired.value.wire, note);
  }
  return 0;
}
