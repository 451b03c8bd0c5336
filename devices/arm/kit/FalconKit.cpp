// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/arm/FirmwareLine.h"
#include "devices/arm/ListedArmBus.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/Plugs.h"
#include "devices/arm/protocol/FalconWire.h"
#include "haptics/arm/file/ArmFile.h"

namespace palpate
{
namespace
{

ArmBus::Opened openFalcon(const HidEntry& entry)
{
  Outcome<std::unique_ptr<FtdiPort>> port = openFtdi(entry.path);
  if (port.value == nullptr)
  {
    return { nullptr, std::move(port.problem) };
  }
  auto line = std::make_unique<FirmwareLine>(std::move(port.value));
  std::string problem = line->begin();
  return { problem.empty() ? std::move(line) : nullptr, problem };
}

} // namespace

ArmSetup falconSetup()
{
  ArmSetup setup;
  setup.what = "Novint Falcon";
  setup.plan = knownArm("falcon").value;
  // Beyond the wire's largest number a force would be turned, not made smaller.
  for (ArmJoint& joint : setup.plan->joints)
  {
    const double wire_Nm = FalconWire::largestNumber / std::abs(FalconWire::number_per_Nm * joint.gear);
    joint.maxTorque_Nm = std::min(joint.maxTorque_Nm, wire_Nm);
  }
  setup.counterBits = 16;
  setup.homing = "Pull the knob out as far as it goes, then push it in: the motors find their zero.";
  return setup;
}

ArmKit falconKit(const std::string& sys, FileAccess access)
{
  const UsbIds ids{ { 0x0403, 0xCB48 } };
  ArmSetup setup = falconSetup();
  setup.problem = ftdiAbsence();
  return { "falcon",
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [ids, sys] { return usbPlugs(ids, sys); }, openFalcon,
      [access](const HidEntry& entry) { return fileRefusal(entry.path, access); } }),
    std::move(setup) };
}

} // namespace palpate
