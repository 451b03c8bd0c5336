// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/ServiceLine.h"

namespace palpate
{

/// An event is heard before the order that it forbids. A channel that breaks ends the force as an event does: nobody
/// would tell of the next one.
ArmLine::Answer ServiceLine::exchange(const WireOrder& order, int timeout_ms)
{
  constexpr int mostHeard = 64; // a flood is heard further by the next exchange: the hand is not to wait for its end
  int count = 1;
  for (int heard = 0; this->events_ != nullptr && heard < mostHeard; ++heard)
  {
    count = this->events_->receive(this->message_, 0);
    if (count <= 0)
    {
      break;
    }
    const std::string_view message(
      reinterpret_cast<const char*>(this->message_.data()), static_cast<std::size_t>(count));
    if (const std::string event = this->stops_(message); !event.empty())
    {
      this->error_ = "the vendor's service stopped the device: " + event;
      return {};
    }
  }
  if (count < 0)
  {
    this->error_ = "the vendor's service closed its channel of events: " + this->events_->error();
    return {};
  }
  return this->line_->exchange(order, timeout_ms);
}

} // namespace palpate
