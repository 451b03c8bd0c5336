// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidLink.h"

#include <array>
#include <utility>

namespace palpate
{
namespace
{

constexpr std::int64_t perMs_ns = 1000000;
constexpr std::int64_t stuckAfter_ns = 50 * perMs_ns;
constexpr std::int64_t tryAgainAfter_ns = 500 * perMs_ns;
constexpr std::int64_t frozenAfter_ns = 250 * perMs_ns;
constexpr double frozenAbove = 0.2; ///< of the largest force
constexpr int mostQueued = 256;     ///< more reports than any system keeps
constexpr std::size_t longestReport = 2049;

bool atRest(const DeviceCommand& command) noexcept
{
  return command.wallCount == 0 && command.viscosity_Ns_per_m == 0.0 && command.wrench_D.force == Vec3::Zero();
}

bool sameKind(const HidEntry& a, const HidEntry& b) noexcept
{
  return a.vendor == b.vendor && a.product == b.product && a.serial == b.serial;
}

} // namespace

FoundDevice findAgain(HidBus& bus, const HidEntry& wanted)
{
  std::vector<HidEntry> alike;
  for (HidEntry& entry : bus.devices())
  {
    if (sameKind(entry, wanted))
    {
      alike.push_back(std::move(entry));
    }
  }
  const std::string name = "\"" + wanted.name + "\"" + (wanted.serial.empty() ? "" : " " + wanted.serial);
  if (alike.empty())
  {
    return { std::nullopt, name + " is not there: plug it in" };
  }
  for (const HidEntry& entry : alike)
  {
    if (alike.size() == 1 || entry.path == wanted.path)
    {
      return { entry, {} };
    }
  }
  return { std::nullopt,
    "there are " + std::to_string(alike.size()) + " of " + name + " and nothing tells them apart: plug in only one" };
}

PidLink::PidLink(std::shared_ptr<HidBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
  : bus_(std::move(bus)), entry_(std::move(entry)), options_(options), clock_(clock)
{
}

std::string PidLink::attach()
{
  FoundDevice found = findAgain(*this->bus_, this->entry_);
  if (!found.entry)
  {
    return found.problem;
  }
  auto device = std::make_shared<Attached>();
  device->entry = std::move(*found.entry);
  if (std::string problem = device->begin(*this->bus_, this->options_); !problem.empty())
  {
    return "\"" + device->entry.name + "\": " + problem;
  }
  device->drain();
  this->actuatorsOff_ = false;
  this->stoppedBlock_ = 0;
  const std::lock_guard lock(this->mutex_);
  this->shortcomings_ = device->output->shortcomings();
  this->attached_ = std::move(device);
  this->live_ = true;
  return {};
}

std::string PidLink::Attached::begin(HidBus& bus, const PidOutputOptions& options)
{
  const HidBus::Descriptor read = bus.descriptor(this->entry);
  if (!read.problem.empty())
  {
    return "its report descriptor cannot be read: " + read.problem;
  }
  this->descriptor = parseReportDescriptor(read.bytes);
  std::string problem = PidEngine::refusal(this->descriptor);
  if (!problem.empty())
  {
    return problem;
  }
  this->input.emplace(this->descriptor);
  if (!this->input->usable())
  {
    return "it has no axis that tells where the hand is";
  }
  HidBus::Opened opened = bus.open(this->entry);
  if (opened.connection == nullptr)
  {
    return opened.problem;
  }
  this->connection = std::move(opened.connection);
  this->engine.emplace(*this->connection, this->descriptor);
  this->output.emplace(*this->engine, options, this->input->hasTwoAxes() ? 2U : 1U);
  problem = this->engine->open();
  return problem.empty() ? this->output->begin() : problem;
}

void PidLink::Attached::drain() const noexcept
{
  std::array<std::uint8_t, longestReport> report;
  for (int i = 0; i<mostQueued&& this->connection->read(report, 0)> 0; ++i)
  {
  }
}

void PidLink::detach() noexcept
{
  const std::shared_ptr<Attached> device = this->attached();
  if (device != nullptr)
  {
    device->engine->close();
  }
  this->live_ = false;
  const std::lock_guard lock(this->mutex_);
  this->attached_.reset();
}

std::shared_ptr<PidLink::Attached> PidLink::attached() const
{
  const std::lock_guard lock(this->mutex_);
  return this->attached_;
}

void PidLink::lose(const std::string& why)
{
  this->live_ = false;
  ++this->losses_;
  const std::lock_guard lock(this->mutex_);
  this->message_ = why;
  this->attached_.reset();
}

bool PidLink::readPass(int timeout_ms)
{
  const std::shared_ptr<Attached> device = this->attached();
  if (device == nullptr)
  {
    return false;
  }
  std::array<std::uint8_t, longestReport> report;
  std::optional<Hand> newest;
  int length = device->connection->read(report, timeout_ms);
  for (int i = 0; length > 0 && i < mostQueued; ++i)
  {
    this->take(*device, { report.data(), static_cast<std::size_t>(length) }, newest);
    length = device->connection->read(report, 0);
  }
  if (newest)
  {
    this->handToServo_.write(*newest);
    this->handToWriter_.write(*newest);
  }
  if (length < 0)
  {
    this->lose("it was unplugged");
    return false;
  }
  this->watchWriter(*device);
  return true;
}

void PidLink::take(const Attached& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest)
{
  if (const std::optional<PidHand> hand = device.input->hand(report))
  {
    const PidScale& scale = this->options_.scale;
    newest = Hand{ { scale.toMetres(0, hand->at[0]), scale.toMetres(1, hand->at[1]), 0.0 }, hand->buttons };
    ++this->inputs_;
    this->outOfRange_ += hand->outOfRange ? 1 : 0;
    return;
  }
  const std::optional<PidState> state = device.engine->state(report);
  if (!state)
  {
    ++this->strange_;
    return;
  }
  if (!state->actuatorsEnabled)
  {
    this->actuatorsOff_ = true;
  }
  if (!state->playing && state->block > 0)
  {
    this->stoppedBlock_ = state->block;
  }
}

/// A write that hangs cannot be called back; a second way to the device may still work.
void PidLink::watchWriter(const Attached& device)
{
  const std::int64_t since_ns = this->writingSince_ns_;
  const bool stuck = since_ns != notWriting && this->clock_.now_ns() - since_ns > stuckAfter_ns;
  if (stuck && !this->writerStuck_)
  {
    ++this->losses_;
    HidBus::Opened second = this->bus_->open(device.entry);
    if (second.connection != nullptr)
    {
      static_cast<void>(PidEngine(*second.connection, device.descriptor).control(pid::stopAll));
    }
  }
  this->writerStuck_ = stuck;
}

bool PidLink::writePass()
{
  const std::int64_t now_ns = this->clock_.now_ns();
  const std::shared_ptr<Attached> device = this->attached();
  if (device == nullptr)
  {
    this->reattach(now_ns);
    return false;
  }
  if (this->disturbed(*device->output))
  {
    this->lose("another program or a switch on it took its forces away");
    return true;
  }
  const Outgoing& newest = this->commands_.read();
  this->muted_ = this->muted_ && !atRest(newest.command);
  const PidOutput::Wish wish{ this->muted_ ? DeviceCommand{} : newest.command, newest.beat,
    this->handToWriter_.read().p_D };
  this->watchHand(now_ns, wish);
  this->writingSince_ns_ = now_ns;
  const PidOutput::Step step = device->output->step(now_ns, wish);
  this->writingSince_ns_ = notWriting;
  if (step == PidOutput::Step::Failed)
  {
    this->lose("it does not take forces: " + device->connection->error());
  }
  return step == PidOutput::Step::Sent;
}

bool PidLink::disturbed(const PidOutput& output) noexcept
{
  const int stopped = this->stoppedBlock_.exchange(0);
  return this->actuatorsOff_.exchange(false) || output.plays(stopped);
}

void PidLink::reattach(std::int64_t now_ns)
{
  if (this->triedAt_ns_ != 0 && now_ns - this->triedAt_ns_ < tryAgainAfter_ns)
  {
    return;
  }
  this->triedAt_ns_ = now_ns;
  this->muted_ = true;
  if (std::string problem = this->attach(); !problem.empty())
  {
    const std::lock_guard lock(this->mutex_);
    this->message_ = std::move(problem);
  }
}

void PidLink::watchHand(std::int64_t now_ns, const PidOutput::Wish& wish) noexcept
{
  const bool pushed = wish.command.wrench_D.force.norm() > frozenAbove * this->options_.scale.maxForce_N;
  if (!pushed || wish.p_D != this->stillAt_D_)
  {
    this->stillAt_D_ = wish.p_D;
    this->stillSince_ns_ = now_ns;
  }
  this->frozen_ = now_ns - this->stillSince_ns_ > frozenAfter_ns;
}

std::optional<PidLink::Hand> PidLink::hand() noexcept
{
  const Hand& newest = this->handToServo_.read();
  const std::uint64_t losses = this->losses_.load(std::memory_order_acquire);
  const bool lost = losses != this->seenLosses_ || !this->live_.load(std::memory_order_acquire);
  this->seenLosses_ = losses;
  return lost ? std::nullopt : std::optional<Hand>(newest);
}

void PidLink::command(const DeviceCommand& command) noexcept
{
  this->commands_.write({ command, ++this->beat_ });
}

LinkReport PidLink::report() const
{
  const std::lock_guard lock(this->mutex_);
  return { this->inputs_, this->strange_, this->outOfRange_, this->losses_, this->attached_ != nullptr, this->frozen_,
    this->message_ };
}

std::string PidLink::shortcomings() const
{
  const std::lock_guard lock(this->mutex_);
  return this->shortcomings_;
}

} // namespace palpate
