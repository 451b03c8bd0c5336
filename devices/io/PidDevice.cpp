// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidDevice.h"

#include <utility>

namespace palpate
{
namespace
{

constexpr int readTimeout_ms = 100;
constexpr int writerPriority = 19; // just below the servo
constexpr int writerIdle_ms = 1, noDevice_ms = 20;

/// What a detached thread still needs when the device object is gone.
std::shared_ptr<const Clock> clockOf(const PidDeviceOptions& options)
{
  if (options.clock != nullptr)
  {
    return { options.clock, [](const Clock*) {} };
  }
  return std::make_shared<MonotonicClock>();
}

/// A link and the clock it asks.
struct Kept
{
  std::shared_ptr<PidLink> link;
  std::shared_ptr<const Clock> clock;
};

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
  info.abilities = promised(kind);
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.resolution_m = { input.usable() ? input.step() * scale.halfTravel_m : 0.0, false };
  info.maxForce_N = { scale.maxForce_N, false };
  return info;
}

PidDevice::PidDevice(
  const std::string& name, std::shared_ptr<HidBus> bus, HidEntry entry, const PidDeviceOptions& options)
  : bus_(std::move(bus)), entry_(std::move(entry)), options_(options), clock_(clockOf(options)), link_(this->newLink())
{
  const ReportDescriptor descriptor = parseReportDescriptor(this->bus_->descriptor(this->entry_).bytes);
  this->info_ = pidInfo(name, this->entry_, descriptor, options.output.scale);
}

std::shared_ptr<PidLink> PidDevice::newLink() const
{
  return std::make_shared<PidLink>(this->bus_, this->entry_, this->options_.output, *this->clock_);
}

PidDevice::~PidDevice()
{
  this->close();
}

std::string PidDevice::open()
{
  if (this->threads_ != nullptr)
  {
    return {};
  }
  std::string problem = this->link_->attach();
  if (!problem.empty() || !this->options_.threads)
  {
    return problem;
  }
  const auto kept = std::make_shared<Kept>(Kept{ this->link_, this->clock_ });
  PidLink* const link = kept->link.get();
  this->threads_ = std::make_unique<DeviceThreads>();
  this->threads_->run(
    { [link] { return link->writePass(); }, writerIdle_ms, writerPriority, [link] { link->detach(); }, kept });
  this->threads_->run({ [link] { return link->readPass(readTimeout_ms); }, noDevice_ms, 0, {}, kept });
  return {};
}

void PidDevice::close() noexcept
{
  if (this->threads_ == nullptr)
  {
    this->link_->detach();
    return;
  }
  if (!std::exchange(this->threads_, nullptr)->end())
  {
    this->link_ = this->newLink(); // the old one is theirs, whenever they come back
  }
}

DeviceStatus PidDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const std::optional<PidLink::Hand> hand = this->link_->hand();
  if (!hand)
  {
    return DeviceStatus::Lost;
  }
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D.p = hand->p_D;
  sample.buttons = hand->buttons;
  return DeviceStatus::Ok;
}

DeviceAbilities PidDevice::abilitiesNow() const
{
  return this->link_->abilities().value_or(this->info_.abilities);
}

} // namespace palpate
