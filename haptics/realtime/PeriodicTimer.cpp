// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/realtime/PeriodicTimer.h"

#include <cerrno>
#include <ctime>

#include "haptics/core/Clock.h"

namespace palpate
{
namespace
{

constexpr std::int64_t nsPerSecond = 1'000'000'000;

void sleepUntil(std::int64_t time_ns) noexcept
{
  const timespec until{ static_cast<time_t>(time_ns / nsPerSecond), static_cast<long>(time_ns % nsPerSecond) };
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR)
  {
  }
}

/// The period that is due at `now`, and how many whole ones lie between it and the one expected.
Wakeup wakeupAt(std::int64_t now_ns, std::int64_t expected_ns, std::int64_t period_ns) noexcept
{
  const std::int64_t missed = now_ns > expected_ns ? (now_ns - expected_ns) / period_ns : 0;
  const std::int64_t due = expected_ns + missed * period_ns;
  return { due, now_ns - due, static_cast<std::uint64_t>(missed) };
}

} // namespace

PeriodicTimer::PeriodicTimer(std::int64_t period_ns) noexcept : period_ns_(period_ns) {}

std::int64_t PeriodicTimer::now_ns() const noexcept
{
  return MonotonicClock().now_ns();
}

Wakeup PeriodicTimer::wait() noexcept
{
  if (this->next_ns_ == 0)
  {
    this->next_ns_ = this->now_ns() + this->period_ns_;
  }
  sleepUntil(this->next_ns_);
  const Wakeup wakeup = wakeupAt(this->now_ns(), this->next_ns_, this->period_ns_);
  this->next_ns_ = wakeup.due_ns + this->period_ns_;
  return wakeup;
}

Wakeup VirtualTimer::wait() noexcept
{
  this->next_ns_ = this->next_ns_ == 0 ? this->period_ns_ : this->next_ns_;
  this->now_ns_ = this->next_ns_ + this->delay_ns_;
  this->delay_ns_ = 0;
  const Wakeup wakeup = wakeupAt(this->now_ns_, this->next_ns_, this->period_ns_);
  this->next_ns_ = wakeup.due_ns + this->period_ns_;
  return wakeup;
}

} // namespace palpate
