// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/HidDiscovery.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include "devices/hid/PidEngine.h"
#include "devices/hid/SpaceMouseInput.h"

namespace palpate
{
namespace
{

std::string nameOf(FoundHid::Kind kind, const HidEntry& entry, const std::vector<FoundHid>& others)
{
  std::array<char, 16> ids{};
  std::snprintf(ids.data(), ids.size(), "-%04x-%04x", entry.vendor, entry.product);
  const std::string first = kind == FoundHid::Kind::SpaceMouse ? "spacemouse" : "pid";
  const std::string name = first + ids.data() + (entry.serial.empty() ? "" : "-" + entry.serial);
  const auto alike = std::count_if(others.begin(), others.end(),
    [&](const FoundHid& other)
    {
      return other.kind == kind && other.entry.vendor == entry.vendor && other.entry.product == entry.product &&
             other.entry.serial == entry.serial;
    });
  return alike == 0 ? name : name + "-" + std::to_string(alike + 1);
}

/// What a descriptor promises, usable or not.
std::optional<FoundHid::Kind> promisedBy(const ReportDescriptor& descriptor) noexcept
{
  if (descriptor.hasCollection(pid::setEffect) && descriptor.hasCollection(pid::effectOperation))
  {
    return FoundHid::Kind::ForceFeedback;
  }
  return SpaceMouseInput::describes(descriptor) ? std::optional(FoundHid::Kind::SpaceMouse) : std::nullopt;
}

std::string refusal(FoundHid::Kind kind, const ReportDescriptor& descriptor)
{
  return kind == FoundHid::Kind::SpaceMouse ? SpaceMouseInput(descriptor).refusal() : PidEngine::refusal(descriptor);
}

} // namespace

std::vector<FoundHid> findHidDevices(HidBus& bus)
{
  std::vector<FoundHid> found;
  std::vector<HidEntry> entries = bus.devices();
  std::sort(entries.begin(), entries.end(), [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
  for (HidEntry& entry : entries)
  {
    ReportDescriptor descriptor = parseReportDescriptor(bus.descriptor(entry).bytes);
    const std::optional<FoundHid::Kind> kind = promisedBy(descriptor);
    if (!kind)
    {
      continue;
    }
    std::string problem = refusal(*kind, descriptor);
    if (problem.empty())
    {
      problem = bus.open(entry).problem;
    }
    std::string name = nameOf(*kind, entry, found);
    found.push_back({ *kind, std::move(name), std::move(entry), std::move(descriptor), std::move(problem) });
  }
  return found;
}

} // namespace palpate
