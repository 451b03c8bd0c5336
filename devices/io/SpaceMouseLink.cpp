// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/SpaceMouseLink.h"

#include <array>
#include <utility>

#include "devices/hid/InputReport.h"
#include "devices/io/FindAgain.h"

namespace palpate
{
namespace
{

constexpr std::int64_t tryAgainAfter_ns = 500000000;
constexpr int mostQueued = 256; ///< more reports than any system keeps

} // namespace

SpaceMouseLink::SpaceMouseLink(std::shared_ptr<HidBus> bus, HidEntry entry, const Clock& clock)
  : bus_(std::move(bus)), entry_(std::move(entry)), clock_(clock)
{
}

std::string SpaceMouseLink::attach()
{
  FoundDevice found = findAgain(*this->bus_, this->entry_);
  if (!found.entry)
  {
    return found.problem;
  }
  auto device = std::make_shared<Attached>();
  if (const std::string problem = this->begin(*found.entry, *device); !problem.empty())
  {
    return "\"" + found.entry->name + "\": " + problem;
  }
  // Whatever it was pressed to before says nothing now.
  this->news_.cap = {};
  this->newsToServo_.write(this->news_);
  const std::lock_guard lock(this->mutex_);
  this->attached_ = std::move(device);
  this->presence_.found();
  return {};
}

std::string SpaceMouseLink::begin(const HidEntry& entry, Attached& device)
{
  const HidBus::Descriptor read = this->bus_->descriptor(entry);
  if (!read.problem.empty())
  {
    return "its report descriptor cannot be read: " + read.problem;
  }
  device.descriptor = parseReportDescriptor(read.bytes);
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
  device.connection = std::move(opened.connection);
  return device.connection != nullptr ? "" : opened.problem;
}

void SpaceMouseLink::detach() noexcept
{
  this->presence_.left();
  const std::lock_guard lock(this->mutex_);
  this->attached_.reset();
}

std::shared_ptr<SpaceMouseLink::Attached> SpaceMouseLink::attached() const
{
  const std::lock_guard lock(this->mutex_);
  return this->attached_;
}

void SpaceMouseLink::lose(const std::string& why)
{
  this->presence_.lost();
  const std::lock_guard lock(this->mutex_);
  this->message_ = why;
  this->attached_.reset();
}

bool SpaceMouseLink::readPass(int timeout_ms)
{
  const std::shared_ptr<Attached> device = this->attached();
  if (device == nullptr)
  {
    this->reattach(this->clock_.now_ns());
    return false;
  }
  std::array<std::uint8_t, InputReport::longest> report;
  const std::uint64_t before = this->inputs_;
  int length = device->connection->read(report, timeout_ms);
  for (int i = 0; length > 0 && i < mostQueued; ++i)
  {
    this->take(*device, { report.data(), static_cast<std::size_t>(length) });
    length = device->connection->read(report, 0);
  }
  this->rate_.count(this->inputs_ - before, this->clock_.now_ns());
  if (this->inputs_ != before)
  {
    this->newsToServo_.write(this->news_);
  }
  if (length < 0)
  {
    this->lose("it was unplugged");
  }
  return length >= 0;
}

void SpaceMouseLink::take(const Attached& device, std::span<const std::uint8_t> report) noexcept
{
  const SpaceMouseInput::Said said = device.input->take(report, this->news_.cap);
  if (said == SpaceMouseInput::Said::Nothing)
  {
    ++this->strange_;
    return;
  }
  ++this->inputs_;
  ++this->news_.reports;
  this->outOfRange_ += said == SpaceMouseInput::Said::OutOfRange ? 1 : 0;
}

void SpaceMouseLink::reattach(std::int64_t now_ns)
{
  if (this->triedAt_ns_ != 0 && now_ns - this->triedAt_ns_ < tryAgainAfter_ns)
  {
    return;
  }
  this->triedAt_ns_ = now_ns;
  if (std::string problem = this->attach(); !problem.empty())
  {
    const std::lock_guard lock(this->mutex_);
    this->message_ = std::move(problem);
  }
}

std::optional<SpaceMouseLink::News> SpaceMouseLink::news() noexcept
{
  const News& newest = this->newsToServo_.read();
  return this->presence_.steady() ? std::optional<News>(newest) : std::nullopt;
}

LinkReport SpaceMouseLink::report() const
{
  LinkReport report;
  report.inputs = this->inputs_;
  report.strange = this->strange_;
  report.outOfRange = this->outOfRange_;
  report.losses = this->presence_.losses();
  report.inputRate_Hz = this->rate_.rate_Hz();
  const std::lock_guard lock(this->mutex_);
  report.attached = this->attached_ != nullptr;
  report.message = this->message_;
  return report;
}

} // namespace palpate
