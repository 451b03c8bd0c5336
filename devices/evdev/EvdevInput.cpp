// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevInput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{

double shareOf(const input_absinfo& axis) noexcept
{
  const double least = axis.minimum, greatest = axis.maximum;
  return (2.0 * axis.value - least - greatest) / (greatest - least);
}

} // namespace

EvdevInput::EvdevInput(const EvdevKind& kind, EvdevConnection& connection) : kind_(kind), connection_(connection) {}

std::string EvdevInput::begin()
{
  this->ask();
  for (std::size_t i = 0; i < this->kind_.pushes.sensedAxes; ++i)
  {
    if (this->axes_[i].minimum >= this->axes_[i].maximum)
    {
      return "the kernel reports no range for the axis " + std::to_string(this->kind_.axes[i]);
    }
  }
  return {};
}

void EvdevInput::ask() noexcept
{
  for (std::size_t i = 0; i < this->kind_.pushes.sensedAxes; ++i)
  {
    this->axes_[i] = this->connection_.axis(this->kind_.axes[i]).value_or(input_absinfo{});
    this->known_ = this->known_ || this->axes_[i].value != 0;
  }
  this->keys_ = this->connection_.keys();
}

double EvdevInput::step() const noexcept
{
  // The kernel holds back changes smaller than the fuzz.
  const input_absinfo& x = this->axes_[0];
  return 2.0 * std::max(1, x.fuzz) / (static_cast<double>(x.maximum) - x.minimum);
}

bool EvdevInput::take(const input_event& event) noexcept
{
  if (event.type == EV_SYN && event.code == SYN_DROPPED)
  {
    this->dropped_ = true;
  }
  else if (event.type == EV_SYN && event.code == SYN_REPORT)
  {
    if (std::exchange(this->dropped_, false))
    {
      this->ask();
    }
    return true;
  }
  else if (event.type == EV_KEY && event.code < KEY_CNT && !this->dropped_)
  {
    this->keys_.set(event.code, event.value != 0);
  }
  for (std::size_t i = 0; event.type == EV_ABS && !this->dropped_ && i < this->kind_.pushes.sensedAxes; ++i)
  {
    if (event.code == this->kind_.axes[i])
    {
      this->axes_[i].value = event.value;
      this->known_ = true;
    }
  }
  return false;
}

std::uint32_t EvdevInput::buttonsDown() const noexcept
{
  std::uint32_t down = 0;
  for (std::size_t i = 0; i < this->kind_.buttons.size(); ++i)
  {
    down |= static_cast<std::uint32_t>(this->keys_[this->kind_.buttons[i]]) << i;
  }
  return down;
}

std::optional<PidHand> EvdevInput::hand() const noexcept
{
  if (!this->known_)
  {
    return std::nullopt;
  }
  PidHand hand;
  hand.buttons = this->buttonsDown();
  for (std::size_t i = 0; i < this->kind_.pushes.sensedAxes; ++i)
  {
    const double share = shareOf(this->axes_[i]);
    hand.at[i] = std::clamp(share, -1.0, 1.0);
    hand.outOfRange = hand.outOfRange || hand.at[i] != share;
  }
  return hand;
}

} // namespace palpate
