// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "devices/arm/ListedArmBus.h"
#include "devices/arm/WireLine.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/Plugs.h"
#include "devices/arm/link/SerialPort.h"
#include "haptics/arm/file/ArmFile.h"

namespace palpate
{

/// The board keeps its torque when its host dies: without a guard it is not used.
ArmBus::Opened openTwoDiy(const std::string& path)
{
  Outcome<std::unique_ptr<SerialPort>> port = SerialPort::open(path);
  if (port.value == nullptr)
  {
    return { nullptr, std::move(port.problem) };
  }
  const auto wire = std::make_shared<TwoDiyWire>(twoDiyBoard());
  Outcome<Guard> guard = Guard::start(port.value->handle(), 0, wire->farewell());
  if (!guard.ok())
  {
    return { nullptr, std::move(guard.problem) };
  }
  auto line = std::make_unique<WireLine>(std::move(port.value), wire, std::move(guard.value));
  std::string problem = line->begin();
  return { problem.empty() ? std::move(line) : nullptr, problem };
}

/// The numbers are those of the arm's file.
TwoDiyWire::Setup twoDiyBoard()
{
  const ArmPlan plan = knownArm("pantograph").value;
  TwoDiyWire::Setup board;
  for (std::size_t i = 0; i < board.offset_deg.size(); ++i)
  {
    board.offset_deg[i] = plan.joints[i].zero_rad * 180.0 / std::numbers::pi;
    board.countsPerTurn[i] = plan.joints[i].countsPerTurn;
  }
  board.largest_Nm = plan.joints[0].maxTorque_Nm;
  return board;
}

ArmSetup twoDiySetup()
{
  ArmSetup setup;
  setup.what = "Haply 2DIY";
  setup.plan = knownArm("pantograph").value;
  setup.tellsAngles = true;
  const TwoDiyWire::Setup board = twoDiyBoard();
  std::transform(board.offset_deg.begin(), board.offset_deg.end(), setup.counters.begin(),
    [](double offset_deg) { return static_cast<std::int16_t>(std::lround(offset_deg)); });
  setup.poseTolerance = 3.0;
  setup.pose = "Hold both arms of the pantograph stretched out to the sides, then press the button: the angles begin "
               "there.";
  return setup;
}

ArmKit twoDiyKit(const std::string& sys, FileAccess access)
{
  // The native port of the boards' SAM3X and SAMD21 as Arduino numbers it.
  const UsbIds ids{ { 0x2341, 0x003E }, { 0x2341, 0x804D }, { 0x2A03, 0x003E }, { 0x2A03, 0x804D } };
  return { "2diy",
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [ids, sys] { return serialPlugs(ids, sys); },
      [](const HidEntry& entry) { return openTwoDiy(entry.path); },
      [access](const HidEntry& entry) { return fileRefusal(entry.path, access); } }),
    twoDiySetup() };
}

} // namespace palpate
