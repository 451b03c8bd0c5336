// SPDX-License-Identifier: GPL-3.0-or-later
// Row 90: load of a link of 31,250 baud and 10 bits a byte to a joystick, where a force is two parameters and four wall
// places are four, of six bytes each.
#include <algorithm>
#include <cmath>
#include <string>

#include "devices/simulated/SerialLink.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/DeviceWalls.h"
#include "haptics/session/DeviceAdaptation.h"
#include "testing/lab/Experiments.h"
#include "testing/support/PlainJoystick.h"

namespace palpate::lab
{
namespace link_budget_experiment
{

constexpr double bytes_per_s = 31250.0 / 10.0;
constexpr double time_s = 10.0;

/// Another force, or other places of four walls, with each update.
struct Message
{
  const char* what;
  double bytes;
  DeviceCommand (*at)(int update);
};

DeviceCommand forceAt(int update)
{
  DeviceCommand command;
  command.wrench_D.force.x() = 1e-4 * (update + 1);
  return command;
}

DeviceCommand wallsAt(int update)
{
  AxisWalls walls;
  walls.offset_m.fill(-1e-3 - 1e-7 * update);
  DeviceCommand held;
  command(walls, 200.0, held);
  return held;
}

constexpr Message messages[] = { { "a force", 12.0, forceAt }, { "four wall places", 24.0, wallsAt } };

/// Commands that a host got through in that time.
struct Carried
{
  int updates = 0;
  double bytes = 0.0;
};

Carried carry(const Message& message, double host_Hz)
{
  SerialLink link(bytes_per_s);
  DeviceCommand before = message.at(0);
  const int ticks = static_cast<int>(time_s * 1000.0), every = static_cast<int>(std::lround(1000.0 / host_Hz));
  static_cast<void>(link.carry(before, -1.0)); // the first has arrived long before
  Carried carried;
  for (int tick = 0; tick <= ticks; ++tick)
  {
    const DeviceCommand& there = link.carry(message.at(tick / every + 1), 1e-3 * tick);
    const double bytes = SerialLink::bytesBetween(before, there);
    if (bytes > 0.0)
    {
      ++carried.updates;
      carried.bytes += bytes;
      before = there;
    }
  }
  return carried;
}

void judgeRate(const Message& message, double host_Hz, Table& table)
{
  const std::string name = caseName({ { "host", host_Hz } });
  const Carried carried = carry(message, host_Hz);
  const double truth_per_s = std::min(host_Hz, bytes_per_s / message.bytes);
  table.within({ name, message.what, "updates", "1/s" }, carried.updates / time_s, truth_per_s, 0.01 * truth_per_s);
  const double share = truth_per_s * message.bytes / bytes_per_s;
  table.within({ name, message.what, "share of the link" }, carried.bytes / time_s / bytes_per_s, share, 0.01 * share);
}

/// The same through the device: a force that grows with each tick, read off the acceleration of its mass.
void judgeDevice(Table& table)
{
  DeviceModel model = test::plainJoystick(0.0);
  model.travel_m = DeviceModel::unlimited;
  model.link_B_per_s = bytes_per_s;
  SimulatedDevice device(model, *handModel("none"), { { Vec3::Zero() } });
  static_cast<void>(device.open());
  DeviceSample sample;
  double speed_m_per_s = 0.0, force_N = 0.0;
  int changes = 0;
  const int ticks = 4000;
  for (int tick = 1; tick <= ticks; ++tick)
  {
    device.write(forceAt(tick));
    static_cast<void>(device.read(1e-3 * tick, sample));
    const double now_N = model.mass_kg * (device.speed_D().x() - speed_m_per_s) / 1e-3;
    changes += std::fabs(now_N - force_N) > 1e-6 ? 1 : 0;
    speed_m_per_s = device.speed_D().x();
    force_N = now_N;
  }
  const double truth_per_s = bytes_per_s / 12.0;
  table.within({ "host=1000", "a force, felt at the handle", "updates", "1/s" }, changes / (1e-3 * ticks), truth_per_s,
    0.01 * truth_per_s);
}

/// The session's adaptation to it: walls no more often than they are carried, stiffness for the rate of the link.
void judgeSession(Table& table)
{
  DeviceInfo info = infoOf(*deviceModel("simulated-serial-joystick"));
  HapticParameters parameters;
  parameters.walls.every_s = 1e-3;
  const HapticParameters adapted = adaptToDevice(parameters, info, {});
  table.within({ "link=3125", "session", "time between two updates of walls", "s" }, adapted.walls.every_s,
    24.0 / bytes_per_s, 1e-12);
  info.maxStiffness_N_per_m.value = DeviceModel::unlimited;
  LoopSettings loop = loopSettings(parameters, 1e-3);
  loop.passivity.enabled = false;
  const double linked = stabilityLimits(info, loop).stable_N_per_m;
  info.forceUpdate_s.value = 0.0;
  loop.period_s = 12.0 / bytes_per_s;
  loop.passivity.delay_ticks = 1.0;
  const double slow = stabilityLimits(info, loop).stable_N_per_m;
  table.within({ "link=3125", "session", "stiffness over that of a loop of 260 Hz with a tick of delay" },
    linked / slow, 1.0, 1e-9);
}

} // namespace link_budget_experiment

void runLinkBudget(const Conditions&, Table& table)
{
  using namespace link_budget_experiment;
  table.within({ "link=3125", "one parameter", "time", "s" }, SerialLink::parameter_B / bytes_per_s, 1.92e-3, 1e-12);
  for (const Message& message : messages)
  {
    const double bytes = SerialLink::bytesBetween(message.at(0), message.at(1));
    table.within({ "link=3125", message.what, "size", "B" }, bytes, message.bytes, 0.0);
    for (const double host_Hz : { 20.0, 50.0, 100.0, 125.0, 200.0, 250.0, 500.0, 1000.0 })
    {
      judgeRate(message, host_Hz, table);
    }
  }
  judgeDevice(table);
  judgeSession(table);
}

} // namespace palpate::lab
