// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/common/DeviceNotes.h"
#include "vtkHapticJson.h"

namespace
{
/// A number of DeviceInfo by its name in JSON, for a person, and its unit.
struct Quantity
{
  palpate::DeviceQuantity palpate::DeviceInfo::*Member;
  const char* Key;
  const char* Label;
  const char* Unit;
};

constexpr std::array<Quantity, 12> Quantities = { {
  { &palpate::DeviceInfo::workspaceRadius_m, "workspace_radius_m", "workspace radius", "m" },
  { &palpate::DeviceInfo::resolution_m, "resolution_m", "resolution", "m" },
  { &palpate::DeviceInfo::maxForce_N, "max_force_N", "largest force", "N" },
  { &palpate::DeviceInfo::turnResolution_rad, "turn_resolution_rad", "resolution of turning", "rad" },
  { &palpate::DeviceInfo::maxTorque_Nm, "max_torque_Nm", "largest torque", "N m" },
  { &palpate::DeviceInfo::maxStiffness_N_per_m, "max_stiffness_N_per_m", "largest stiffness", "N/m" },
  { &palpate::DeviceInfo::heldStiffness_N_per_m, "held_stiffness_N_per_m", "stiffness of walls it holds", "N/m" },
  { &palpate::DeviceInfo::heldForce_N, "held_force_N", "largest force of these walls", "N" },
  { &palpate::DeviceInfo::maxDamping_Ns_per_m, "max_damping_Ns_per_m", "largest damping", "N s/m" },
  { &palpate::DeviceInfo::mass_kg, "mass_kg", "mass", "kg" },
  { &palpate::DeviceInfo::damping_Ns_per_m, "damping_Ns_per_m", "damping", "N s/m" },
  { &palpate::DeviceInfo::friction_N, "friction_N", "friction", "N" },
} };

const char* NameOf(palpate::Pacing pacing)
{
  switch (pacing)
  {
    case palpate::Pacing::Timer:
      return "timer";
    case palpate::Pacing::Device:
      return "device";
    case palpate::Pacing::Callback:
      return "callback";
  }
  return "unknown";
}

const char* NameOf(palpate::Causality causality)
{
  return causality == palpate::Causality::Impedance ? "impedance" : "admittance";
}

nlohmann::ordered_json ToJson(const palpate::KnownDevice& device)
{
  nlohmann::ordered_json json;
  json["name"] = device.name;
  json["what"] = device.what;
  json["usable"] = device.problem.empty();
  json["problem"] = device.problem;
  json["serial"] = device.info.serial;
  json["simulated"] = device.info.simulated;
  json["renders_torque"] = device.info.rendersTorque;
  json["class"] = palpate::kindOf(device.info);
  json["has_twin"] = device.hasTwin;
  json["cannot"] = palpate::shortcomings(device.info);
  json["sensed_axes"] = device.info.abilities.sensedAxes;
  json["holds_walls"] = device.info.abilities.holdsWalls;
  json["offers_walls"] = device.info.offersWalls;
  json["leaves_walls_to_it"] = device.info.closesWalls();
  json["viscous"] = device.info.abilities.viscous;
  json["signals"] = device.info.abilities.signals;
  json["causality"] = NameOf(device.info.causality);
  json["pacing"] = NameOf(device.info.pacing);
  for (const Quantity& quantity : Quantities)
  {
    const palpate::DeviceQuantity& value = device.info.*quantity.Member;
    json[quantity.Key]["value"] = value.value; // infinity, no limit, becomes null
    json[quantity.Key]["known"] = value.known;
  }
  return json;
}

void Print(const palpate::KnownDevice& device)
{
  std::cout << device.name << (device.problem.empty() ? ": " : ": cannot be used: ")
            << (device.problem.empty() ? device.what : device.problem) << "\n  " << palpate::kindOf(device.info) << ", "
            << NameOf(device.info.causality) << ", paced by " << NameOf(device.info.pacing)
            << (device.info.simulated ? ", simulated" : "") << '\n';
  if (const std::string cannot = palpate::shortcomings(device.info); !cannot.empty())
  {
    std::cout << "  " << cannot << '\n';
  }
  if (device.hasTwin)
  {
    std::cout << "  " << palpate::twinNote << '\n';
  }
  for (const Quantity& quantity : Quantities)
  {
    const palpate::DeviceQuantity& value = device.info.*quantity.Member;
    if (std::isfinite(value.value) && (value.known || value.value != 0.0))
    {
      std::cout << "  " << quantity.Label << ' ' << value.value << ' ' << quantity.Unit
                << (value.known ? "" : " (assumed)") << '\n';
    }
  }
}
} // namespace

int vtkHapticCliDevices(bool json)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<palpate::KnownDevice> devices = palpate::knownDevices();
  palpate::applyCalibrations(
    devices, palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME")));
  for (const palpate::KnownDevice& device : devices)
  {
    if (json)
    {
      list.push_back(ToJson(device));
    }
    else
    {
      Print(device);
    }
  }
  if (json)
  {
    std::cout << list.dump(2) << '\n';
  }
  return 0;
}
