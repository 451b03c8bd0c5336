// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevDiscovery.h"

#include <algorithm>
#include <utility>

#include "devices/hid/NamedDevices.h"
#include "devices/io/HidDiscovery.h"

namespace palpate
{
namespace
{

bool isOnThisRoad(EvdevBus& bus, const HidEntry& entry, const EvdevTraits& traits)
{
  const std::vector<std::vector<std::uint8_t>> behind = bus.behindPlug(entry);
  const auto pid = [](const std::vector<std::uint8_t>& bytes) { return speaksPid(parseReportDescriptor(bytes)); };
  return isForHands(traits) && (traits.forces.any() || behind.empty()) &&
         std::none_of(behind.begin(), behind.end(), pid);
}

} // namespace

std::vector<FoundEvdev> findEvdevDevices(EvdevBus& bus)
{
  std::vector<FoundEvdev> found;
  std::vector<HidEntry> entries = bus.devices();
  std::sort(entries.begin(), entries.end(), [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
  for (HidEntry& entry : entries)
  {
    const EvdevTraits traits = bus.traits(entry);
    if (!isOnThisRoad(bus, entry, traits))
    {
      continue;
    }
    EvdevKind kind = evdevKind(traits, entry);
    std::string problem = kind.pushes.problem.empty() ? bus.open(entry).problem : kind.pushes.problem;
    addNamed(found, "evdev", FoundEvdev{ {}, std::move(entry), std::move(kind), std::move(problem) },
      [](const FoundEvdev& a, const FoundEvdev& b) { return sameKind(a.entry, b.entry); });
  }
  return found;
}

} // namespace palpate
