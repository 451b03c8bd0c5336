// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/DeviceFactory.h"

#include <functional>

#include "devices/FedDevice.h"
#include "devices/ReplayDevice.h"

namespace palpate
{
namespace
{

struct Kind
{
  std::string name;
  std::string what;
  std::function<MadeDevice(const DeviceOptions&)> make;
};

MadeDevice makeSimulated(const DeviceModel& model, const DeviceOptions& options)
{
  const HandModel* const hand = handModel(options.hand);
  if (hand == nullptr)
  {
    std::string names;
    for (const HandModel& known : handModels())
    {
      names += (names.empty() ? "" : ", ") + known.name;
    }
    return { nullptr, "hand \"" + options.hand + "\" is not known; known are " + names };
  }
  SimulationOptions simulation;
  simulation.period_s = options.period_s;
  simulation.delay_ticks = options.delay_ticks;
  return { std::make_unique<SimulatedDevice>(model, *hand, options.stroke, simulation), "" };
}

std::vector<Kind> kinds()
{
  std::vector<Kind> all{ { "fed", "poses fed by a program: the mouse in a view, a script",
    [](const DeviceOptions&) { return MadeDevice{ std::make_unique<FedDevice>(), "" }; } } };
  for (const DeviceModel& model : deviceModels())
  {
    all.push_back({ model.name, "a simulated hand on " + model.what,
      [&model](const DeviceOptions& options) { return makeSimulated(model, options); } });
  }
  all.push_back({ "replay", "the hand of a recording",
    [](const DeviceOptions& o) { return MadeDevice{ std::make_unique<ReplayDevice>(o.recordingFile), "" }; } });
  return all;
}

} // namespace

std::vector<KnownDevice> knownDevices()
{
  std::vector<KnownDevice> known;
  for (const Kind& kind : kinds())
  {
    known.push_back({ kind.name, kind.what, kind.make({}).device->info(), "" });
  }
  return known;
}

MadeDevice makeDevice(const std::string& name, const DeviceOptions& options)
{
  std::string names;
  for (const Kind& kind : kinds())
  {
    if (name == kind.name)
    {
      return kind.make(options);
    }
    names += (names.empty() ? "" : ", ") + kind.name;
  }
  return { nullptr, "device \"" + name + "\" is not known; known are " + names };
}

} // namespace palpate
