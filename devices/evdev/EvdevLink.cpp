// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevLink.h"

#include <array>
#include <span>

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

std::string AttachedEvdev::begin(EvdevBus& bus, const PidOutputOptions& options)
{
  const EvdevTraits traits = bus.traits(this->entry);
  const EvdevKind kind = evdevKind(traits, this->entry);
  if (!kind.pushes.problem.empty())
  {
    return kind.pushes.problem;
  }
  EvdevBus::Opened opened = bus.open(this->entry);
  if (opened.value == nullptr)
  {
    return opened.problem;
  }
  this->connection = std::move(opened.value);
  this->input.emplace(kind, *this->connection);
  this->engine.emplace(*this->connection, traits);
  this->output.emplace(*this->engine, options, kind.pushes);
  std::string problem = this->input->begin();
  problem = problem.empty() ? this->engine->open() : problem;
  return problem.empty() ? this->output->begin() : problem;
}

PidStep AttachedEvdev::step(std::int64_t now_ns, const PidOutput::Wish& wish)
{
  const PidStep caughtUp = this->engine->catchUp();
  return caughtUp == PidStep::Idle ? this->output->step(now_ns, wish) : caughtUp;
}

std::optional<EvdevLink::Hand> EvdevLink::handIn(const EvdevInput& input) noexcept
{
  const std::optional<PidHand> hand = input.hand();
  return hand ? std::optional(this->handOf(*hand)) : std::nullopt;
}

std::optional<EvdevLink::Hand> EvdevLink::firstHand(AttachedEvdev& device)
{
  this->step_ = device.input->step();
  return this->handIn(*device.input);
}

bool EvdevLink::listen(AttachedEvdev& device, int timeout_ms, std::optional<Hand>& newest)
{
  return takeEvents(*device.connection, timeout_ms,
    [&](const input_event& event)
    {
      if (device.input->take(event))
      {
        newest = this->handIn(*device.input);
        ++this->counts_.inputs;
      }
    });
}

void EvdevLink::unplugged(const std::shared_ptr<AttachedEvdev>& device)
{
  static_cast<void>(this->lose(device, "the cable was unplugged"));
}

void EvdevLink::giveUp(const std::shared_ptr<AttachedEvdev>& device, std::int64_t /*since_ns*/, const std::string& why)
{
  static_cast<void>(this->lose(device, why));
  device->engine->close();
}

} // namespace palpate
