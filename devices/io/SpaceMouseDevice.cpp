// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/SpaceMouseDevice.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{

constexpr int readTimeout_ms = 100;
constexpr int noDevice_ms = 20;
constexpr double forgetAfter_s = 0.1; ///< a pressed cap sends a report every 8 or 16 ms
constexpr double longestTick_s = 0.02;

} // namespace

SpaceMouseDevice::SpaceMouseDevice(
  const std::string& name, const std::shared_ptr<HidBus>& bus, HidEntry entry, const SpaceMouseOptions& options)
  : entry_(std::move(entry)), options_(options), link_(options.clock, [bus, at = this->entry_](const Clock& clock)
                                                   { return std::make_shared<SpaceMouseLink>(bus, at, clock); }),
    motion_(options.motion)
{
  this->info_.name = name;
  this->info_.serial = this->entry_.serial;
  this->info_.deviceClass = DeviceClass::Rigid6D;
  this->info_.rendersForce = false;
  this->info_.abilities.sensedAxes = 6;
  this->info_.workspaceRadius_m = { options.motion.radius_m, true }; // a choice of this program, therefore known
}

std::string SpaceMouseDevice::open()
{
  const auto work = [](SpaceMouseLink& link)
  {
    return ServedLink<SpaceMouseLink>::Work{ { [&link] { return link.readPass(readTimeout_ms); }, noDevice_ms, 0,
      [&link] { link.detach(); }, {} } };
  };
  return this->options_.threads ? this->link_.open(work) : this->link_.open({});
}

/// A cap that sends no more reports counts as released: the motion must end when a radio link breaks.
Cap SpaceMouseDevice::heard(double tickTime_s, const SpaceMouseLink::News& news) noexcept
{
  if (news.reports != this->heardOf_)
  {
    this->heardOf_ = news.reports;
    this->heardAt_s_ = tickTime_s;
  }
  Cap cap = news.cap;
  if (tickTime_s - this->heardAt_s_ > forgetAfter_s)
  {
    cap.at = {};
  }
  return cap;
}

DeviceStatus SpaceMouseDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const double dt_s = this->lastTick_s_ == never ? 0.0 : std::clamp(tickTime_s - this->lastTick_s_, 0.0, longestTick_s);
  this->lastTick_s_ = tickTime_s;
  const std::optional<SpaceMouseLink::News> news = this->link_->news();
  if (!news)
  {
    return DeviceStatus::Lost;
  }
  const Cap cap = this->heard(tickTime_s, *news);
  this->motion_.step(cap, dt_s);
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D = this->motion_.pose_D();
  sample.velocity_D = this->motion_.velocity_D();
  sample.buttons = cap.buttons;
  return DeviceStatus::Ok;
}

} // namespace palpate
