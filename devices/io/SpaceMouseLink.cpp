// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/SpaceMouseLink.h"

#include <utility>

namespace palpate
{
SpaceMouseLink::SpaceMouseLink(std::shared_ptr<HidBus> bus, HidEntry entry, const Clock& clock)
  : bus_(std::move(bus)), search_(std::move(entry)), clock_(clock)
{
}

std::string SpaceMouseLink::attach()
{
  return this->prepare(this->search_.first(*this->bus_));
}

std::string SpaceMouseLink::prepare(const FoundDevice& found)
{
  if (!found.entry)
  {
    return found.problem;
  }
  auto device = std::make_shared<Attached>();
  if (const std::string problem = this->begin(*found.entry, *device); !problem.empty())
  {
    return "\"" + found.entry->name + "\": " + problem;
  }
  this->search_.found(*this->bus_, *found.entry);
  // A press from before the loss is no longer valid.
  this->news_.cap = {};
  this->newsToServo_.write(this->news_);
  this->held_.hold(std::move(device), [this] { this->presence_.found(); });
  return {};
}

std::string SpaceMouseLink::begin(const HidEntry& entry, Attached& device)
{
  const HidBus::Descriptor read = this->bus_->descriptor(entry);
  if (!read.problem.empty())
  {
    return "the report descriptor of the device cannot be read: " + read.problem;
  }
  device.descriptor = parseReportDescriptor(read.value);
  if (!device.descriptor.problem.empty())
  {
    return device.descriptor.problem;
  }
  device.input.emplace(device.descriptor);
  if (std::string problem = device.input->refusal(); !problem.empty())
  {
    return problem;
  }
  HidBus::Opened opened = this->bus_->open(entry);
  device.connection = std::move(opened.value);
  return device.connection != nullptr ? "" : opened.problem;
}

void SpaceMouseLink::detach() noexcept
{
  this->presence_.left();
  this->held_.letGo();
}

bool SpaceMouseLink::readPass(int timeout_ms)
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    this->reattach(this->clock_.now_ns());
    return false;
  }
  const std::uint64_t before = this->counts_.inputs;
  const int length = takeReports(
    *device->connection, timeout_ms, [&](std::span<const std::uint8_t> report) { this->take(*device, report); });
  this->counts_.rate.count(this->counts_.inputs - before, this->clock_.now_ns());
  if (this->counts_.inputs != before)
  {
    this->newsToServo_.write(this->news_);
  }
  if (length < 0)
  {
    this->held_.letGo(device, "the cable was unplugged", [this] { this->presence_.lost(); });
    this->search_.lost(*this->bus_);
  }
  return length >= 0;
}

void SpaceMouseLink::take(const Attached& device, std::span<const std::uint8_t> report) noexcept
{
  const SpaceMouseInput::Said said = device.input->take(report, this->news_.cap);
  if (said == SpaceMouseInput::Said::Nothing)
  {
    ++this->counts_.strange;
    return;
  }
  ++this->counts_.inputs;
  ++this->news_.reports;
  this->counts_.outOfRange += said == SpaceMouseInput::Said::OutOfRange ? 1 : 0;
}

void SpaceMouseLink::reattach(std::int64_t now_ns)
{
  if (!this->pause_.over(now_ns))
  {
    return;
  }
  if (std::string problem = this->prepare(this->search_.again(*this->bus_)); !problem.empty())
  {
    this->held_.say(std::move(problem));
  }
}

std::optional<SpaceMouseLink::News> SpaceMouseLink::news() noexcept
{
  const bool steady = this->presence_.steady(); // first: a device's news is published before its presence
  const News& newest = this->newsToServo_.read();
  return steady ? std::optional<News>(newest) : std::nullopt;
}

LinkReport SpaceMouseLink::report() const
{
  LinkReport report;
  this->counts_.reportTo(report);
  report.losses = this->presence_.losses();
  this->held_.reportTo(report);
  return report;
}

} // namespace palpate
