// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevLink.h"
#include "devices/common/LinkNotes.h"

#include <array>
#include <utility>

#include "devices/evdev/EvdevKind.h"

namespace palpate
{
namespace
{

/// Hands each event that waits to take(event); for the first one it waits up to `timeout_ms`. False: the device is
/// gone.
template<class Take>
bool takeEvents(EvdevConnection& connection, int timeout_ms, Take take)
{
  constexpr int mostReads = 16; // more events than the kernel keeps
  std::array<input_event, 64> events;
  int count = connection.read(events, timeout_ms);
  for (int i = 0; count > 0 && i < mostReads; ++i)
  {
    for (const input_event& event : std::span(events).first(static_cast<std::size_t>(count)))
    {
      take(event);
    }
    count = connection.read(events, 0);
  }
  return count >= 0;
}

} // namespace

EvdevLink::EvdevLink(std::shared_ptr<EvdevBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
  : bus_(std::move(bus)), search_(std::move(entry)), options_(options), clock_(clock), exchange_(options.trust)
{
}

std::string EvdevLink::attach()
{
  std::string problem = this->prepare(this->search_.first(*this->bus_), {});
  this->opened_ = this->found().value_or(Found{}).abilities;
  return problem;
}

/// Whoever steers by what the device held goes on as if it held it.
std::string EvdevLink::prepare(FoundDevice found, const DeviceAbilities& least)
{
  if (!found.entry)
  {
    return found.problem;
  }
  auto device = std::make_shared<Attached>();
  device->entry = std::move(*found.entry);
  std::string problem = device->begin(*this->bus_, this->options_);
  if (problem.empty() && least.offersWalls() && !device->output->abilities().offersWalls())
  {
    device->engine->close();
    problem = "it came back without its walls: its memory for effects may be full";
  }
  if (!problem.empty())
  {
    return "\"" + device->entry.name + "\": " + problem;
  }
  this->search_.found(*this->bus_, device->entry);
  {
    const std::lock_guard lock(this->foundMutex_);
    this->found_ = Found{ device->output->abilities(), device->input->step() };
  }
  const std::optional<Hand> hand = this->handOf(*device->input);
  const auto sayFound = [this, &hand]
  {
    this->exchange_.tell(hand);
    this->exchange_.presence.found();
  };
  this->held_.hold(std::move(device), sayFound);
  return {};
}

std::string EvdevLink::Attached::begin(EvdevBus& bus, const PidOutputOptions& options)
{
  const EvdevTraits traits = bus.traits(this->entry);
  const EvdevKind kind = evdevKind(traits, this->entry);
  if (!kind.pushes.problem.empty())
  {
    return kind.pushes.problem;
  }
  EvdevBus::Opened opened = bus.open(this->entry);
  if (opened.connection == nullptr)
  {
    return opened.problem;
  }
  this->connection = std::move(opened.connection);
  this->input.emplace(kind, *this->connection);
  this->engine.emplace(*this->connection, traits);
  this->output.emplace(*this->engine, options, kind.pushes);
  std::string problem = this->input->begin();
  problem = problem.empty() ? this->engine->open() : problem;
  return problem.empty() ? this->output->begin() : problem;
}

std::optional<EvdevLink::Hand> EvdevLink::handOf(const EvdevInput& input) noexcept
{
  const std::optional<PidHand> hand = input.hand();
  if (!hand)
  {
    return std::nullopt;
  }
  this->counts_.outOfRange += hand->outOfRange ? 1 : 0;
  const PidScale& scale = this->options_.scale;
  return Hand{ { scale.toMetres(0, hand->at[0]), scale.toMetres(1, hand->at[1]), 0.0 }, hand->buttons };
}

void EvdevLink::detach() noexcept
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device != nullptr)
  {
    device->engine->close();
  }
  this->exchange_.presence.left();
  this->held_.letGo();
}

void EvdevLink::lose(const std::shared_ptr<Attached>& device, const std::string& why)
{
  static_cast<void>(this->held_.letGo(device, why, [this] { this->exchange_.presence.lost(); }));
}

bool EvdevLink::readPass(int timeout_ms)
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    return false;
  }
  std::optional<Hand> newest;
  const std::uint64_t before = this->counts_.inputs;
  const bool there = takeEvents(*device->connection, timeout_ms,
    [&](const input_event& event)
    {
      if (device->input->take(event))
      {
        newest = this->handOf(*device->input);
        ++this->counts_.inputs;
      }
    });
  this->counts_.rate.count(this->counts_.inputs - before, this->clock_.now_ns());
  if (newest)
  {
    this->held_.with(device, [&] { this->exchange_.tell(newest); });
  }
  this->watchWriter();
  if (!there)
  {
    this->lose(device, "it was unplugged");
  }
  return there;
}

void EvdevLink::watchWriter()
{
  if (this->writer_.hasStalled(this->clock_.now_ns()))
  {
    this->exchange_.presence.stalled();
  }
}

bool EvdevLink::writePass()
{
  const std::int64_t now_ns = this->clock_.now_ns();
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    this->reattach(now_ns);
    return false;
  }
  const std::uint64_t restarts = device->output->restarts();
  this->writer_.begins(now_ns);
  const PidStep step = this->giveNext(*device, now_ns);
  this->writer_.ends();
  if (step == PidStep::Failed)
  {
    const std::string why = describeFailedWrite(device->connection->error());
    this->lose(device, why);
    device->engine->close();
  }
  this->counts_.outputs += step == PidStep::Sent ? 1 : 0;
  this->counts_.restarts += device->output->restarts() - restarts;
  return step == PidStep::Sent;
}

PidStep EvdevLink::giveNext(Attached& device, std::int64_t now_ns)
{
  const PidOutput::Wish wish = this->exchange_.wish();
  const PidStep caughtUp = device.engine->catchUp();
  return caughtUp == PidStep::Idle ? device.output->step(now_ns, wish) : caughtUp;
}

/// What is there is noted before anything is waited for: soon the lost device may be back in another place.
void EvdevLink::reattach(std::int64_t now_ns)
{
  this->search_.lost(*this->bus_);
  if (!this->pause_.over(now_ns))
  {
    return;
  }
  this->exchange_.mute();
  if (std::string problem = this->prepare(this->search_.again(*this->bus_), this->opened_); !problem.empty())
  {
    this->held_.say(std::move(problem));
  }
}

LinkReport EvdevLink::report() const
{
  LinkReport report;
  this->counts_.reportTo(report);
  report.stalls = this->writer_.stalls();
  report.losses = this->exchange_.presence.losses();
  this->held_.reportTo(report);
  if (report.attached && !this->exchange_.handKnown())
  {
    report.message = "it has not said yet where the hand is: move it";
  }
  return report;
}

std::optional<EvdevLink::Found> EvdevLink::found() const
{
  const std::lock_guard lock(this->foundMutex_);
  return this->found_;
}

std::optional<DeviceAbilities> EvdevLink::abilities() const
{
  const std::optional<Found> found = this->found();
  return found ? std::optional(found->abilities) : std::nullopt;
}

} // namespace palpate
