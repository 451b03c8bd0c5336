// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/VirtualBody.h"

#include <utility>

namespace palpate
{
namespace
{

constexpr double rounding_s = 1e-9; // of times that are sums of ticks

} // namespace

std::shared_ptr<const PressedBody> VirtualBody::press(double time_s, const BodyHand& hand)
{
  constexpr double betweenLooks_s = 1.0 / 30.0; // a shape takes as long as a snapshot; a session has as many at most
  auto pressed = this->maker_.press(hand, this->period_s_);
  if (time_s >= this->nextLook_s_ - rounding_s)
  {
    this->maker_.lookThrough();
    this->nextLook_s_ = time_s + betweenLooks_s;
  }
  return pressed;
}

const PressedBody* VirtualBody::at(double time_s, const BodyHand& hand)
{
  this->before_.reset();
  if (!this->now_)
  {
    this->now_ = this->press(time_s, hand);
    this->due_s_ = time_s;
  }
  if (time_s >= this->due_s_ - rounding_s)
  {
    this->before_ = this->underWay_ ? std::exchange(this->now_, std::move(this->underWay_)) : nullptr;
    this->underWay_ = this->press(time_s, hand);
    this->due_s_ += this->period_s_;
  }
  return this->now_.get();
}

} // namespace palpate
