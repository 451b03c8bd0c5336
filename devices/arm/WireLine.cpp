// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/WireLine.h"

#include <chrono>
#include <utility>
namespace palpate
{
namespace
{

constexpr std::size_t longest = 65536;
constexpr int mostDropped = 256; ///< pieces of old input, more than a system keeps

} // namespace

WireLine::WireLine(std::unique_ptr<ByteLink> link, std::shared_ptr<const WireProtocol> protocol, Guard guard)
  : link_(std::move(link)), protocol_(std::move(protocol)), guard_(std::move(guard)), came_(longest)
{
}

std::string WireLine::begin()
{
  this->request_ = this->protocol_->greeting();
  return this->request_.empty() || this->send() ? "" : this->error_;
}

bool WireLine::send()
{
  if (this->link_->send(this->request_))
  {
    return true;
  }
  this->error_ = this->link_->unsent();
  return false;
}

void WireLine::drop() noexcept
{
  this->cameBytes_ = 0;
  if (!this->mayHoldMore_ && !this->link_->looksForFree())
  {
    return;
  }
  for (int i = 0; i<mostDropped&& this->link_->receive(this->came_, 0)> 0; ++i)
  {
  }
}

ArmLine::Answer WireLine::exchange(const WireOrder& order, int timeout_ms)
{
  Answer answer;
  if (!this->guard_.watches())
  {
    this->error_ = "the guard, which ends the force when this program dies, has ended";
    return answer;
  }
  this->drop();
  this->mayHoldMore_ = true;
  this->protocol_->encode(order, this->request_);
  if (this->send())
  {
    answer.said = this->receive(timeout_ms, answer.reading);
  }
  return answer;
}

/// A message may come in pieces; each piece is waited for no longer than is left of the time for the whole.
ArmLine::Said WireLine::receive(int timeout_ms, WireReading& reading)
{
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  for (auto left = std::chrono::milliseconds(timeout_ms); left.count() >= 0;)
  {
    const std::span<std::uint8_t> room = std::span(this->came_).subspan(this->cameBytes_);
    const int count = this->link_->receive(room, static_cast<int>(left.count()));
    if (count < 0)
    {
      this->error_ = this->link_->gone();
      return Said::Gone;
    }
    const Said said = count == 0 ? Said::Nothing : this->take(static_cast<std::size_t>(count), reading);
    if (count == 0 || said != Said::Nothing)
    {
      this->error_ = said == Said::Reading   ? this->error_
                     : this->cameBytes_ == 0 ? "the device does not answer"
                                             : "the device answers with something else than its protocol has";
      return said == Said::Nothing && this->cameBytes_ > 0 ? Said::Nonsense : said;
    }
    left = std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
  }
  this->error_ = "the device does not answer in time";
  return Said::Nothing;
}

/// Nothing: more must come.
ArmLine::Said WireLine::take(std::size_t count, WireReading& reading)
{
  this->cameBytes_ += count;
  const std::span<const std::uint8_t> all(this->came_.data(), this->cameBytes_);
  const WireFrame frame = this->link_->keepsBorders() ? WireFrame{ 0, all.size() } : this->protocol_->frame(all);
  if (frame.length == 0)
  {
    return this->cameBytes_ < this->came_.size() ? Said::Nothing : Said::Nonsense;
  }
  const std::optional<WireReading> read = this->protocol_->decode(all.subspan(frame.skip, frame.length));
  if (!read && this->link_->keepsBorders() && this->protocol_->isOthers(all))
  {
    this->cameBytes_ = 0;
    return Said::Nothing;
  }
  reading = read.value_or(WireReading{});
  this->mayHoldMore_ = !read || frame.skip + frame.length != all.size();
  return read ? Said::Reading : Said::Nonsense;
}

void WireLine::letGo() noexcept
{
  this->protocol_->encode({}, this->request_);
  static_cast<void>(this->link_->send(this->request_));
}

} // namespace palpate
