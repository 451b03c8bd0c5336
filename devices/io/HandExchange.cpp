// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/HandExchange.h"

namespace palpate
{

void HandExchange::tell(const std::optional<Hand>& hand) noexcept
{
  this->handToServo_.write(hand);
  this->handToWriter_.write(hand);
  this->handKnown_ = hand.has_value();
}

HandExchange::Heard HandExchange::heard() noexcept
{
  const bool steady = this->presence.steady(); // first: a device's hand is published before its presence
  const std::optional<Hand>& newest = this->handToServo_.read();
  return steady ? Heard{ true, newest } : Heard{};
}

void HandExchange::command(const DeviceCommand& command) noexcept
{
  this->commands_.write(command);
  this->beat_.store(this->beat_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

/// The counter is read first: a command newer than its counter counts as late, never the other way round.
PidOutput::Wish HandExchange::wish() noexcept
{
  const std::uint64_t beat = this->beat_.load(std::memory_order_acquire);
  const DeviceCommand& newest = this->commands_.read();
  this->muted_ = this->muted_ && (asksForForce(newest) || newest.wrench_D.torque != Vec3::Zero());
  const std::optional<Hand>& hand = this->handToWriter_.read();
  return { this->muted_ || !hand ? DeviceCommand{} : newest, beat, hand.value_or(Hand{}).p_D, this->trust_ };
}

} // namespace palpate
