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

bool alike(const FoundHid& a, const FoundHid& b) noexcept
{
  return a.kind == b.kind && a.entry.vendor == b.entry.vendor && a.entry.product == b.entry.product &&
         a.entry.serial == b.entry.serial;
}

std::string nameOf(const FoundHid& one)
{
  std::array<char, 16> ids{};
  std::snprintf(ids.data(), ids.size(), "-%04x-%04x", one.entry.vendor, one.entry.product);
  const std::string first = one.kind == FoundHid::Kind::SpaceMouse ? "spacemouse" : "pid";
  return first + ids.data() + (one.entry.serial.empty() ? "" : "-" + one.entry.serial);
}

/// Adds one, with a name of its own.
void add(std::vector<FoundHid>& found, FoundHid one)
{
  one.name = nameOf(one);
  int before = 0;
  for (FoundHid& other : found)
  {
    if (alike(other, one))
    {
      other.hasTwin = one.hasTwin = true;
      ++before;
    }
  }
  one.name += before == 0 ? "" : "-" + std::to_string(before + 1);
  found.push_back(std::move(one));
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
    add(found, { *kind, {}, std::move(entry), std::move(descriptor), std::move(problem) });
  }
  return found;
}

} // namespace palpate
