// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/PidDiscovery.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "devices/hid/PidEngine.h"

namespace palpate
{
namespace
{

std::string nameOf(const HidEntry& entry, const std::vector<FoundPid>& others)
{
  std::array<char, 16> ids{};
  std::snprintf(ids.data(), ids.size(), "pid-%04x-%04x", entry.vendor, entry.product);
  const std::string kind = std::string(ids.data()) + (entry.serial.empty() ? "" : "-" + entry.serial);
  const auto alike = std::count_if(others.begin(), others.end(),
    [&entry](const FoundPid& other)
    {
      return other.entry.vendor == entry.vendor && other.entry.product == entry.product &&
             other.entry.serial == entry.serial;
    });
  return alike == 0 ? kind : kind + "-" + std::to_string(alike + 1);
}

/// A wheel or stick with force, or one whose descriptor is broken where it promises some.
bool promisesForce(const ReportDescriptor& descriptor) noexcept
{
  return descriptor.hasCollection(pid::setEffect) && descriptor.hasCollection(pid::effectOperation);
}

} // namespace

std::vector<FoundPid> findPidDevices(HidBus& bus)
{
  std::vector<FoundPid> found;
  std::vector<HidEntry> entries = bus.devices();
  std::sort(entries.begin(), entries.end(), [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
  for (HidEntry& entry : entries)
  {
    ReportDescriptor descriptor = parseReportDescriptor(bus.descriptor(entry).bytes);
    if (!promisesForce(descriptor))
    {
      continue;
    }
    std::string problem = PidEngine::refusal(descriptor);
    if (problem.empty())
    {
      problem = bus.open(entry).problem;
    }
    std::string name = nameOf(entry, found);
    found.push_back({ std::move(name), std::move(entry), std::move(descriptor), std::move(problem) });
  }
  return found;
}

} // namespace palpate
