// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "devices/arm/HidArmBus.h"
#include "devices/arm/ListedArmBus.h"
#include "devices/arm/WireLine.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/SerialPort.h"
#include "devices/arm/protocol/WoodenHapticsWire.h"

namespace palpate
{
namespace
{

/// The board keeps its torque when its host dies: without a guard it is not used.
ArmBus::Opened open2Diy(const TwoDiyWire::Setup& board, const std::string& path)
{
  Outcome<std::unique_ptr<SerialPort>> port = SerialPort::open(path);
  if (port.value == nullptr)
  {
    return { nullptr, std::move(port.problem) };
  }
  const auto wire = std::make_shared<TwoDiyWire>(board);
  Outcome<Guard> guard = Guard::start(port.value->handle(), 0, wire->farewell());
  if (!guard.ok())
  {
    return { nullptr, std::move(guard.problem) };
  }
  auto line = std::make_unique<WireLine>(std::move(port.value), wire, std::move(guard.value));
  std::string problem = line->begin();
  return { problem.empty() ? std::move(line) : nullptr, problem };
}

std::shared_ptr<ArmBus> busOf2Diy(const Outcome<WiredArm>& arm, const ArmPlaces& places)
{
  const auto board = arm.ok() ? boardOf(arm.value) : TwoDiyWire::Setup{};
  const auto list = [wire = *arm.value.wire, sys = places.sys]
  {
    std::vector<HidEntry> boards = serialPlugs(wire.devices.ids, sys);
    std::erase_if(boards, [&wire](const HidEntry& entry) { return !wire.devices.have(entry); });
    return boards;
  };
  return std::make_shared<ListedArmBus>(
    ListedArmBus::Ways{ list, [board](const HidEntry& entry) { return open2Diy(board, entry.path); },
      [access = places.access](const HidEntry& entry) { return fileRefusal(entry.path, access); } });
}

/// A Teensy always sends 64 bytes; other boards have reports as long as the message.
std::size_t usualReportBytes(const HidEntry& entry)
{
  constexpr std::size_t teensyBytes = 64;
  return entry.vendor == 0x16C0 && entry.product == 0x0486 ? teensyBytes : WoodenHapticsWire::length;
}

/// A Teensy has a part for text beside the one for reports.
std::shared_ptr<ArmBus> busOfWoodenHaptics(const Outcome<WiredArm>& arm, const ArmPlaces& places)
{
  const auto constants_Nm_per_A =
    arm.ok() ? constantsOf(arm.value.plan) : std::array<double, WireOrder::motors>{ 1.0, 1.0, 1.0 };
  const auto reportBytes = [wire = *arm.value.wire](const HidEntry& entry)
  {
    constexpr HidUsage textPage = 0xFFC9;
    const std::size_t told = std::get<WoodenHapticsBoard>(wire.board).reportBytes;
    const bool isArm = wire.devices.have(entry) && entry.usage >> 16U != textPage;
    return !isArm ? 0 : told > 0 ? told : usualReportBytes(entry);
  };
  const bool grips = std::get<WoodenHapticsBoard>(arm.value.wire->board).grips;
  return std::make_shared<HidArmBus>(
    places.hid, std::make_shared<WoodenHapticsWire>(constants_Nm_per_A, grips), reportBytes);
}

std::shared_ptr<ArmBus> nowhere()
{
  return std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [] { return std::vector<HidEntry>(); },
    [](const HidEntry&) {
      return ArmBus::Opened{ nullptr, "no such device" };
    },
    [](const HidEntry&) { return std::string(); } });
}

} // namespace

ArmKit wiredKit(const std::string& road, const Outcome<WiredArm>& arm, const ArmPlaces& places)
{
  ArmKit kit;
  kit.road = road;
  kit.bus = !arm.value.wire                                              ? nowhere()
            : std::holds_alternative<TwoDiyBoard>(arm.value.wire->board) ? busOf2Diy(arm, places)
                                                                         : busOfWoodenHaptics(arm, places);
  if (arm.ok())
  {
    kit.setup = setupOf(arm.value);
  }
  kit.setup.problem = arm.problem;
  return kit;
}

} // namespace palpate
