// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/VirtualBody.h"

#include <utility>

namespace palpate
{

std::shared_ptr<const PressedBody> VirtualBody::press(const BodyHand& hand)
{
  auto pressed = this->maker_.press(hand, this->period_s_);
  this->maker_.lookThrough();
  return pressed;
}

const PressedBody* VirtualBody::at(double time_s, const BodyHand& hand)
{
  constexpr double rounding_s = 1e-9; // of times that are sums of ticks
  this->before_.reset();
  if (!this->now_)
  {
    this->now_ = this->press(hand);
    this->due_s_ = time_s;
  }
  if (time_s >= this->due_s_ - rounding_s)
  {
    this->before_ = this->underWay_ ? std::exchange(this->now_, std::move(this->underWay_)) : nullptr;
    this->underWay_ = this->press(hand);
    this->due_s_ += this->period_s_;
  }
  return this->now_.get();
}

} // namespace palpate
