// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "devices/arm/ListedArmBus.h"
#include "devices/arm/ServiceLine.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/WebSocketLink.h"
#include "devices/arm/protocol/HaplyServiceWire.h"

namespace palpate
{
namespace
{

constexpr int connect_ms = 300, inventory_ms = 500;
constexpr const char* absent = "the vendor's service is installed but does not run: start haply-inverse-service";
constexpr const char* haplyName = "Haply "; ///< of an entry, before the type of the device
constexpr std::size_t longestInventory = 1U << 20U;

/// A connection and the message that it begins with.
struct Entered
{
  std::unique_ptr<ByteLink> link;
  std::vector<HaplyDevice> devices;
  std::string session; ///< of this connection
  std::string problem;

  /// Null: the service has no such device.
  [[nodiscard]] const HaplyDevice* find(const HidEntry& entry) const
  {
    const auto found = std::find_if(this->devices.begin(), this->devices.end(),
      [&entry](const HaplyDevice& device) { return device.id == entry.serial; });
    return found != this->devices.end() ? &*found : nullptr;
  }
};

Entered enter(const HaplyPorts& ports)
{
  LoopbackSocket socket = openLoopbackSocket(ports.states, connect_ms);
  if (socket.link == nullptr)
  {
    return { nullptr, {}, {},
      socket.nobodyListens ? absent
                           : "the vendor's service does not accept a connection on port " +
                               std::to_string(ports.states) + " of this computer: " + socket.problem };
  }
  WireBytes message(longestInventory);
  const int count = socket.link->receive(message, inventory_ms);
  const std::string_view text(
    reinterpret_cast<const char*>(message.data()), static_cast<std::size_t>(std::max(0, count)));
  std::optional<std::vector<HaplyDevice>> devices = haplyInventory(text);
  if (!devices)
  {
    return { nullptr, {}, {}, "the vendor's service does not say which devices it has" };
  }
  return { std::move(socket.link), std::move(*devices), haplySession(text), {} };
}

std::string refusalOf(const HaplyDevice& device)
{
  return device.inUse ? "another program uses this device through the vendor's service, and forces would add: close it"
                      : "";
}

/// An arm that awaits a step can be opened: its force begins when the step is done.
std::string noteOn(const HaplyDevice& device)
{
  return !device.calibrated ? "not calibrated: calibrate the device as the vendor's program says"
         : !device.ready    ? "not ready: look at the device in the vendor's program"
                            : "";
}

/// 3.5 answers on the port of states, older ones on a port of their own.
Outcome<bool> hasVector(const HaplyPorts& ports)
{
  for (const std::uint16_t port : { ports.states, ports.questions })
  {
    const Outcome<std::string> version = askLoopback(port, "/3.0/version", connect_ms);
    const std::optional<bool> vector = version.ok() ? haplyHasVector(version.value) : std::nullopt;
    if (vector)
    {
      return { *vector, {} };
    }
  }
  return { false, "the vendor's service does not tell its version, so how it takes forces is unknown" };
}

ArmBus::Opened openHaply(const HidEntry& entry, const HaplyPorts& ports)
{
  const Outcome<bool> vector = hasVector(ports);
  Entered entered = vector.ok() ? enter(ports) : Entered{ nullptr, {}, {}, vector.problem };
  if (entered.link == nullptr)
  {
    return { nullptr, entered.problem };
  }
  const HaplyDevice* const found = entered.find(entry);
  std::string problem = found != nullptr ? refusalOf(*found) : "the vendor's service has no device " + entry.serial;
  if (!problem.empty())
  {
    return { nullptr, problem };
  }
  // Where nobody listens the service has no such channel; every other failure would hide its safety events.
  LoopbackSocket events = openLoopbackSocket(ports.events, connect_ms);
  if (events.link == nullptr && !events.nobodyListens)
  {
    return { nullptr, "the vendor's service does not open its channel of safety events on port " +
                        std::to_string(ports.events) + ": " + events.problem };
  }
  const Vec3 inBase_D(0.0, -0.12, 0.15); // where the samples of the vendor rest, of an origin in the base
  const Vec3 centre_D = found->centred ? Vec3(Vec3::Zero()) : inBase_D;
  auto wire = std::make_unique<WireLine>(
    std::move(entered.link), std::make_shared<HaplyServiceWire>(entry.serial, vector.value, centre_D, entered.session));
  problem = wire->begin();
  if (!problem.empty())
  {
    return { nullptr, problem };
  }
  const auto stops = [id = entry.serial](std::string_view message) { return haplyStop(message, id); };
  return { std::make_unique<ServiceLine>(std::move(wire), std::move(events.link), stops), {} };
}

HidEntry entryOf(const HaplyDevice& device)
{
  return { device.id, 0, 0, device.id, haplyName + device.type };
}

/// A service that is installed and silent is told of; one that is not there is not.
std::vector<HidEntry> listHaply(const HaplyPorts& ports)
{
  std::vector<HidEntry> entries;
  const Entered entered = enter(ports);
  for (const HaplyDevice& device : entered.devices)
  {
    entries.push_back(entryOf(device));
  }
  std::error_code ignored;
  if (entered.link == nullptr && std::filesystem::exists(ports.installed, ignored))
  {
    entries.push_back({ "service", 0, 0, "", "Haply Inverse3 or Minverse" });
  }
  return entries;
}

std::string refuseHaply(const HidEntry& entry, const HaplyPorts& ports)
{
  const Entered entered = enter(ports);
  if (entry.serial.empty() && entered.link != nullptr)
  {
    return "the vendor's service runs now: list the devices again";
  }
  const HaplyDevice* const found = entered.find(entry);
  return entered.link == nullptr ? entered.problem : found == nullptr ? "" : refusalOf(*found);
}

std::string noteHaply(const HidEntry& entry, const HaplyPorts& ports)
{
  const Entered entered = enter(ports);
  const HaplyDevice* const found = entered.find(entry);
  return found != nullptr ? noteOn(*found) : "";
}

} // namespace

/// The radii are those that the vendor's samples use.
ArmSetup haplySetup(const std::string& type)
{
  constexpr double inverse3Radius_m = 0.1, minverseRadius_m = 0.04, watchedForce_N = 5.0;
  ArmSetup setup;
  setup.what = "Haply Inverse3, Inverse3X or Minverse";
  setup.turns = true;
  setup.radius_m = { type == "minverse" ? minverseRadius_m : inverse3Radius_m, false };
  setup.force_N = { watchedForce_N, false };
  setup.homing = "Calibrate the device as the vendor's program says, until it is ready.";
  return setup;
}

ArmKit haplyKit(const HaplyPorts& ports)
{
  ArmKit kit{ "haply",
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [ports] { return listHaply(ports); },
      [ports](const HidEntry& entry) { return openHaply(entry, ports); },
      [ports](const HidEntry& entry) { return refuseHaply(entry, ports); },
      [ports](const HidEntry& entry) { return noteHaply(entry, ports); } }),
    haplySetup() };
  kit.setupOf = [](const HidEntry& entry)
  { return haplySetup(entry.name.substr(std::min(entry.name.size(), std::string(haplyName).size()))); };
  return kit;
}

} // namespace palpate
