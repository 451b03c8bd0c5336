// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevDevice.h"

#include "devices/evdev/EvdevKind.h"

namespace palpate
{
namespace
{

constexpr int readTimeout_ms = 10; // so late a driver that hangs is noticed at most
constexpr int writerPriority = 19; // just below the servo
constexpr int writerIdle_ms = 1, noDevice_ms = 20;

DeviceInfo infoOf(const std::string& name, const HidEntry& entry, const EvdevKind& kind, const PidScale& scale)
{
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = kind.pushes.deviceClass;
  info.rendersForce = kind.pushes.pushedAxes > 0;
  info.abilities = promised(kind.pushes);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.maxForce_N = { scale.maxForce_N, false };
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = { scale.springStiffness_N_per_m, false };
    info.heldForce_N = { scale.maxForce_N, false };
  }
  return info;
}

} // namespace

EvdevDevice::EvdevDevice(
  const std::string& name, const std::shared_ptr<EvdevBus>& bus, HidEntry entry, const PidDeviceOptions& options)
  : info_(infoOf(name, entry, evdevKind(bus->traits(entry), entry), options.output.scale)), options_(options),
    link_(options.clock, [bus, entry, output = options.output](const Clock& clock)
      { return std::make_shared<EvdevLink>(bus, entry, output, clock); })
{
  this->info_.effectsEndAfter_s = 1e-3 * options.output.duration_ms;
  this->promised_ = this->info_.abilities;
  this->believe();
}

std::string EvdevDevice::open()
{
  const auto work = [](EvdevLink& link)
  {
    return ServedLink<EvdevLink>::Work{ { [&link] { return link.writePass(); }, writerIdle_ms, writerPriority,
                                          [&link] { link.detach(); }, {} },
      { [&link] { return link.readPass(readTimeout_ms); }, noDevice_ms, 0, {}, {} } };
  };
  this->link_->trust(this->options_.output.trust); // a link that hung was replaced
  std::string problem = this->options_.threads ? this->link_.open(work) : this->link_.open({});
  if (const std::optional<EvdevLink::Found> found = this->link_->found())
  {
    this->info_.resolution_m = { found->step * this->options_.output.scale.halfTravel_m, false };
  }
  this->believe();
  return problem;
}

DeviceStatus EvdevDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const EvdevLink::Heard heard = this->link_->heard();
  if (!heard.hand)
  {
    return heard.there ? DeviceStatus::Waiting : DeviceStatus::Lost;
  }
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D.p = heard.hand->p_D;
  sample.buttons = heard.hand->buttons;
  return DeviceStatus::Ok;
}

DeviceAbilities EvdevDevice::abilitiesNow() const
{
  return believed(this->offered(), this->options_.output.trust);
}

DeviceAbilities EvdevDevice::offered() const
{
  const std::optional<EvdevLink::Found> found = this->link_->found();
  return found ? found->abilities : this->promised_;
}

void EvdevDevice::trust(HeldTrust trust) noexcept
{
  this->options_.output.trust = trust;
  this->link_->trust(trust);
  this->believe();
}

void EvdevDevice::believe()
{
  this->info_.offersWalls = this->offered().offersWalls();
  this->info_.abilities = this->abilitiesNow();
}

} // namespace palpate
