// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

namespace palpate
{

/// Wakes the servo when a device has answered. One thread rings, one waits.
class AnswerBell
{
public:
  using Shared = std::shared_ptr<AnswerBell>;

  void ring()
  {
    {
      const std::lock_guard lock(this->mutex_);
      ++this->rung_;
    }
    this->bell_.notify_one();
  }
  /// Until it has rung since the last call, for that long at most.
  void await(std::chrono::microseconds longest)
  {
    std::unique_lock lock(this->mutex_);
    this->bell_.wait_for(lock, longest, [this] { return this->rung_ != this->heard_; });
    this->heard_ = this->rung_;
  }

private:
  std::mutex mutex_;
  std::condition_variable bell_;
  std::uint64_t rung_ = 0, heard_ = 0;
};

} // namespace palpate
