// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidDevice.h"

#include <utility>

namespace palpate
{
namespace
{

constexpr int readTimeout_ms = 10; // so late a write that hangs is noticed at most
constexpr int writerPriority = 19; // just below the servo
constexpr int writerIdle_ms = 1, noDevice_ms = 20;

} // namespace

DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale)
{
  const PidKind kind = pidKind(descriptor);
  const PidInput input(descriptor, kind.sensedAxes);
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = kind.deviceClass;
  info.rendersForce = descriptor.hasCollection(pid::setEffect);
  info.abilities = promised(kind);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.resolution_m = { input.usable() ? input.step() * scale.halfTravel_m : 0.0, false };
  info.maxForce_N = { scale.maxForce_N, false };
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = { scale.springStiffness_N_per_m, false };
    info.heldForce_N = { scale.maxForce_N, false };
  }
  return info;
}

PidDevice::PidDevice(
  const std::string& name, const std::shared_ptr<HidBus>& bus, HidEntry entry, const PidDeviceOptions& options)
  : entry_(std::move(entry)), options_(options),
    link_(options.clock, [bus, at = this->entry_, output = options.output](const Clock& clock)
      { return std::make_shared<PidLink>(bus, at, output, clock); })
{
  const ReportDescriptor descriptor = parseReportDescriptor(bus->descriptor(this->entry_).bytes);
  this->info_ = pidInfo(name, this->entry_, descriptor, options.output.scale);
  this->info_.effectsEndAfter_s = 1e-3 * options.output.duration_ms;
  this->promised_ = this->info_.abilities;
  this->info_.offersWalls = this->promised_.offersWalls();
  this->info_.abilities = this->abilitiesNow();
}

std::string PidDevice::open()
{
  const auto work = [](PidLink& link)
  {
    return ServedLink<PidLink>::Work{ { [&link] { return link.writePass(); }, writerIdle_ms, writerPriority,
                                        [&link] { link.detach(); }, {} },
      { [&link] { return link.readPass(readTimeout_ms); }, noDevice_ms, 0, {}, {} } };
  };
  this->link_->trust(this->options_.output.trust); // a link that hung was replaced
  std::string problem = this->options_.threads ? this->link_.open(work) : this->link_.open({});
  this->info_.offersWalls = this->offered().offersWalls();
  this->info_.abilities = this->abilitiesNow();
  return problem;
}

DeviceStatus PidDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const PidLink::Heard heard = this->link_->heard();
  if (!heard.hand)
  {
    return heard.there ? DeviceStatus::Waiting : DeviceStatus::Lost;
  }
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D.p = heard.hand->p_D;
  sample.buttons = heard.hand->buttons;
  sample.grip = heard.hand->grip;
  return DeviceStatus::Ok;
}

DeviceAbilities PidDevice::abilitiesNow() const
{
  return believed(this->offered(), this->options_.output.trust);
}

void PidDevice::trust(HeldTrust trust) noexcept
{
  this->options_.output.trust = trust;
  this->link_->trust(trust);
  this->info_.abilities = this->abilitiesNow();
}

DeviceAbilities PidDevice::offered() const
{
  return this->link_->abilities().value_or(this->promised_);
}

} // namespace palpate
