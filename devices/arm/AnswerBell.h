// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <ctime>
#include <memory>
#include <semaphore.h>

namespace palpate
{

/// Wakes the servo when a device has answered. One thread rings, one waits; neither takes a lock. The system's
/// semaphore sleeps until it is posted, while that of the standard library polls with pauses of up to half of the wait.
class AnswerBell
{
public:
  using Shared = std::shared_ptr<AnswerBell>;

  AnswerBell() noexcept { sem_init(&this->bell_, 0, 0); }
  ~AnswerBell() { sem_destroy(&this->bell_); }
  AnswerBell(const AnswerBell&) = delete;
  AnswerBell& operator=(const AnswerBell&) = delete;

  void ring() noexcept
  {
    if (!this->rung_.exchange(true))
    {
      sem_post(&this->bell_);
    }
  }
  /// Until it has rung since the last call, for that long at most. True: it has.
  bool await(std::chrono::microseconds longest) noexcept
  {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    constexpr long second_ns = 1000000000;
    const long at_ns = until.tv_nsec + std::chrono::nanoseconds(longest).count();
    until.tv_sec += at_ns / second_ns;
    until.tv_nsec = at_ns % second_ns;
    sem_clockwait(&this->bell_, CLOCK_MONOTONIC, &until);
    return this->rung_.exchange(false); // writes before that ring are visible from here on
  }

private:
  sem_t bell_{};
  std::atomic<bool> rung_ = false; ///< and not heard yet
};

} // namespace palpate
