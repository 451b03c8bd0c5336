// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/DeviceFactory.h"

#include "devices/FedDevice.h"
#include "devices/ReplayDevice.h"

namespace palpate
{
namespace
{

using Maker = std::unique_ptr<HapticDevice> (*)(const DeviceOptions&);

struct Kind
{
  const char* name;
  const char* what;
  Maker make;
};

const Kind kinds[] = {
  { "fed", "poses fed by a program: the mouse in a view, a script",
    [](const DeviceOptions&) -> std::unique_ptr<HapticDevice> { return std::make_unique<FedDevice>(); } },
  { "simulated-ideal", "a simulated hand on 0.1 kg without friction or damping",
    [](const DeviceOptions& o) -> std::unique_ptr<HapticDevice>
    { return std::make_unique<SimulatedHand>(idealHand(), o.stroke, o.period_s); } },
  { "simulated-generic", "a simulated hand on 0.1 kg with a damping of 1 N s/m",
    [](const DeviceOptions& o) -> std::unique_ptr<HapticDevice>
    { return std::make_unique<SimulatedHand>(genericHand(), o.stroke, o.period_s); } },
  { "replay", "the hand of a recording",
    [](const DeviceOptions& o) -> std::unique_ptr<HapticDevice>
    { return std::make_unique<ReplayDevice>(o.recordingFile); } },
};

} // namespace

std::vector<KnownDevice> knownDevices()
{
  std::vector<KnownDevice> known;
  for (const Kind& kind : kinds)
  {
    known.push_back({ kind.name, kind.what, kind.make({})->info(), "" });
  }
  return known;
}

MadeDevice makeDevice(const std::string& name, const DeviceOptions& options)
{
  std::string names;
  for (const Kind& kind : kinds)
  {
    if (name == kind.name)
    {
      return { kind.make(options), "" };
    }
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return { nullptr, "device \"" + name + "\" is not known; known are " + names };
}

} // namespace palpate
