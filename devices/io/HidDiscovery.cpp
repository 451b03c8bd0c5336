// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/HidDiscovery.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "devices/hid/NamedDevices.h"
#include "devices/hid/SpaceMouseInput.h"
#include "devices/hid/pid/PidEngine.h"

namespace palpate
{
namespace
{

/// Adds a device under a unique name.
void add(std::vector<FoundHid>& found, FoundHid one)
{
  const std::string road = one.kind == FoundHid::Kind::SpaceMouse ? "spacemouse"
                           : one.kind == FoundHid::Kind::Unusable ? "hid"
                                                                  : "pid";
  addNamed(found, road, std::move(one),
    [](const FoundHid& a, const FoundHid& b) { return a.kind == b.kind && sameKind(a.entry, b.entry); });
}

/// The kind that a descriptor promises, usable or not.
std::optional<FoundHid::Kind> promisedBy(const ReportDescriptor& descriptor) noexcept
{
  if (speaksPid(descriptor))
  {
    return FoundHid::Kind::ForceFeedback;
  }
  return SpaceMouseInput::describes(descriptor) ? std::optional(FoundHid::Kind::SpaceMouse) : std::nullopt;
}

/// True for a joystick, game pad, multi-axis controller, flight stick, wheel and similar controls.
bool isForHands(HidUsage purpose) noexcept
{
  constexpr HidUsage joystick = 0x010004, pad = 0x010005, multiAxis = 0x010008, simulation = 0x02;
  return purpose == joystick || purpose == pad || purpose == multiAxis || purpose >> 16U == simulation;
}

/// Why a control for a hand is of neither kind; none: the device is no such control.
std::optional<std::string> shortfall(const HidEntry& entry, const HidBus::Descriptor& read, const ReportDescriptor& d)
{
  if (!isForHands(entry.usage) && std::none_of(d.purposes.begin(), d.purposes.end(), isForHands))
  {
    return std::nullopt;
  }
  return read.problem.empty() ? PidEngine::refusal(d)
                              : "the report descriptor of the device cannot be read: " + read.problem;
}

std::string refusal(FoundHid::Kind kind, const ReportDescriptor& descriptor)
{
  return kind == FoundHid::Kind::SpaceMouse ? SpaceMouseInput(descriptor).refusal() : PidEngine::refusal(descriptor);
}

} // namespace

bool speaksPid(const ReportDescriptor& descriptor) noexcept
{
  return descriptor.hasCollection(pid::setEffect) && descriptor.hasCollection(pid::effectOperation);
}

std::vector<FoundHid> findHidDevices(HidBus& bus)
{
  std::vector<FoundHid> found;
  std::vector<HidEntry> entries = bus.devices();
  std::sort(entries.begin(), entries.end(), [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
  for (HidEntry& entry : entries)
  {
    const HidBus::Descriptor read = bus.descriptor(entry);
    ReportDescriptor descriptor = parseReportDescriptor(read.value);
    const std::optional<FoundHid::Kind> kind = promisedBy(descriptor);
    if (!kind)
    {
      if (std::optional<std::string> why = shortfall(entry, read, descriptor))
      {
        add(found, { FoundHid::Kind::Unusable, {}, std::move(entry), std::move(descriptor), std::move(*why) });
      }
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
